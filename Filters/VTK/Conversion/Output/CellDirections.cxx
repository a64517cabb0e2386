// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Output/CellDirections.h"

#include "Conversion/Input/FieldArrays.h"
#include "Conversion/Input/PolyDataToField.h"
#include "Conversion/Input/PolyDataToSurface.h"

#include <DirectionFields/Distance/ClosestPoints.h>
#include <DirectionFields/Exchange/FaceField.h>
#include <DirectionFields/Interpolation/GivenField.h>

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace DirectionFields
{
namespace
{
constexpr std::array<double, 3> Middle = { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 };

/// Where the direction of each cell is looked up.
struct CellPlaces
{
  /// The place of each triangle.
  std::vector<std::array<double, 3>> Weights;
  /// The triangle of each cell; None for cells without.
  std::vector<Index> Triangle;

  CellPlaces(const TriangulatedPolyData& surface, vtkIdType cells)
    : Weights(surface.Mesh.Triangles.size(), Middle)
    , Triangle(static_cast<std::size_t>(cells), None)
  {
    const std::size_t triangles = surface.Mesh.Triangles.size();
    for (std::size_t first = 0, end = 0; first < triangles; first = end)
    {
      const vtkIdType cell = surface.Cell(first);
      for (end = first + 1; end < triangles && surface.Cell(end) == cell;)
      {
        ++end;
      }
      this->Triangle[static_cast<std::size_t>(cell)] = static_cast<Index>(first);
      if (end - first > 1)
      {
        this->SetPolygon(surface.Mesh, cell, first, end);
      }
    }
  }

private:
  /// Takes the triangle of a polygon that its centroid is in, or is nearest to.
  void SetPolygon(const Surface& mesh, vtkIdType cell, std::size_t first, std::size_t end)
  {
    Surface polygon;
    double largest = 0.0;
    for (std::size_t t = first; t < end; ++t)
    {
      const DirectionFields::Triangle& ids = mesh.Triangles[t];
      for (int c = 1; c < 3; ++c)
      {
        const Vector3 edge = mesh.Points[ids[c]] - mesh.Points[ids[0]];
        largest = std::max(largest, edge.lpNorm<Eigen::Infinity>());
      }
    }
    // A power of two, so that digits stay: areas of large and small polygons have no numbers.
    const double unit = largest > 0.0 ? std::ldexp(1.0, std::min(-std::ilogb(largest), 1000)) : 1.0;
    double area = 0.0;
    Vector3 centroid = Vector3::Zero();
    for (std::size_t t = first; t < end; ++t)
    {
      const auto start = static_cast<Index>(polygon.Points.size());
      for (const Index i : mesh.Triangles[t])
      {
        polygon.Points.push_back(mesh.Points[i]);
      }
      const Vector3* const corner = &polygon.Points[start];
      const double part =
        (unit * (corner[1] - corner[0])).cross(unit * (corner[2] - corner[0])).norm();
      centroid += part * (corner[0] + corner[1] + corner[2]) / 3.0;
      area += part;
      polygon.Triangles.push_back({ start, start + 1, start + 2 });
    }
    const ClosestPoints::Answer found =
      area > 0.0 ? ClosestPoints(polygon).Find(centroid / area) : ClosestPoints::Answer();
    if (found.Triangle != None)
    {
      const std::size_t at = first + static_cast<std::size_t>(found.Triangle);
      this->Triangle[static_cast<std::size_t>(cell)] = static_cast<Index>(at);
      this->Weights[at] = found.Weights;
    }
  }
};

template <typename ArrayT>
void AddArrays(
  const GivenField& field, const FaceField& faces, const CellPlaces& places, vtkPolyData* polyData)
{
  for (int k = 0; k < faces.Degree; ++k)
  {
    const std::vector<Vector3> directions = DirectionsInSpace(field, faces, k);
    std::vector<Vector3> ofCells(places.Triangle.size(), Vector3::Zero());
    for (std::size_t cell = 0; cell < ofCells.size(); ++cell)
    {
      if (places.Triangle[cell] != None)
      {
        ofCells[cell] = directions[static_cast<std::size_t>(places.Triangle[cell])];
      }
    }
    polyData->GetCellData()->AddArray(
      MakeVectors<ArrayT>(ArrayNames::Direction(k).c_str(), ofCells));
  }
}
}

void AddCellDirections(vtkPolyData* polyData)
{
  const TriangulatedPolyData surface = PolyDataToSurface(polyData);
  const PointDirections directions = FindDirections(polyData);
  if (directions.Degree == 0)
  {
    return;
  }
  const GivenField field(surface.Mesh, directions);
  const CellPlaces places(surface, polyData->GetNumberOfCells());
  const FaceField faces = AtPlaces(field, places.Weights);
  if (polyData->GetPoints() && polyData->GetPoints()->GetDataType() == VTK_DOUBLE)
  {
    AddArrays<vtkDoubleArray>(field, faces, places, polyData);
  }
  else
  {
    AddArrays<vtkFloatArray>(field, faces, places, polyData);
  }
  const TriangleMesh& mesh = field.GetMesh();
  const std::vector<int> ofVertices =
    FaceSingularityIndices(field.GetGeometry(), AtCentroids(field));
  std::vector<int> indices(surface.Mesh.Points.size(), 0);
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (mesh.IsFrontVertex(v))
    {
      indices[mesh.Point(v)] += ofVertices[v];
    }
  }
  polyData->GetPointData()->AddArray(
    MakeScalars<vtkIntArray>(ArrayNames::FaceSingularityIndex, indices));
}
}
