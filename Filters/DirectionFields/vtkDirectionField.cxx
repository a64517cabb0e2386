// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDirectionField.h"

#include "DirectionFieldCache.h"
#include "FieldToPolyData.h"
#include "PolyDataToSurface.h"
#include "Support/Threads.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkDirectionField);

namespace
{
// The shares of the phases in the progress: reading the input, solving, writing the arrays.
constexpr double ProgressRead = 0.05;
constexpr double ProgressSolved = 0.9;

/// What NumberOfThreads = 0 stands for.
int DefaultThreads()
{
  if (std::strcmp(vtkSMPTools::GetBackend(), "Sequential") != 0)
  {
    return vtkSMPTools::GetEstimatedNumberOfThreads();
  }
  // VTK's default backend has one thread only, which says nothing about what the user wants.
  const char* most = std::getenv("VTK_SMP_MAX_THREADS");
  const int number = most ? std::atoi(most) : 0;
  return number > 0 ? std::min(number, DirectionFields::Threads::GetDefaultNumber()) : 0;
}

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
  count(repaired.NonOrientableComponents,
    "connected component that cannot be oriented, like a Möbius strip,",
    "connected components that cannot be oriented, like a Möbius strip,",
    "covered on both sides, with a seam in the normals");
  count(repaired.NonManifoldEdges, "edge of more than two triangles",
    "edges of more than two triangles", "split");
  count(repaired.NonManifoldPoints, "point where several sheets meet",
    "points where several sheets meet", "split");
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

/// A point array of a name and a number of components; null where the name is empty or ParaView's
/// "None".
vtkDataArray* FindPointArray(
  vtkPolyData* input, const char* name, int components, const char* property)
{
  const std::string wanted = name ? name : "";
  vtkDataArray* array = input->GetPointData()->GetArray(wanted.c_str());
  if (wanted.empty() || (!array && wanted == "None"))
  {
    return nullptr;
  }
  if (!array || array->GetNumberOfComponents() != components)
  {
    throw std::invalid_argument("There is no point array \"" + wanted + "\" of " +
      std::to_string(components) + (components == 1 ? " component" : " components") +
      ". Choose another for " + property + ".");
  }
  return array;
}

DirectionFields::Guidance MakeGuidance(vtkPolyData* input, const char* vectors, const char* weights)
{
  DirectionFields::Guidance guidance;
  if (vtkDataArray* array = FindPointArray(input, vectors, 3, "GuidanceVectors"))
  {
    guidance.Vectors.resize(static_cast<size_t>(array->GetNumberOfTuples()));
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      array->GetTuple(i, guidance.Vectors[i].data());
    }
  }
  if (vtkDataArray* array = FindPointArray(input, weights, 1, "GuidanceWeights"))
  {
    guidance.Weights.resize(static_cast<size_t>(array->GetNumberOfTuples()));
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      guidance.Weights[i] = array->GetTuple1(i);
    }
  }
  return guidance;
}
}

//------------------------------------------------------------------------------
vtkDirectionField::vtkDirectionField()
  : Last(std::make_unique<DirectionFields::DirectionFieldCache>())
{
  const DirectionFields::Options defaults;
  this->Degree = defaults.Degree;
  this->EnergyBias = defaults.EnergyBias;
  this->Tolerance = defaults.Tolerance;
  this->MaximumIterations = defaults.MaximumIterations;
  this->Solver = static_cast<int>(defaults.Solver);
  this->NumberOfThreads = defaults.NumberOfThreads;
  this->KeepStages = true;
  this->MergePoints = defaults.MergePoints;
  this->IntrinsicDelaunay = defaults.IntrinsicDelaunay;
  this->Alignment = static_cast<int>(defaults.Alignment);
  this->CurvatureDirection = static_cast<int>(defaults.CurvatureDirection);
  this->AlignmentStrength = defaults.AlignmentStrength;
  this->UseShift = defaults.UseShift;
  this->Shift = defaults.Shift;
  this->GuidanceVectors = nullptr;
  this->GuidanceWeights = nullptr;
  this->ConstrainBoundary = defaults.ConstrainBoundary;
  this->ConstrainSharpEdges = defaults.ConstrainSharpEdges;
  this->FeatureAngle = defaults.FeatureAngle;
  this->ConstrainCurvature = defaults.ConstrainCurvature;
  this->CurvatureTolerance = defaults.CurvatureTolerance;
  this->ConsistencyAngle = defaults.ConsistencyAngle;
  this->DropConstraintsAtSingularities = defaults.DropConstraintsAtSingularities;
  this->ConstrainGuidance = defaults.ConstrainGuidance;
  this->ConstraintSolver = static_cast<int>(defaults.ConstraintSolver);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkDirectionField::~vtkDirectionField()
{
  this->SetGuidanceVectors(nullptr);
  this->SetGuidanceWeights(nullptr);
}

//------------------------------------------------------------------------------
void vtkDirectionField::ReleaseStages()
{
  this->Last = std::make_unique<DirectionFields::DirectionFieldCache>();
}

//------------------------------------------------------------------------------
void vtkDirectionField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Degree: " << this->Degree << "\n";
  os << indent << "EnergyBias: " << this->EnergyBias << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "Solver: " << this->Solver << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "KeepStages: " << this->KeepStages << "\n";
  os << indent << "MergePoints: " << this->MergePoints << "\n";
  os << indent << "IntrinsicDelaunay: " << this->IntrinsicDelaunay << "\n";
  os << indent << "Alignment: " << this->Alignment << "\n";
  os << indent << "CurvatureDirection: " << this->CurvatureDirection << "\n";
  os << indent << "AlignmentStrength: " << this->AlignmentStrength << "\n";
  os << indent << "UseShift: " << this->UseShift << "\n";
  os << indent << "Shift: " << this->Shift << "\n";
  os << indent << "GuidanceVectors: " << (this->GuidanceVectors ? this->GuidanceVectors : "(none)")
     << "\n";
  os << indent << "GuidanceWeights: " << (this->GuidanceWeights ? this->GuidanceWeights : "(none)")
     << "\n";
  os << indent << "ConstrainBoundary: " << this->ConstrainBoundary << "\n";
  os << indent << "ConstrainSharpEdges: " << this->ConstrainSharpEdges << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "ConstrainCurvature: " << this->ConstrainCurvature << "\n";
  os << indent << "CurvatureTolerance: " << this->CurvatureTolerance << "\n";
  os << indent << "ConsistencyAngle: " << this->ConsistencyAngle << "\n";
  os << indent << "DropConstraintsAtSingularities: " << this->DropConstraintsAtSingularities
     << "\n";
  os << indent << "ConstrainGuidance: " << this->ConstrainGuidance << "\n";
  os << indent << "ConstraintSolver: " << this->ConstraintSolver << "\n";
}

//------------------------------------------------------------------------------
DirectionFields::Options vtkDirectionField::MakeOptions() const
{
  DirectionFields::Options options;
  options.Degree = this->Degree;
  options.EnergyBias = this->EnergyBias;
  options.Tolerance = this->Tolerance;
  options.MaximumIterations = this->MaximumIterations;
  options.Solver = static_cast<DirectionFields::Solver>(this->Solver);
  options.OthersFollow = this->KeepStages;
  options.NumberOfThreads = this->NumberOfThreads > 0 ? this->NumberOfThreads : DefaultThreads();
  options.MergePoints = this->MergePoints;
  options.IntrinsicDelaunay = this->IntrinsicDelaunay;
  options.Alignment = static_cast<DirectionFields::Alignment>(this->Alignment);
  options.CurvatureDirection =
    static_cast<DirectionFields::CurvatureDirection>(this->CurvatureDirection);
  options.AlignmentStrength = this->AlignmentStrength;
  options.UseShift = this->UseShift;
  options.Shift = this->Shift;
  options.ConstrainBoundary = this->ConstrainBoundary;
  options.ConstrainSharpEdges = this->ConstrainSharpEdges;
  options.FeatureAngle = this->FeatureAngle;
  options.ConstrainCurvature = this->ConstrainCurvature;
  options.CurvatureTolerance = this->CurvatureTolerance;
  options.ConsistencyAngle = this->ConsistencyAngle;
  options.DropConstraintsAtSingularities = this->DropConstraintsAtSingularities;
  options.ConstrainGuidance = this->ConstrainGuidance;
  options.ConstraintSolver =
    static_cast<DirectionFields::ConstraintSolver>(this->ConstraintSolver);
  return options;
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
std::vector<std::string> vtkDirectionField::Warnings(const DirectionFields::Result& field) const
{
  std::vector<std::string> warnings;
  const std::string repairs = Describe(field.Repaired);
  if (!repairs.empty())
  {
    warnings.push_back("The surface was mended for the computation: " + repairs + ".");
  }

  std::string notes;
  for (const std::string& note : field.Notes)
  {
    notes += (notes.empty() ? "" : " ") + note;
  }
  if (!notes.empty())
  {
    warnings.push_back(notes);
  }

  double worst = 0.0;
  double worstSystem = 0.0;
  int unfinished = 0;
  int exhausted = 0;
  int unsolved = 0;
  for (const auto& component : field.Components)
  {
    if (component.Residual > this->Tolerance)
    {
      worst = std::max(worst, component.Residual);
      ++unfinished;
      exhausted += component.Iterations >= this->MaximumIterations;
    }
    if (component.SystemResidual > std::max(1e-8, this->Tolerance))
    {
      worstSystem = std::max(worstSystem, component.SystemResidual);
      ++unsolved;
    }
  }
  if (unsolved > 0)
  {
    std::ostringstream text;
    text << "The aligned or constrained system of " << unsolved << " of "
         << field.Components.size() << " connected components was solved to a relative residual of "
         << worstSystem << " only. "
         << (this->Solver == SOLVER_MULTIGRID ? "Set Solver to Automatic."
                                              : "Remesh the surface more evenly.");
    warnings.push_back(text.str());
  }
  if (unfinished > 0)
  {
    std::ostringstream text;
    text << "The field of " << unfinished << " of " << field.Components.size()
         << " connected components has not converged: the residual is " << worst << ", not "
         << this->Tolerance
         << (exhausted > 0 ? ". Raise MaximumIterations."
               : this->Solver == SOLVER_MULTIGRID
               ? ". Multigrid does not get further here: set Solver to Automatic."
               : ". More iterations would not help: the triangles are of too different sizes or "
                 "shapes, remesh them.");
    warnings.push_back(text.str());
  }
  return warnings;
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

  // Whatever happens below.
  const struct AtEnd
  {
    vtkDirectionField* Self;
    ~AtEnd()
    {
      if (!this->Self->KeepStages)
      {
        this->Self->ReleaseStages();
      }
    }
  } atEnd{ this };

  const auto progressOf = [this](double begin, double end) -> DirectionFields::ProgressFunction
  {
    return [this, begin, end](double done)
    {
      this->UpdateProgress(begin + done * (end - begin));
      return !this->IsAborted();
    };
  };
  const auto giveNothing = [=]
  {
    output->Initialize();
    singularities->Initialize();
  };
  std::string error;
  try
  {
    DirectionFields::Threads threads(this->MakeOptions().NumberOfThreads);
    const DirectionFields::Threads::Scope scope(threads);
    vtkInformation* request = outputVector->GetInformationObject(0);
    std::optional<double> time;
    if (request->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()))
    {
      time = request->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
    }
    else if (input->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
    {
      time = input->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP());
    }
    if (!this->Last->SetInput(input, time, progressOf(0.0, ProgressRead)))
    {
      giveNothing();
      return 1;
    }
    const DirectionFields::TriangulatedPolyData& surface = this->Last->GetSurface();

    DirectionFields::Result field;
    if (surface.Mesh.Triangles.empty())
    {
      field = ZeroField(this->Degree, surface.Mesh.Points.size());
    }
    else
    {
      // Arrays that nothing asks for may be missing.
      DirectionFields::Guidance guidance;
      if (this->Alignment == ALIGN_POINT_VECTORS || this->ConstrainGuidance)
      {
        guidance = MakeGuidance(input, this->GuidanceVectors, this->GuidanceWeights);
      }
      field = this->Last->GetSolver().Compute(
        this->MakeOptions(), guidance, progressOf(ProgressRead, ProgressSolved));
    }
    if (field.Aborted || this->IsAborted())
    {
      giveNothing();
      return 1;
    }

    this->Last->SetField(field);
    const std::vector<std::string> warnings = this->Warnings(field);
    for (const std::string& warning : warnings)
    {
      vtkWarningMacro(<< warning);
    }
    output->ShallowCopy(input);
    if (!DirectionFields::AddFieldArrays(
          surface, field, output, progressOf(ProgressSolved, 1.0)))
    {
      giveNothing();
      return 1;
    }
    DirectionFields::AddReport(field.Repaired, warnings, output->GetFieldData());
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
  giveNothing();
  return 0;
}
