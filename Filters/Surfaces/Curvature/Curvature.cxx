// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curvature/Curvature.h"

#include "Curvature/NoisyShapes.h"
#include "Curvature/Rounding.h"
#include "Curvature/ShapeFit.h"
#include "Curvature/ShapeSmoothing.h"
#include "Features/Creases.h"
#include "Mesh/EnclosedVolume.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// How many times the deviation must be exceeded that errors as large as the largest would lead to.
constexpr double Significant = 4.0;

/// The shape at a vertex as its edges have it.
Shape EdgeShape(const SurfaceGeometry& geometry, const std::vector<double>& dihedralAngles,
  double unit, Index v, std::vector<Index>& fan)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const Metric& metric = geometry.Lengths;
  const std::vector<Vector3>& positions = geometry.Positions;
  mesh.GetFan(v, fan);
  Shape shape;
  double area = 0.0;
  Vector3 laplacian = Vector3::Zero();
  for (const Index h : fan)
  {
    const Index next = TriangleMesh::Next(h);
    const Index previous = TriangleMesh::Previous(h);
    const double out = metric.SquaredLength[mesh.Edge(h)];
    const double across = metric.SquaredLength[mesh.Edge(next)];
    const double back = metric.SquaredLength[mesh.Edge(previous)];
    // Half the cotangents of the corners opposite of the two edges at the vertex.
    const double perArea = 0.125 / metric.Area[h / 3] / unit;
    laplacian +=
      perArea * (across + back - out) * Vector3(positions[mesh.Tail(next)] - positions[v]);
    laplacian +=
      perArea * (out + across - back) * Vector3(positions[mesh.Tail(previous)] - positions[v]);
    area += metric.Area[h / 3] / 3.0;
    const double strength = -0.25 * dihedralAngles[mesh.Edge(h)] * std::sqrt(out);
    shape.Hopf += strength * std::polar(1.0, 2.0 * geometry.Transport.EdgeAngle[h]);
  }
  shape.Hopf /= area;
  laplacian /= area;
  const double outward = laplacian.dot(geometry.Frames.Normal[v]);
  shape.Mean =
    mesh.IsBoundary(v) ? -0.5 * outward : std::copysign(0.5 * laplacian.norm(), -outward);
  return shape;
}

std::vector<Shape> EdgeShapes(
  const SurfaceGeometry& geometry, const std::vector<double>& dihedralAngles)
{
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<Shape> shapes(mesh.GetNumberOfVertices());
  mesh.ForEachComponent(
    [&](Index c)
    {
      const TriangleMesh::Component& component = mesh.GetComponents()[c];
      ParallelFor(component.Vertices(), MediumPiece,
        [&](Index begin, Index end)
        {
          std::vector<Index> fan;
          for (Index v = component.FirstVertex + begin; v < component.FirstVertex + end; ++v)
          {
            shapes[v] = EdgeShape(geometry, dihedralAngles, geometry.Lengths.Unit[c], v, fan);
          }
        });
    });
  return shapes;
}

/// The angle defect at a vertex over its area; 0 on the boundary.
double DefectCurvature(const SurfaceGeometry& geometry, Index v, std::vector<Index>& fan)
{
  if (geometry.Mesh.IsBoundary(v))
  {
    return 0.0;
  }
  geometry.Mesh.GetFan(v, fan);
  double area = 0.0;
  for (const Index h : fan)
  {
    area += geometry.Lengths.Area[h / 3] / 3.0;
  }
  return (2.0 * Pi - 2.0 * Pi / geometry.Transport.Scale[v]) / area;
}

/// The fitted shapes, averaged; there are none on creases.
std::vector<Shape> AveragedShapes(const SurfaceGeometry& geometry,
  const std::vector<double>& dihedralAngles, double rings, const std::vector<Shape>& edges,
  const PieceOfSurface& piece)
{
  Creases creases(geometry, dihedralAngles);
  piece.Complete(creases.Vertex);
  std::vector<Shape> shapes = FitShapes(geometry, creases);
  const std::vector<char> isNoisy = SmoothShapes(geometry, edges, rings, shapes, piece);
  if (piece.Any(std::find(isNoisy.begin(), isNoisy.end(), 1) != isNoisy.end()))
  {
    const std::vector<char> wereOnCreases = creases.Vertex;
    creases.DropSingleEdges(
      geometry.Mesh, isNoisy, [&](std::vector<char>& values) { piece.Complete(values); });
    FitShapesAgain(geometry, creases, wereOnCreases, shapes);
    SmoothNoise(geometry, edges, isNoisy, shapes, piece);
  }
  return shapes;
}

std::vector<WholeComponent> WholesOf(const SurfaceGeometry& geometry)
{
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<WholeComponent> wholes(mesh.GetComponents().size());
  mesh.ForEachComponent(
    [&](Index c)
    {
      wholes[c].IsInsideOut = IsWoundInsideOut(
        mesh, c, geometry.Positions, geometry.Lengths.Unit[c], geometry.Lengths.ComponentArea[c]);
      wholes[c].RoundingError = RoundingError(geometry.Positions, mesh.GetComponents()[c]);
    });
  return wholes;
}
}

Curvature::Curvature(
  const SurfaceGeometry& geometry, const std::vector<double>& dihedralAngles, double rings)
  : Curvature(geometry, dihedralAngles, rings, PieceOfSurface(), WholesOf(geometry))
{
}

Curvature::Curvature(const SurfaceGeometry& geometry, const std::vector<double>& dihedralAngles,
  double rings, const PieceOfSurface& piece, const std::vector<WholeComponent>& wholes)
  : Hopf(geometry.Mesh.GetNumberOfVertices(), 0.0)
  , Mean(geometry.Mesh.GetNumberOfVertices())
  , Gaussian(geometry.Mesh.GetNumberOfVertices())
{
  const TriangleMesh& mesh = geometry.Mesh;
  const std::vector<Shape> edges = EdgeShapes(geometry, dihedralAngles);
  const std::vector<Shape> shapes = AveragedShapes(geometry, dihedralAngles, rings, edges, piece);
  mesh.ForEachComponent(
    [&](Index c)
    {
      const TriangleMesh::Component& component = mesh.GetComponents()[c];
      const double unit = geometry.Lengths.Unit[c];
      const double side = wholes[c].IsInsideOut ? -1.0 : 1.0;
      const double error = Significant * (wholes[c].RoundingError / unit);
      ParallelFor(component.Vertices(), MediumPiece,
        [&](Index begin, Index end)
        {
          std::vector<Index> fan;
          for (Index v = component.FirstVertex + begin; v < component.FirstVertex + end; ++v)
          {
            const bool isFitted = shapes[v].IsFitted();
            const Shape& shape = isFitted ? shapes[v] : edges[v];
            const double square = std::norm(shape.Hopf);
            const bool isRounding = isFitted && square <= error * error * shape.Variance;
            this->Hopf[v] = isRounding ? Complex(0.0) : side * shape.Hopf;
            this->Mean[v] = side * shape.Mean;
            this->Gaussian[v] =
              isFitted ? shape.Mean * shape.Mean - square : DefectCurvature(geometry, v, fan);
          }
        });
    });
  this->IsInsideOut = std::any_of(
    wholes.begin(), wholes.end(), [](const WholeComponent& whole) { return whole.IsInsideOut; });
}
}
