// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGuidanceCurves.h"

#include "Conversion/Input/FieldArrays.h"
#include "Conversion/Input/PolyDataCheck.h"
#include "Conversion/Input/PolyDataToSurface.h"
#include "Conversion/Output/FieldToPolyData.h"
#include "Conversion/Regions/CurveLines.h"
#include "Support/SameSurface.h"

#include <DirectionFields/Guidance/CurveGuidance.h>
#include <DirectionFields/Reports/FieldSummary.h>

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkGuidanceCurves);

namespace
{
using DirectionFields::Curves;

// Where reading the input ends in the progress.
constexpr double ProgressRead = 0.2;

/// The mean length of a surface's edges.
double MeanEdge(const DirectionFields::Surface& surface)
{
  double sum = 0.0;
  for (const DirectionFields::Triangle& triangle : surface.Triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      sum += (surface.Points[triangle[(c + 1) % 3]] - surface.Points[triangle[c]]).stableNorm();
    }
  }
  return sum / std::max(1.0, 3.0 * static_cast<double>(surface.Triangles.size()));
}

/// Draws the curves, and a stroke through each guided point, as long as an edge times its weight.
void AddStrokes(const DirectionFields::Surface& surface, const Curves& curves,
  const DirectionFields::CurveGuidance& guidance, int pointDataType, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(pointDataType == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> kind;
  kind->SetName("Kind");
  // A stroke has three points at most.
  std::size_t places = 3 * guidance.Vectors.size();
  for (const std::vector<DirectionFields::Vector3>& curve : curves)
  {
    places += curve.size();
  }
  DirectionFields::RequireMemoryToGrow((sizeof(double[3]) + 2 * sizeof(vtkIdType) + 1) * places);
  const auto add = [&](const std::vector<DirectionFields::Vector3>& line, unsigned char isStroke)
  {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const DirectionFields::Vector3& place : line)
    {
      cells->InsertCellPoint(points->InsertNextPoint(place.data()));
    }
    kind->InsertNextValue(isStroke);
  };
  for (const std::vector<DirectionFields::Vector3>& curve : curves)
  {
    add(curve, 0);
  }
  const double half = 0.5 * MeanEdge(surface);
  for (std::size_t i = 0; i < guidance.Vectors.size(); ++i)
  {
    if (guidance.Weights[i] > 0.0)
    {
      const DirectionFields::Vector3 arm = half * guidance.Vectors[i];
      add({ surface.Points[i] - arm, surface.Points[i] + arm }, 1);
    }
  }
  output->SetPoints(points);
  output->SetLines(cells);
  output->GetCellData()->AddArray(kind);
}

template <typename ArrayT>
void AddArrays(const DirectionFields::CurveGuidance& guidance, vtkPointData* data)
{
  data->AddArray(DirectionFields::MakeVectors<ArrayT>(
    DirectionFields::ArrayNames::GuidanceVectors, guidance.Vectors));
  data->AddArray(DirectionFields::MakeScalars<ArrayT>(
    DirectionFields::ArrayNames::GuidanceWeights, guidance.Weights));
  if (!guidance.Strengths.empty())
  {
    data->AddArray(DirectionFields::MakeScalars<ArrayT>(
      DirectionFields::ArrayNames::GuidanceStrengths, guidance.Strengths));
  }
}
}

/// The surface of the last input.
struct vtkGuidanceCurves::Kept
{
  explicit Kept(DirectionFields::TriangulatedPolyData&& surface)
    : Surface(std::make_shared<DirectionFields::TriangulatedPolyData>(std::move(surface)))
    , Curves(std::shared_ptr<const DirectionFields::Surface>(this->Surface, &this->Surface->Mesh))
  {
  }
  std::shared_ptr<DirectionFields::TriangulatedPolyData> Surface;
  DirectionFields::SurfaceCurves Curves;
};

//------------------------------------------------------------------------------
vtkGuidanceCurves::vtkGuidanceCurves()
{
  const DirectionFields::CurveGuidanceOptions defaults;
  this->Degree = defaults.Degree;
  this->Radius = defaults.Radius;
  this->Falloff = defaults.Falloff;
  this->MaximumDistance = defaults.MaximumDistance;
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkGuidanceCurves::~vtkGuidanceCurves() = default;

//------------------------------------------------------------------------------
void vtkGuidanceCurves::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Degree: " << this->Degree << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Falloff: " << this->Falloff << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
}

//------------------------------------------------------------------------------
void vtkGuidanceCurves::SetCurvesConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkGuidanceCurves::SetCurvesData(vtkDataObject* curves)
{
  this->SetInputData(1, curves);
}

//------------------------------------------------------------------------------
int vtkGuidanceCurves::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
vtkGuidanceCurves::Kept& vtkGuidanceCurves::Read(
  vtkPolyData* input, const DirectionFields::Progress& progress)
{
  if (!this->Last || !DirectionFields::IsSurfaceOf(input, *this->Last->Surface))
  {
    DirectionFields::TriangulatedPolyData surface =
      DirectionFields::PolyDataToSurface(input, progress);
    if (!this->Last || !DirectionFields::IsSameSurface(surface.Mesh, this->Last->Surface->Mesh))
    {
      // The old one is released before the new one needs memory.
      this->Last.reset();
      this->Last = std::make_unique<Kept>(std::move(surface));
    }
  }
  return *this->Last;
}

//------------------------------------------------------------------------------
void vtkGuidanceCurves::Execute(
  const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress)
{
  auto* const input = vtkPolyData::SafeDownCast(inputs[0]);
  auto* const output = vtkPolyData::SafeDownCast(outputs[0]);
  DirectionFields::CheckPolyData(input);
  if (!inputs[1])
  {
    vtkWarningMacro(<< "Choose the curves that guide a field, such as those of Poly Line Source: "
                       "they are the second input, Curves, in the dialog Change Input.");
    DirectionFields::CopyWithoutReports(input, output);
    Summarize("no curves yet", outputs);
    return;
  }
  const DirectionFields::KeptLines kept = DirectionFields::LinesOf(inputs[1], false);
  const Curves& lines = kept.Curves;
  Kept& last = this->Read(input, progress.Part(0.0, ProgressRead));
  const DirectionFields::Surface& surface = last.Surface->Mesh;
  DirectionFields::CurveGuidanceOptions options;
  options.Degree = this->Degree;
  options.Radius = this->Radius;
  options.Falloff = this->Falloff;
  options.MaximumDistance = this->MaximumDistance;
  options.Strengths = DirectionFields::StrengthsOf(kept);
  const DirectionFields::CurveGuidance guidance =
    last.Curves.Guide(lines, options, progress.Part(ProgressRead, 1.0));
  if (!surface.Triangles.empty() && guidance.Samples == guidance.FarSamples)
  {
    vtkWarningMacro(
      << (guidance.Samples == 0
             ? "The curves have no lines of any length, which could guide a field."
             : "All parts of the curves are farther from the surface than Maximum Distance. Raise it, or set it to 0."));
  }
  DirectionFields::CopyWithoutReports(input, output);
  const int type = input->GetPoints() ? input->GetPoints()->GetDataType() : VTK_FLOAT;
  AddStrokes(surface, lines, guidance, type, vtkPolyData::SafeDownCast(outputs[1]));
  Summarize(DirectionFields::Summary(guidance, lines.size()), outputs);
  if (type == VTK_DOUBLE)
  {
    AddArrays<vtkDoubleArray>(guidance, output->GetPointData());
  }
  else
  {
    AddArrays<vtkFloatArray>(guidance, output->GetPointData());
  }
}
