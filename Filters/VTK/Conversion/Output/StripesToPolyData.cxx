// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Output/StripesToPolyData.h"

#include "Conversion/Input/FieldArrays.h"
#include "Conversion/Output/InterpolatedData.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSignedCharArray.h"
#include "vtkUnsignedCharArray.h"

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace DirectionFields
{
namespace
{
// The numbers of vtkStreamTracer and of the streamlines.
constexpr int EndsAtBoundary = 1;
constexpr int EndsInSingularity = 6;
constexpr int IsClosed = 7;

template <typename ArrayT>
void AddNumber(const char* name, double value, vtkPolyData* output)
{
  auto array = MakeArray<ArrayT>(name, 1, 1);
  array->SetValue(0, static_cast<typename ArrayT::ValueType>(value));
  output->GetFieldData()->AddArray(array);
}

void AddFigures(const StripePattern& pattern, vtkPolyData* output)
{
  AddNumber<vtkDoubleArray>("Spacing", pattern.Spacing, output);
  AddNumber<vtkDoubleArray>("LineOffset", pattern.LineOffset, output);
  AddNumber<vtkDoubleArray>("Misfit", pattern.Misfit, output);
  AddNumber<vtkIntArray>("BranchPoints", pattern.BranchPoints, output);
}

/// The points of the corners of the bands' polygons: shared by polygons, or one for each corner.
struct BandCorners
{
  explicit BandCorners(const StripePattern& pattern)
    : AreShared(pattern.BandPhases.empty())
    , Ids(pattern.BandCorners)
  {
    if (!this->AreShared)
    {
      std::iota(this->Ids.begin(), this->Ids.end(), 0);
    }
  }
  template <typename Value>
  std::vector<Value> Spread(const StripePattern& pattern, const std::vector<Value>& values) const
  {
    if (this->AreShared)
    {
      return values;
    }
    std::vector<Value> spread;
    spread.reserve(pattern.BandCorners.size());
    for (const std::int64_t corner : pattern.BandCorners)
    {
      spread.push_back(values[corner]);
    }
    return spread;
  }

  bool AreShared;
  std::vector<std::int64_t> Ids;
};
}

void AddStripeLines(const StripePattern& pattern, int pointDataType, vtkPolyData* output)
{
  SetPolyLines(pattern.LinePositions, pattern.LineOffsets, pointDataType, output);
  output->GetPointData()->SetNormals(MakeVectors<vtkFloatArray>("Normals", pattern.LineNormals));
  output->GetPointData()->AddArray(MakeScalars<vtkDoubleArray>("ArcLength", pattern.Arc));

  const std::size_t size = pattern.Length.size();
  vtkCellData* data = output->GetCellData();
  data->AddArray(MakeValues<vtkIdTypeArray>("LineId", size, [](std::size_t i) { return i; }));
  data->AddArray(MakeScalars<vtkDoubleArray>("Length", pattern.Length));
  data->AddArray(MakeScalars<vtkUnsignedCharArray>("Closed", pattern.Closed));
  data->AddArray(MakeReasons(size,
    [&](std::size_t i, int end)
    {
      const int open =
        pattern.EndSingularities[i][end] == None ? EndsAtBoundary : EndsInSingularity;
      return pattern.Closed[i] != 0 ? IsClosed : open;
    }));
  data->AddArray(MakeValues<vtkIdTypeArray>(
    "StartNode", size, [&](std::size_t i) { return pattern.EndSingularities[i][0]; }));
  data->AddArray(MakeValues<vtkIdTypeArray>(
    "EndNode", size, [&](std::size_t i) { return pattern.EndSingularities[i][1]; }));
  AddFigures(pattern, output);
}

void AddStripeBands(vtkPolyData* input, const TriangulatedPolyData& surface,
  const StripePattern& pattern, vtkPolyData* output)
{
  const int type = input->GetPoints() ? input->GetPoints()->GetDataType() : VTK_FLOAT;
  const BandCorners corners(pattern);
  output->SetPoints(MakePoints(corners.Spread(pattern, pattern.BandPositions), type));
  vtkNew<vtkCellArray> cells;
  cells->SetData(MakeIds(pattern.BandOffsets), MakeIds(corners.Ids));
  output->SetPolys(cells);

  const std::vector<StripePoint> places = corners.Spread(pattern, pattern.BandPoints);
  InterpolatePointData(
    input, places.size(),
    [&](std::size_t i) { return WeightedPoints(places[i].Points, places[i].Weights); },
    output->GetPointData());
  output->GetPointData()->SetNormals(
    MakeVectors<vtkFloatArray>("Normals", corners.Spread(pattern, pattern.BandNormals)));
  if (!corners.AreShared)
  {
    auto texture = MakeArray<vtkFloatArray>("StripePhase", 2, pattern.BandPhases.size());
    for (std::size_t k = 0; k < pattern.BandPhases.size(); ++k)
    {
      texture->SetTypedComponent(static_cast<vtkIdType>(k), 0, pattern.BandPhases[k]);
      texture->SetTypedComponent(static_cast<vtkIdType>(k), 1, 0.0f);
    }
    output->GetPointData()->SetTCoords(texture);
  }
  CopyCellData(input, surface, pattern.BandTriangle, output->GetCellData());
  output->GetCellData()->AddArray(MakeValues<vtkIdTypeArray>("CellId", pattern.BandTriangle.size(),
    [&](std::size_t f) { return surface.Cell(pattern.BandTriangle[f]); }));
  output->GetCellData()->SetScalars(MakeScalars<vtkSignedCharArray>("Stripe", pattern.Stripe));
  AddFigures(pattern, output);
}

void AddStripeSingularities(const TriangulatedPolyData& surface, const StripePattern& pattern,
  int pointDataType, vtkPolyData* output)
{
  const std::vector<StripeSingularity>& all = pattern.Singularities;
  std::vector<Vector3> positions;
  positions.reserve(all.size());
  for (const StripeSingularity& singularity : all)
  {
    positions.push_back(singularity.Position);
  }
  SetVertices(positions, pointDataType, output);
  vtkPointData* data = output->GetPointData();
  data->SetScalars(MakeValues<vtkIntArray>(
    "StripeIndex", all.size(), [&](std::size_t i) { return all[i].StripeIndex; }));
  data->AddArray(MakeValues<vtkIntArray>(
    "FieldIndex", all.size(), [&](std::size_t i) { return all[i].FieldIndex; }));
  data->AddArray(MakeValues<vtkIdTypeArray>(
    "CellId", all.size(), [&](std::size_t i) { return surface.Cell(all[i].Triangle); }));
  AddFigures(pattern, output);
}
}
