// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGuidanceCurves.h"

#include "Conversion/Input/FieldArrays.h"
#include "Conversion/Input/PolyDataCheck.h"
#include "Conversion/Input/PolyDataToSurface.h"
#include "Conversion/Output/FieldToPolyData.h"
#include "Conversion/Regions/CurveLines.h"
#include "Support/SameSurface.h"

#include <DirectionFields/Guidance/CurveDivision.h>
#include <DirectionFields/Guidance/CurveGuidance.h>
#include <DirectionFields/Reports/FieldSummary.h>

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
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
// Where several surfaces have been told what runs on each of them.
constexpr double ProgressDivided = 0.5;

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

/// The pieces of curves between places that are not finite, where curves were divided.
Curves PiecesOf(const Curves& curves)
{
  Curves pieces;
  for (const std::vector<DirectionFields::Vector3>& curve : curves)
  {
    bool goesOn = false;
    for (const DirectionFields::Vector3& place : curve)
    {
      const bool isPlace = place.allFinite();
      if (isPlace && !goesOn)
      {
        pieces.emplace_back();
      }
      if (isPlace)
      {
        pieces.back().push_back(place);
      }
      goesOn = isPlace;
    }
  }
  return pieces;
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
void AddArraysOf(const DirectionFields::CurveGuidance& guidance, vtkPointData* data)
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

void AddArrays(const DirectionFields::CurveGuidance& guidance, int type, vtkPointData* data)
{
  if (type == VTK_DOUBLE)
  {
    AddArraysOf<vtkDoubleArray>(guidance, data);
  }
  else
  {
    AddArraysOf<vtkFloatArray>(guidance, data);
  }
}

/// Fills the outputs of a surface.
void Fill(const DirectionFields::Surface& surface, const Curves& curves,
  const DirectionFields::CurveGuidance& guidance, vtkPolyData* input, vtkPolyData* output,
  vtkPolyData* strokes)
{
  const int type = input->GetPoints() ? input->GetPoints()->GetDataType() : VTK_FLOAT;
  DirectionFields::CopyWithoutReports(input, output);
  AddStrokes(surface, curves, guidance, type, strokes);
  AddArrays(guidance, type, output->GetPointData());
  const std::string summary = DirectionFields::Summary(guidance, curves.size());
  DirectionFields::AddSummary(summary, output->GetFieldData());
  DirectionFields::AddSummary(summary, strokes->GetFieldData());
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
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
vtkGuidanceCurves::Kept& vtkGuidanceCurves::Read(
  vtkPolyData* input, std::size_t block, const DirectionFields::Progress& progress)
{
  std::unique_ptr<Kept>& last = this->Last[block];
  if (!last || !DirectionFields::IsSurfaceOf(input, *last->Surface))
  {
    DirectionFields::TriangulatedPolyData surface =
      DirectionFields::PolyDataToSurface(input, progress);
    if (!last || !DirectionFields::IsSameSurface(surface.Mesh, last->Surface->Mesh))
    {
      // The old one is released before the new one needs memory.
      last.reset();
      last = std::make_unique<Kept>(std::move(surface));
    }
  }
  return *last;
}

//------------------------------------------------------------------------------
DirectionFields::CurveGuidanceOptions vtkGuidanceCurves::MakeOptions() const
{
  DirectionFields::CurveGuidanceOptions options;
  options.Degree = this->Degree;
  options.Radius = this->Radius;
  options.Falloff = this->Falloff;
  options.MaximumDistance = this->MaximumDistance;
  return options;
}

//------------------------------------------------------------------------------
std::vector<vtkGuidanceCurves::Block> vtkGuidanceCurves::BlocksOf(
  const Ports& inputs, const Ports& outputs)
{
  if (auto* const surface = vtkPolyData::SafeDownCast(inputs[0]))
  {
    return { { 0, surface, vtkPolyData::SafeDownCast(outputs[0]),
      vtkPolyData::SafeDownCast(outputs[1]) } };
  }
  auto* const input = vtkCompositeDataSet::SafeDownCast(inputs[0]);
  for (vtkDataObject* const output : outputs)
  {
    vtkCompositeDataSet::SafeDownCast(output)->CopyStructure(input);
  }
  std::vector<Block> blocks;
  const auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(input->NewIterator());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    vtkDataObject* const data = at->GetCurrentDataObject();
    auto* const surface = vtkPolyData::SafeDownCast(data);
    if (!surface)
    {
      this->Warn({ std::string("Put Extract Surface before this filter: a ") +
        data->GetClassName() + " is no surface, and is left out." });
      continue;
    }
    vtkNew<vtkPolyData> output;
    vtkNew<vtkPolyData> strokes;
    vtkCompositeDataSet::SafeDownCast(outputs[0])->SetDataSet(at, output);
    vtkCompositeDataSet::SafeDownCast(outputs[1])->SetDataSet(at, strokes);
    blocks.push_back({ blocks.size(), surface, output, strokes });
  }
  return blocks;
}

//------------------------------------------------------------------------------
void vtkGuidanceCurves::Execute(
  const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress)
{
  const std::vector<Block> blocks = this->BlocksOf(inputs, outputs);
  for (const Block& block : blocks)
  {
    DirectionFields::CheckPolyData(block.Input);
  }
  if (!inputs[1])
  {
    vtkWarningMacro(<< "Choose the curves that guide a field, such as those of Poly Line Source: "
                       "they are the second input, Curves, in the dialog Change Input.");
    for (const Block& block : blocks)
    {
      DirectionFields::CopyWithoutReports(block.Input, block.Output);
      Summarize("no curves yet", { block.Output, block.Strokes });
    }
    return;
  }
  const DirectionFields::KeptLines kept = DirectionFields::LinesOf(inputs[1], false);
  DirectionFields::CurveGuidanceOptions options = this->MakeOptions();
  options.Strengths = DirectionFields::StrengthsOf(kept);
  const double part = 1.0 / static_cast<double>(std::max<std::size_t>(1, blocks.size()));
  const auto partOf = [&](std::size_t block, double from, double to)
  {
    const double begin = from + (to - from) * part * static_cast<double>(block);
    return progress.Part(begin, begin + (to - from) * part);
  };
  this->Last.resize(blocks.size());
  std::vector<DirectionFields::SurfaceCurves*> surfaces;
  bool anyTriangles = false;
  for (const Block& block : blocks)
  {
    Kept& last = this->Read(block.Input, block.Number, partOf(block.Number, 0.0, ProgressRead));
    surfaces.push_back(&last.Curves);
    anyTriangles = anyTriangles || !last.Surface->Mesh.Triangles.empty();
  }
  std::vector<Curves> divided;
  if (blocks.size() > 1)
  {
    divided = DirectionFields::DivideCurves(
      surfaces, kept.Curves, progress.Part(ProgressRead, ProgressDivided));
  }
  DirectionFields::Index samples = 0;
  DirectionFields::Index farSamples = 0;
  std::vector<Block> unguided;
  for (const Block& block : blocks)
  {
    const Curves& own = divided.empty() ? kept.Curves : divided[block.Number];
    const double begin = divided.empty() ? ProgressRead : ProgressDivided;
    const DirectionFields::CurveGuidance guidance =
      surfaces[block.Number]->Guide(own, options, partOf(block.Number, begin, 1.0));
    samples += guidance.Samples;
    farSamples += guidance.FarSamples;
    if (guidance.Samples == guidance.FarSamples)
    {
      unguided.push_back(block);
    }
    Fill(surfaces[block.Number]->GetSurface(), divided.empty() ? own : PiecesOf(own), guidance,
      block.Input, block.Output, block.Strokes);
  }
  for (const Block& block : samples > farSamples ? unguided : std::vector<Block>())
  {
    vtkNew<vtkIntArray> mark;
    mark->SetName(DirectionFields::ArrayNames::GuidedElsewhere);
    mark->InsertNextValue(1);
    block.Output->GetFieldData()->AddArray(mark);
  }
  if (anyTriangles && samples == farSamples)
  {
    vtkWarningMacro(
      << (samples == 0
             ? "The curves have no lines of any length, which could guide a field."
             : "All parts of the curves are farther from the surface than Maximum Distance. Raise it, or set it to 0."));
  }
}
