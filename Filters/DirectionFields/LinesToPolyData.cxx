// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LinesToPolyData.h"

#include "FieldArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellLocator.h"
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

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace DirectionFields
{
namespace
{
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

void AddCellArrays(const FieldLines& lines, vtkCellData* data)
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

/// The weights of a triangle's corners whose mean is nearest to a place in its plane.
std::array<double, 3> WeightsAt(const Surface& surface, Index triangle, const Vector3& place)
{
  const Triangle& points = surface.Triangles[triangle];
  const Vector3& origin = surface.Points[points[0]];
  const Vector3 a = surface.Points[points[1]] - origin;
  const Vector3 b = surface.Points[points[2]] - origin;
  const Vector3 p = place - origin;
  const double aa = a.squaredNorm();
  const double ab = a.dot(b);
  const double bb = b.squaredNorm();
  const double determinant = aa * bb - ab * ab;
  const double second = (bb * p.dot(a) - ab * p.dot(b)) / determinant;
  const double third = (aa * p.dot(b) - ab * p.dot(a)) / determinant;
  if (!(determinant > 0.0) || !std::isfinite(second) || !std::isfinite(third))
  {
    return { 1.0, 0.0, 0.0 };
  }
  std::array<double, 3> weights = { 1.0 - second - third, second, third };
  double sum = 0.0;
  for (double& weight : weights)
  {
    weight = std::clamp(weight, 0.0, 1.0);
    sum += weight;
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}
}

std::vector<LineSeed> NearestPlaces(const Surface& surface, vtkPointSet* points)
{
  const auto count = static_cast<std::size_t>(points->GetNumberOfPoints());
  std::vector<LineSeed> seeds(count);
  if (count == 0)
  {
    return seeds;
  }
  vtkNew<vtkPolyData> triangles;
  vtkNew<vtkPoints> corners;
  corners->SetDataTypeToDouble();
  for (const Vector3& point : surface.Points)
  {
    // Those that no triangle below uses may be anything.
    const bool isFinite = point.allFinite();
    corners->InsertNextPoint(isFinite ? point.data() : Vector3::Zero().eval().data());
  }
  vtkNew<vtkCellArray> cells;
  std::vector<Index> triangleOfCell;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Triangle& triangle = surface.Triangles[t];
    const bool isSound = std::all_of(
      triangle.begin(), triangle.end(), [&](Index i) { return surface.Points[i].allFinite(); });
    if (isSound)
    {
      cells->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
      triangleOfCell.push_back(static_cast<Index>(t));
    }
  }
  if (triangleOfCell.empty())
  {
    return seeds;
  }
  triangles->SetPoints(corners);
  triangles->SetPolys(cells);
  vtkNew<vtkCellLocator> locator;
  locator->SetDataSet(triangles);
  locator->BuildLocator();
  for (std::size_t i = 0; i < count; ++i)
  {
    Vector3 point;
    points->GetPoint(static_cast<vtkIdType>(i), point.data());
    if (!point.allFinite())
    {
      continue;
    }
    Vector3 closest;
    vtkIdType cell = -1;
    int subId = 0;
    double distance = 0.0;
    locator->FindClosestPoint(point.data(), closest.data(), cell, subId, distance);
    if (cell >= 0)
    {
      const Index triangle = triangleOfCell[static_cast<std::size_t>(cell)];
      seeds[i] = { triangle, WeightsAt(surface, triangle, closest) };
    }
  }
  return seeds;
}

void AddLines(const FieldLines& lines, int pointDataType, vtkPolyData* output)
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

void AddNodes(const FieldLines& lines, int degree, const TriangulatedPolyData& surface,
  int pointDataType, vtkPolyData* output)
{
  const std::vector<LineNode>& nodes = lines.Nodes;
  std::vector<Vector3> positions;
  positions.reserve(nodes.size());
  for (const LineNode& node : nodes)
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
