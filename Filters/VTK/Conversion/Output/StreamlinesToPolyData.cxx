// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Output/StreamlinesToPolyData.h"

#include "Conversion/Input/FieldArrays.h"

#include <DirectionFields/Distance/ClosestPoints.h>
#include <DirectionFields/Support/Threads.h>

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <cstddef>
#include <numeric>
#include <vector>

namespace DirectionFields
{
namespace
{
constexpr Index FewPoints = 64;

/// An array of one component with the values that a function gives.
template <typename ArrayT, typename Value>
vtkNew<ArrayT> MakeValues(const char* name, std::size_t size, const Value& value)
{
  auto array = MakeArray<ArrayT>(name, 1, size);
  for (std::size_t i = 0; i < size; ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), static_cast<typename ArrayT::ValueType>(value(i)));
  }
  return array;
}

void AddSpacing(double spacing, vtkPolyData* output)
{
  output->GetFieldData()->AddArray(MakeValues<vtkDoubleArray>(
    "SeparatingDistance", 1, [spacing](std::size_t) { return spacing; }));
}

void AddCellArrays(const Streamlines& lines, vtkCellData* data)
{
  const std::size_t size = lines.Length.size();
  data->AddArray(
    MakeValues<vtkIdTypeArray>("SeedIds", size, [&](std::size_t i) { return lines.Seed[i]; }));
  data->AddArray(
    MakeValues<vtkIntArray>("Family", size, [&](std::size_t i) { return lines.Family[i]; }));
  data->AddArray(
    MakeValues<vtkDoubleArray>("Length", size, [&](std::size_t i) { return lines.Length[i]; }));
  data->AddArray(MakeValues<vtkUnsignedCharArray>(
    "Closed", size, [&](std::size_t i) { return lines.Closed[i]; }));
  auto reason = MakeArray<vtkIntArray>("ReasonForTermination", 2, size);
  reason->SetComponentName(0, "Start");
  reason->SetComponentName(1, "End");
  for (std::size_t i = 0; i < size; ++i)
  {
    for (int e = 0; e < 2; ++e)
    {
      reason->SetTypedComponent(static_cast<vtkIdType>(i), e, static_cast<int>(lines.Ends[i][e]));
    }
  }
  data->AddArray(reason);
  data->AddArray(MakeValues<vtkIdTypeArray>(
    "StartNode", size, [&](std::size_t i) { return lines.EndNodes[i][0]; }));
  data->AddArray(MakeValues<vtkIdTypeArray>(
    "EndNode", size, [&](std::size_t i) { return lines.EndNodes[i][1]; }));
}
}

std::vector<StreamlineSeed> NearestPlaces(const Surface& surface, vtkPointSet* points)
{
  const auto count = static_cast<Index>(points->GetNumberOfPoints());
  std::vector<StreamlineSeed> seeds(count);
  if (count == 0)
  {
    return seeds;
  }
  std::vector<Vector3> places(count);
  for (Index i = 0; i < count; ++i)
  {
    points->GetPoint(i, places[i].data());
  }
  const ClosestPoints nearest(surface);
  ParallelFor(count, FewPoints,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        if (places[i].allFinite())
        {
          const auto found = nearest.Find(places[i]);
          seeds[i] = { found.Triangle, found.Weights };
        }
      }
    });
  return seeds;
}

void AddLines(const Streamlines& lines, int pointDataType, vtkPolyData* output)
{
  output->SetPoints(MakePoints(lines.Points, pointDataType));
  std::vector<std::int64_t> connectivity(lines.Points.size());
  std::iota(connectivity.begin(), connectivity.end(), 0);
  vtkNew<vtkCellArray> cells;
  cells->SetData(MakeIds(lines.Offsets), MakeIds(connectivity));
  output->SetLines(cells);

  vtkPointData* data = output->GetPointData();
  data->SetNormals(MakeVectors<vtkFloatArray>("Normals", lines.Normals));
  data->SetVectors(MakeVectors<vtkFloatArray>("Direction", lines.Directions));
  data->AddArray(MakeScalars<vtkDoubleArray>("ArcLength", lines.Arc));
  data->AddArray(MakeScalars<vtkFloatArray>(ArrayNames::RepresentationMagnitude, lines.Magnitude));
  data->AddArray(MakeValues<vtkIdTypeArray>(
    "PointId", lines.Point.size(), [&](std::size_t i) { return lines.Point[i]; }));
  data->AddArray(MakeScalars<vtkIntArray>("Branch", lines.Branch));
  AddCellArrays(lines, output->GetCellData());
  AddSpacing(lines.Spacing, output);
}

void AddNodes(const Streamlines& lines, int degree, const TriangulatedPolyData& surface,
  int pointDataType, vtkPolyData* output)
{
  const std::vector<StreamlineNode>& nodes = lines.Nodes;
  std::vector<Vector3> positions;
  positions.reserve(nodes.size());
  for (const StreamlineNode& node : nodes)
  {
    positions.push_back(node.Position);
  }
  output->SetPoints(MakePoints(positions, pointDataType));
  vtkNew<vtkCellArray> cells;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    cells->InsertNextCell({ static_cast<vtkIdType>(i) });
  }
  output->SetVerts(cells);
  vtkPointData* data = output->GetPointData();
  data->AddArray(MakeValues<vtkUnsignedCharArray>(
    "NodeType", nodes.size(), [&](std::size_t i) { return nodes[i].Type; }));
  data->AddArray(MakeValues<vtkIntArray>(ArrayNames::SingularityIndex, nodes.size(),
    [&](std::size_t i) { return nodes[i].SingularityIndex; }));
  data->AddArray(MakeValues<vtkFloatArray>("Index", nodes.size(),
    [&](std::size_t i) { return static_cast<double>(nodes[i].SingularityIndex) / degree; }));
  data->AddArray(MakeValues<vtkIdTypeArray>(
    "CellId", nodes.size(), [&](std::size_t i) { return surface.Cell(nodes[i].Triangle); }));
  AddSpacing(lines.Spacing, output);
}
}
