// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CliffMeshes.h"

#include "BenchmarkMeshes.h"
#include "Meshes/PolyData.h"
#include "Meshes/Surfaces.h"

#include "vtkCellArray.h"
#include "vtkContourFilter.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <vector>

using DirectionFields::Index;
using DirectionFields::Pi;
using DirectionFields::Surface;
using DirectionFields::Vector3;

namespace BenchmarkMeshes
{
namespace
{
constexpr unsigned Seed = 1;

/// The triangles where a function of the unit cube is zero.
vtkSmartPointer<vtkPolyData> Isosurface(
  int cells, const std::function<double(const Vector3&)>& function)
{
  vtkNew<vtkFloatArray> values;
  for (int k = 0; k <= cells; ++k)
  {
    for (int j = 0; j <= cells; ++j)
    {
      for (int i = 0; i <= cells; ++i)
      {
        values->InsertNextValue(static_cast<float>(function(Vector3(i, j, k) / cells)));
      }
    }
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(cells + 1, cells + 1, cells + 1);
  image->SetSpacing(1.0 / cells, 1.0 / cells, 1.0 / cells);
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(contour->GetOutput()->GetPoints());
  mesh->SetPolys(contour->GetOutput()->GetPolys());
  return mesh;
}

/// The surface of area 2.4 a period's square, of 1.6 triangles a cell's square or so.
vtkSmartPointer<vtkPolyData> Gyroid(int triangles, double periods)
{
  const double perCell = 5.3 * periods;
  const int cells =
    std::max(4, static_cast<int>(std::lround(std::sqrt(0.5 * triangles / perCell))));
  return Isosurface(cells,
    [&](const Vector3& p)
    {
      const Vector3 x = 2.0 * Pi * periods * p;
      return std::sin(x.x()) * std::cos(x.y()) + std::sin(x.y()) * std::cos(x.z()) +
        std::sin(x.z()) * std::cos(x.x());
    });
}

/// Spheres, one in each cell of a lattice, of pseudo-random radius and place.
vtkSmartPointer<vtkPolyData> Blobs(int triangles, double components)
{
  const int across = std::max(1, static_cast<int>(std::lround(std::cbrt(components))));
  std::mt19937 engine(Seed);
  const auto random = [&] { return engine() / 4294967296.0; };
  struct Ball
  {
    Vector3 Center;
    double Radius;
  };
  std::vector<Ball> balls;
  double area = 0.0;
  for (int ball = 0; ball < across * across * across; ++ball)
  {
    const Vector3 cell(ball % across, ball / across % across, ball / across / across);
    const double radius = 0.15 + 0.3 * random();
    const double room = 0.5 - radius;
    const Vector3 shift(random(), random(), random());
    balls.push_back(
      { (cell + Vector3::Constant(0.5) + 1.6 * room * (shift - Vector3::Constant(0.5))) / across,
        radius / across });
    area += 4.0 * Pi * balls.back().Radius * balls.back().Radius;
  }
  const int cells =
    std::max(4 * across, static_cast<int>(std::lround(std::sqrt(triangles / (3.0 * area)))));
  return Isosurface(cells,
    [&](const Vector3& p)
    {
      const Vector3 at = (across * p).cwiseMin(across - 0.5);
      const int ball = static_cast<int>(at.x()) +
        across * (static_cast<int>(at.y()) + across * static_cast<int>(at.z()));
      return (p - balls[ball].Center).norm() - balls[ball].Radius;
    });
}

Surface Flat(int triangles)
{
  return Meshes::Square(std::max(2, static_cast<int>(std::lround(std::sqrt(triangles / 2.0)))));
}

Surface Terrain(int triangles, double noise)
{
  Surface surface = Meshes::Roughened(Flat(triangles), noise, Seed);
  for (Vector3& p : surface.Points)
  {
    p.z() += 0.05 * std::sin(9.0 * p.x() + 2.0 * p.y()) * std::cos(7.0 * p.y() - p.x());
  }
  return surface;
}

/// A star in a plane.
vtkSmartPointer<vtkPolyData> StarPolygon(int corners)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell(corners);
  for (int k = 0; k < corners; ++k)
  {
    const double angle = 2.0 * Pi * k / corners;
    const double radius = 1.0 + 0.2 * std::sin(31.0 * angle) + 0.1 * std::sin(7.0 * angle);
    polys->InsertCellPoint(
      points->InsertNextPoint(radius * std::cos(angle), radius * std::sin(angle), 0.0));
  }
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return mesh;
}

Surface EvenTorus(int triangles)
{
  const int across = std::max(6, static_cast<int>(std::lround(std::sqrt(triangles / 5.0))));
  return Meshes::Torus(5 * across / 2, across);
}

Surface Strip(int triangles, double width)
{
  const int across = std::max(1, static_cast<int>(width));
  const int along = std::max(1, triangles / (2 * across));
  Surface surface;
  for (int i = 0; i <= along; ++i)
  {
    for (int j = 0; j <= across; ++j)
    {
      surface.Points.emplace_back(i, j, 0.0);
    }
  }
  for (Index i = 0; i < along; ++i)
  {
    for (Index j = 0; j < across; ++j)
    {
      const Index a = i * (across + 1) + j;
      const Index b = a + across + 1;
      surface.Triangles.push_back({ a, b, b + 1 });
      surface.Triangles.push_back({ a, b + 1, a + 1 });
    }
  }
  return surface;
}

/// A square with round holes in rows, as CAD programs write it: there is no point but on its edges.
Surface Holes(int triangles, double holes)
{
  const int rows = std::max(1, static_cast<int>(std::lround(std::sqrt(holes))));
  // Each hole has as many triangles as points, and one for each side of its cell.
  const int quarter = std::max(1, (triangles / (rows * rows) - 4) / 4);
  Surface surface;
  for (Index j = 0; j <= rows; ++j)
  {
    for (Index i = 0; i <= rows; ++i)
    {
      surface.Points.emplace_back(i, j, 0.0);
    }
  }
  for (Index cell = 0; cell < rows * rows; ++cell)
  {
    const Index corner = cell / rows * (rows + 1) + cell % rows;
    const std::array<Index, 4> corners = { corner, corner + 1, corner + rows + 2,
      corner + rows + 1 };
    const auto first = static_cast<Index>(surface.Points.size());
    const Vector3 middle = surface.Points[corner] + Vector3(0.5, 0.5, 0.0);
    for (int k = 0; k < 4 * quarter; ++k)
    {
      const double angle = 0.5 * Pi * k / quarter - Pi;
      surface.Points.push_back(middle + 0.3 * Vector3(std::cos(angle), std::sin(angle), 0.0));
    }
    for (int side = 0; side < 4; ++side)
    {
      const auto rim = [&](int k) { return first + (side * quarter + k) % (4 * quarter); };
      surface.Triangles.push_back({ corners[side], corners[(side + 1) % 4], rim(quarter) });
      for (int k = 0; k < quarter; ++k)
      {
        surface.Triangles.push_back({ corners[side], rim(k + 1), rim(k) });
      }
    }
  }
  return surface;
}

vtkSmartPointer<vtkPolyData> AsFloats(const Surface& surface)
{
  return Meshes::ToPolyData(surface, VTK_FLOAT);
}
}

vtkSmartPointer<vtkPolyData> MakeCliff(const std::string& name)
{
  using Maker = vtkSmartPointer<vtkPolyData> (*)(int, double);
  static const std::map<std::string, Maker> makers = {
    { "noisy",
      [](int n, double x)
      { return AsFloats(Meshes::Roughened(Meshes::ToSurface(Potato(n)), x, Seed)); } },
    { "terrain", [](int n, double x) { return AsFloats(Terrain(n, x)); } },
    { "noisytorus",
      [](int n, double x) { return AsFloats(Meshes::Roughened(EvenTorus(n), x, Seed)); } },
    { "gyroid", [](int n, double x) { return Gyroid(n, x > 0.0 ? x : 2.0); } },
    { "sphere", [](int n, double) { return Sphere(n); } },
    { "flat", [](int n, double) { return AsFloats(Flat(n)); } },
    { "strip", [](int n, double x) { return AsFloats(Strip(n, x)); } },
    { "blobs", [](int n, double x) { return Blobs(n, x > 0.0 ? x : 512.0); } },
    { "holes", [](int n, double x) { return AsFloats(Holes(n, x)); } },
    { "polygon", [](int n, double) { return StarPolygon(n + 2); } },
  };
  const std::size_t colon = name.find(':');
  const auto maker = makers.find(name.substr(0, colon));
  if (colon == std::string::npos || maker == makers.end())
  {
    return nullptr;
  }
  const std::string figures = name.substr(colon + 1);
  const std::size_t second = figures.find(':');
  const double amount = second == std::string::npos ? 0.0 : std::stod(figures.substr(second + 1));
  return maker->second(std::stoi(figures), amount);
}
}
