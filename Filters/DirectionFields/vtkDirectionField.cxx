// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDirectionField.h"

#include "FieldToPolyData.h"
#include "PolyDataToSurface.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <exception>
#include <new>
#include <sstream>
#include <string>

vtkStandardNewMacro(vtkDirectionField);

namespace
{
// The shares of the phases in the progress: reading the input, solving, writing the arrays.
constexpr double ProgressRead = 0.05;
constexpr double ProgressSolved = 0.9;

/// What was mended in the input, for the user; empty if nothing was.
std::string Describe(const DirectionFields::Repairs& repaired)
{
  std::ostringstream text;
  const auto count = [&text](DirectionFields::Index number, const char* one, const char* many,
                       const char* remedy)
  {
    if (number > 0)
    {
      text << (text.tellp() > 0 ? "; " : "") << number << ' ' << (number == 1 ? one : many) << ' '
           << remedy;
    }
  };
  count(repaired.ReversedTriangles, "triangle wound against the majority",
    "triangles wound against the majority", "turned");
  count(repaired.DuplicateTriangles, "duplicate triangle", "duplicate triangles", "ignored");
  count(repaired.CollapsedTriangles, "triangle with a repeated corner",
    "triangles with a repeated corner", "ignored");
  count(repaired.DegenerateTriangles, "triangle without area", "triangles without area",
    "given a little area");
  return text.str();
}

/// The field where there is no triangle: zero at every point.
DirectionFields::Result ZeroField(int degree, size_t points)
{
  DirectionFields::Result field;
  field.Degree = degree;
  field.Representation.assign(points, DirectionFields::Complex(0.0));
  field.Normal.assign(points, DirectionFields::Vector3::Zero());
  field.XAxis.assign(points, DirectionFields::Vector3::Zero());
  return field;
}
}

//------------------------------------------------------------------------------
vtkDirectionField::vtkDirectionField()
{
  const DirectionFields::Options defaults;
  this->Degree = defaults.Degree;
  this->EnergyBias = defaults.EnergyBias;
  this->Tolerance = defaults.Tolerance;
  this->MaximumIterations = defaults.MaximumIterations;
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkDirectionField::~vtkDirectionField() = default;

//------------------------------------------------------------------------------
void vtkDirectionField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Degree: " << this->Degree << "\n";
  os << indent << "EnergyBias: " << this->EnergyBias << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
}

//------------------------------------------------------------------------------
bool vtkDirectionField::IsAborted()
{
#ifdef DIRECTIONFIELDS_VTK_HAS_CHECKABORT
  // CheckAbort notices a flag that was set with a time stamp only; the flag itself always counts.
  return this->GetAbortExecute() || this->CheckAbort();
#else
  return this->GetAbortExecute() != 0;
#endif
}

//------------------------------------------------------------------------------
void vtkDirectionField::Warn(const DirectionFields::Result& field)
{
  const std::string repairs = Describe(field.Repaired);
  if (!repairs.empty())
  {
    vtkWarningMacro("The surface was mended for the computation: " << repairs << ".");
  }

  double worst = 0.0;
  int unfinished = 0;
  for (const auto& component : field.Components)
  {
    if (!component.Converged)
    {
      worst = std::max(worst, component.Residual);
      ++unfinished;
    }
  }
  if (unfinished > 0)
  {
    vtkWarningMacro("The field of " << unfinished << " of " << field.Components.size()
                                    << " connected components has not converged: after "
                                    << this->MaximumIterations << " iterations the residual is "
                                    << worst << ", not " << this->Tolerance
                                    << ". Raise MaximumIterations.");
  }
}

//------------------------------------------------------------------------------
int vtkDirectionField::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* singularities = vtkPolyData::GetData(outputVector, 1);
  if (!input || !output || !singularities)
  {
    return 0;
  }

  std::string error;
  try
  {
    const auto surface = DirectionFields::PolyDataToSurface(input);
    this->UpdateProgress(ProgressRead);

    DirectionFields::Result field;
    if (surface.Mesh.Triangles.empty())
    {
      field = ZeroField(this->Degree, surface.Mesh.Points.size());
    }
    else
    {
      DirectionFields::Options options;
      options.Degree = this->Degree;
      options.EnergyBias = this->EnergyBias;
      options.Tolerance = this->Tolerance;
      options.MaximumIterations = this->MaximumIterations;
      field = DirectionFields::DirectionField(surface.Mesh)
                .Compute(options,
                  [this](double done)
                  {
                    this->UpdateProgress(ProgressRead + done * (ProgressSolved - ProgressRead));
                    return !this->IsAborted();
                  });
    }
    this->UpdateProgress(ProgressSolved);
    if (field.Aborted || this->IsAborted())
    {
      output->Initialize();
      singularities->Initialize();
      return 1;
    }

    this->Warn(field);
    output->ShallowCopy(input);
    DirectionFields::AddFieldArrays(surface, field, output);
    DirectionFields::MakeSingularities(
      surface, field, input->GetPoints() ? input->GetPoints()->GetDataType() : VTK_FLOAT,
      singularities);
    this->UpdateProgress(1.0);
    return 1;
  }
  catch (const std::bad_alloc&)
  {
    error = "Out of memory. Decimate the surface or process it in parts.";
  }
  catch (const std::exception& exception)
  {
    error = exception.what();
  }
  vtkErrorMacro(<< error);
  output->Initialize();
  singularities->Initialize();
  return 0;
}
