// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Small surfaces for the tests, made here so that no version of VTK changes them.

#ifndef PolyMeshes_h
#define PolyMeshes_h

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <utility>
#include <vector>

namespace PolyMeshes
{
using Mesh = vtkSmartPointer<vtkPolyData>;
using Point = std::array<double, 3>;
using Cells = std::vector<std::vector<vtkIdType>>;

constexpr double Pi = 3.14159265358979323846;

inline Mesh Make(
  const std::vector<Point>& points, const Cells& polygons, int precision = VTK_DOUBLE)
{
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataType(precision);
  for (const Point& point : points)
  {
    coordinates->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  auto mesh = Mesh::New();
  mesh->SetPoints(coordinates);
  mesh->SetPolys(cells);
  return mesh;
}

/// Unit icosahedron, each triangle split into four `levels` times: 10 4^levels + 2 points.
inline Mesh Icosphere(int levels, int precision = VTK_DOUBLE)
{
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  std::vector<Point> points = { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 },
    { 0, -1, g }, { 0, 1, g }, { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 },
    { -g, 0, -1 }, { -g, 0, 1 } };
  Cells triangles = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 },
    { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 },
    { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 },
    { 9, 8, 1 } };
  for (int level = 0; level < levels; ++level)
  {
    std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> middles;
    const auto middle = [&](vtkIdType a, vtkIdType b)
    {
      const auto [entry, isNew] = middles.try_emplace(
        { std::min(a, b), std::max(a, b) }, static_cast<vtkIdType>(points.size()));
      if (isNew)
      {
        Point point;
        for (int c = 0; c < 3; ++c)
        {
          point[c] = (points[a][c] + points[b][c]) / 2.0;
        }
        points.push_back(point);
      }
      return entry->second;
    };
    Cells finer;
    for (const auto& t : triangles)
    {
      const vtkIdType a = middle(t[0], t[1]);
      const vtkIdType b = middle(t[1], t[2]);
      const vtkIdType c = middle(t[2], t[0]);
      finer.insert(finer.end(), { { t[0], a, c }, { t[1], b, a }, { t[2], c, b }, { a, b, c } });
    }
    triangles = std::move(finer);
  }
  for (Point& point : points)
  {
    const double length =
      std::sqrt(point[0] * point[0] + point[1] * point[1] + point[2] * point[2]);
    for (double& coordinate : point)
    {
      coordinate /= length;
    }
  }
  return Make(points, triangles, precision);
}

/// A sphere without the symmetry that leaves a choice between several optimal fields.
inline Mesh Pebble(int levels, int precision = VTK_DOUBLE)
{
  auto mesh = Icosphere(levels, precision);
  vtkPoints* points = mesh->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    const double bulge = 1.0 + 0.15 * p[0] + 0.1 * p[1] * p[2] - 0.1 * p[2];
    points->SetPoint(i, 1.1 * bulge * p[0], 0.8 * bulge * p[1], 0.95 * bulge * p[2]);
  }
  return mesh;
}

/// Quads of a torus with an elliptic cross-section about the z axis.
inline Mesh QuadTorus(int around, int across)
{
  std::vector<Point> points;
  Cells quads;
  for (int i = 0; i < around; ++i)
  {
    const double u = 2.0 * Pi * i / around;
    for (int j = 0; j < across; ++j)
    {
      const double v = 2.0 * Pi * j / across;
      const double radius = 1.0 + 0.4 * std::cos(v);
      points.push_back({ 1.15 * radius * std::cos(u), radius * std::sin(u), 0.35 * std::sin(v) });
      const int nextI = (i + 1) % around;
      const int nextJ = (j + 1) % across;
      quads.push_back(
        { i * across + j, nextI * across + j, nextI * across + nextJ, i * across + nextJ });
    }
  }
  return Make(points, quads);
}

/// The surface of the unit cube.
inline Mesh QuadCube()
{
  return Make({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
                { 1, 1, 1 }, { 0, 1, 1 } },
    { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 },
      { 3, 0, 4, 7 } });
}

/// A flat square of n by n squares, two triangles each.
inline Mesh Square(int n)
{
  std::vector<Point> points;
  Cells triangles;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      points.push_back({ 1.0 * i / n, 1.0 * j / n, 0.0 });
      if (i < n && j < n)
      {
        const vtkIdType a = j * (n + 1) + i;
        const vtkIdType b = a + n + 1;
        triangles.push_back({ a, a + 1, b + 1 });
        triangles.push_back({ a, b + 1, b });
      }
    }
  }
  return Make(points, triangles);
}

/// A strip of triangles closed with a half turn.
inline Mesh Moebius(int segments)
{
  std::vector<Point> points;
  Cells triangles;
  for (int i = 0; i < segments; ++i)
  {
    const double u = 2.0 * Pi * i / segments;
    for (const double side : { -0.3, 0.3 })
    {
      const double radius = 1.0 + side * std::cos(u / 2.0);
      points.push_back({ radius * std::cos(u), radius * std::sin(u), side * std::sin(u / 2.0) });
    }
    const vtkIdType a = 2 * i;
    const bool last = i + 1 == segments;
    const vtkIdType c = last ? 1 : a + 2;
    const vtkIdType d = last ? 0 : a + 3;
    triangles.push_back({ a, c, a + 1 });
    triangles.push_back({ a + 1, c, d });
  }
  return Make(points, triangles);
}

/// Both surfaces in one, the second moved along x.
inline Mesh BesideEachOther(vtkPolyData* first, vtkPolyData* second, double distance)
{
  std::vector<Point> points;
  Cells polygons;
  for (vtkPolyData* mesh : { first, second })
  {
    const vtkIdType offset = static_cast<vtkIdType>(points.size());
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      Point point;
      mesh->GetPoint(i, point.data());
      point[0] += offset > 0 ? distance : 0.0;
      points.push_back(point);
    }
    vtkNew<vtkIdList> ids;
    for (vtkIdType i = 0; i < mesh->GetPolys()->GetNumberOfCells(); ++i)
    {
      mesh->GetPolys()->GetCellAtId(i, ids);
      polygons.emplace_back();
      for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
      {
        polygons.back().push_back(ids->GetId(k) + offset);
      }
    }
  }
  return Make(points, polygons);
}
}

#endif
