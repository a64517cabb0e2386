// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Output/StreamlinesToPolyData.h"

#include "Conversion/Input/FieldArrays.h"
#include "Conversion/Tensors/TensorArrays.h"

#include <DirectionFields/Distance/ClosestPoints.h>
#include <DirectionFields/Support/Threads.h>

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
#include <vector>

namespace DirectionFields
{
namespace
{
constexpr Index FewPoints = 64;

void AddSpacing(double spacing, vtkPolyData* output)
{
  output->GetFieldData()->AddArray(MakeValues<vtkDoubleArray>(
    "SeparatingDistance", 1, [spacing](std::size_t) { return spacing; }));
}

void AddCellArrays(const Streamlines& lines, bool diagnostics, vtkCellData* data)
{
  const std::size_t size = lines.Length.size();
  data->AddArray(
    MakeValues<vtkDoubleArray>("Length", size, [&](std::size_t i) { return lines.Length[i]; }));
  if (!diagnostics)
  {
    return;
  }
  data->AddArray(
    MakeValues<vtkIdTypeArray>("SeedIds", size, [&](std::size_t i) { return lines.Seed[i]; }));
  data->AddArray(
    MakeValues<vtkIntArray>("Family", size, [&](std::size_t i) { return lines.Family[i]; }));
  data->AddArray(MakeValues<vtkUnsignedCharArray>(
    "Closed", size, [&](std::size_t i) { return lines.Closed[i]; }));
  data->AddArray(MakeReasons(
    size, [&](std::size_t i, int end) { return static_cast<int>(lines.Ends[i][end]); }));
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

void AddLines(const Streamlines& lines, int pointDataType, bool diagnostics, vtkPolyData* output)
{
  SetPolyLines(lines.Points, lines.Offsets, pointDataType, output);
  vtkPointData* data = output->GetPointData();
  data->SetNormals(MakeVectors<vtkFloatArray>("Normals", lines.Normals));
  data->SetVectors(MakeVectors<vtkFloatArray>("Direction", lines.Directions));
  data->AddArray(MakeScalars<vtkDoubleArray>("ArcLength", lines.Arc));
  if (diagnostics)
  {
    data->AddArray(
      MakeScalars<vtkFloatArray>(ArrayNames::RepresentationMagnitude, lines.Magnitude));
    data->AddArray(MakeValues<vtkIdTypeArray>(
      "PointId", lines.Point.size(), [&](std::size_t i) { return lines.Point[i]; }));
    data->AddArray(MakeScalars<vtkIntArray>("Branch", lines.Branch));
  }
  AddCellArrays(lines, diagnostics, output->GetCellData());
  AddSpacing(lines.Spacing, output);
}

void AddTensorValues(const Streamlines& lines, const TriangulatedPolyData& surface,
  vtkPolyData* field, vtkPolyData* output)
{
  const TensorsAlong tensors(field);
  if (!tensors.AreThere())
  {
    return;
  }
  output->GetPointData()->AddArray(
    MakeValues<vtkFloatArray>(ArrayNames::PrincipalValue, lines.Triangle.size(),
      [&](std::size_t i)
      {
        const Triangle& corners = surface.Mesh.Triangles[lines.Triangle[i]];
        double value = 0.0;
        for (int c = 0; c < 3; ++c)
        {
          value += lines.Weights[i][c] * tensors.At(corners[c], lines.Directions[i]);
        }
        return value;
      }));
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
  SetVertices(positions, pointDataType, output);
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
