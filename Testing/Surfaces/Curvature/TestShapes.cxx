// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curvature/Curvature.h"
#include "Curvature/ShapeFit.h"
#include "Curvature/ShapeSmoothing.h"
#include "Features/Creases.h"
#include "Geometry/DihedralAngles.h"
#include "Meshes/DenseAlgebra.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

using namespace DirectionFields;
using namespace DirectionFields::Internal;
using namespace Meshes;

namespace
{
Creases CreasesOf(const SurfaceGeometry& geometry)
{
  return Creases(geometry, DihedralAngles(geometry));
}

Index Creased(const Surface& surface)
{
  const SurfaceGeometry geometry(surface);
  const Creases creases = CreasesOf(geometry);
  return static_cast<Index>(std::count(creases.Edge.begin(), creases.Edge.end(), 1));
}

/// The first edge of a component both of whose ends are inside of it.
Index InnerEdge(const TriangleMesh& mesh, const TriangleMesh::Component& component)
{
  Index e = component.FirstEdge;
  while (
    mesh.IsBoundary(mesh.Tail(mesh.HalfEdge(e))) || mesh.IsBoundary(mesh.Head(mesh.HalfEdge(e))))
  {
    ++e;
  }
  return e;
}

/// Heights with errors of a part of the mean edge length.
Surface Noisy(Surface surface, double noise, unsigned seed)
{
  const SurfaceGeometry geometry(surface);
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
  {
    surface.Points[geometry.Mesh.Point(v)] +=
      noise * geometry.Lengths.Unit[0] * normal(engine) * geometry.Frames.Normal[v];
  }
  return surface;
}

/// The mean squared difference of the Hopf differentials from a constant shape, in units of it.
double Spread(const std::vector<Shape>& shapes, const SurfaceGeometry& geometry)
{
  double sum = 0.0;
  for (std::size_t v = 0; v < shapes.size(); ++v)
  {
    const Vector3& p = geometry.Positions[v];
    const Complex around =
      geometry.Frames.Tangential(static_cast<Index>(v), { -p.y(), p.x(), 0.0 });
    const Complex exact = 0.5 * geometry.Lengths.Unit[0] * around * around / std::norm(around);
    sum += std::norm(shapes[v].Hopf - exact) / std::norm(exact);
  }
  return std::sqrt(sum / static_cast<double>(shapes.size()));
}
}

TEST(Creases, AreWhereTheSurfaceIsBent)
{
  // The fold runs through 20 edges of a square of 20 cells.
  for (const double angle : { 0.7, 1.5, -1.5, 2.5 })
  {
    const Surface folded = Folded(Square(20), angle);
    EXPECT_EQ(Creased(folded), 20) << angle;
    EXPECT_EQ(Creased(Noisy(folded, 0.01, 1)), 20) << angle;
  }
  EXPECT_EQ(Creased(Folded(Square(20), 0.4)), 0);
  // Twelve edges of a cube of 8 cells, cut off: two creases for each, but the corners.
  const SurfaceGeometry cube(ChamferedCube(8));
  const Creases creases = CreasesOf(cube);
  for (Index e = 0; e < cube.Mesh.GetNumberOfEdges(); ++e)
  {
    const double angle = std::abs(DihedralAngles(cube)[e]);
    EXPECT_TRUE(creases.Edge[e] == 0 || angle > 0.6);
    const bool ends = creases.Vertex[cube.Mesh.Tail(cube.Mesh.HalfEdge(e))] != 0 &&
      creases.Vertex[cube.Mesh.Head(cube.Mesh.HalfEdge(e))] != 0;
    EXPECT_TRUE(creases.Edge[e] == 0 || ends);
  }
  EXPECT_GT(Creased(ChamferedCube(8)), 100);
}

TEST(Creases, AreNeitherNoiseNorRoundness)
{
  EXPECT_EQ(Creased(Icosahedron()), 0);
  EXPECT_EQ(Creased(Octahedron()), 0);
  EXPECT_EQ(Creased(Torus(24, 16)), 0);
  EXPECT_EQ(Creased(Potato(4)), 0);
  EXPECT_EQ(Creased(Noisy(Potato(4), 0.05, 2)), 0);
  // With noise of a tenth of an edge angles of 30 degrees are common.
  const Surface noisy = Noisy(Potato(4), 0.1, 2);
  EXPECT_LT(Creased(noisy), 0.01 * static_cast<double>(noisy.Points.size()));
}

TEST(Creases, OfASingleEdgeEndAtBoundariesOnly)
{
  const SurfaceGeometry geometry(Square(6));
  const TriangleMesh& mesh = geometry.Mesh;
  const Creases none = CreasesOf(geometry);
  const auto whole = [](std::vector<char>&) {};
  const std::vector<char> all(1, 1);
  std::array<int, 3> seen = {};
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = mesh.HalfEdge(e);
    if (mesh.Twin(h) == None)
    {
      continue;
    }
    const int ends =
      (mesh.IsBoundary(mesh.Tail(h)) ? 1 : 0) + (mesh.IsBoundary(mesh.Head(h)) ? 1 : 0);
    ++seen[ends];
    Creases creases = none;
    creases.Edge[e] = 1;
    creases.DropSingleEdges(mesh, all, whole);
    EXPECT_EQ(creases.Edge[e], ends == 2 ? 1 : 0);
    EXPECT_EQ(creases.Vertex[mesh.Head(h)], ends == 2 ? 1 : 0);
    // Two edges on end stay.
    const Index next = mesh.Edge(TriangleMesh::Next(h));
    creases.Edge[e] = 1;
    creases.Edge[next] = 1;
    creases.DropSingleEdges(mesh, all, whole);
    EXPECT_EQ(creases.Edge[e] + creases.Edge[next], 2);
  }
  EXPECT_GT(std::min({ seen[0], seen[1], seen[2] }), 0);
}

TEST(Creases, OfASingleEdgeAreDroppedInGivenComponentsOnly)
{
  const SurfaceGeometry geometry(
    Joined(Square(6), Transformed(Square(6), Eigen::Matrix3d::Identity(), Vector3(2.0, 0.0, 0.0))));
  const TriangleMesh& mesh = geometry.Mesh;
  ASSERT_EQ(mesh.GetComponents().size(), 2U);
  Creases creases = CreasesOf(geometry);
  for (const TriangleMesh::Component& component : mesh.GetComponents())
  {
    const Index e = InnerEdge(mesh, component);
    creases.Edge[e] = 1;
  }
  creases.DropSingleEdges(mesh, { 0, 1 }, [](std::vector<char>&) {});
  EXPECT_EQ(std::count(creases.Edge.begin(), creases.Edge.end(), 1), 1);
  EXPECT_EQ(creases.Edge[InnerEdge(mesh, mesh.GetComponents()[0])], 1);
  EXPECT_EQ(std::count(creases.Vertex.begin(), creases.Vertex.end(), 1), 2);
}

TEST(ShapeFit, IsExactOnSpheresOfAnyMesh)
{
  const Surface sphere = BadSphere(3, 0.06, 3);
  const SurfaceGeometry geometry(sphere);
  for (const Shape& shape : FitShapes(geometry, CreasesOf(geometry)))
  {
    ASSERT_TRUE(shape.IsFitted());
    EXPECT_NEAR(shape.Mean / geometry.Lengths.Unit[0], 1.0, 0.05);
    EXPECT_LT(std::abs(shape.Hopf) / geometry.Lengths.Unit[0], 0.05);
  }
  const SurfaceGeometry even(Icosphere(3));
  for (const Shape& shape : FitShapes(even, CreasesOf(even)))
  {
    EXPECT_NEAR(shape.Mean / even.Lengths.Unit[0], 1.0, 0.002);
    EXPECT_LT(std::abs(shape.Hopf) / even.Lengths.Unit[0], 0.002);
  }
}

/// By QR factorization of the equations themselves.
TEST(ShapeFit, IsTheLeastSquaresSolution)
{
  const Surface surface = Jittered(Potato(3), 0.01, 4);
  const SurfaceGeometry geometry(surface);
  const TriangleMesh& mesh = geometry.Mesh;
  const std::vector<Shape> shapes = FitShapes(geometry, CreasesOf(geometry));
  std::vector<Index> fan;
  for (Index v = 0; v < mesh.GetNumberOfVertices(); v += 7)
  {
    std::vector<Index> points = { v };
    mesh.GetFan(v, fan);
    for (const Index h : fan)
    {
      points.push_back(mesh.Head(h));
      const Index beyond = mesh.Twin(TriangleMesh::Next(h));
      points.push_back(mesh.Tail(TriangleMesh::Previous(beyond)));
    }
    Eigen::MatrixXd equations(points.size(), 6);
    Eigen::VectorXd heights(points.size());
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      const Vector3 p =
        (geometry.Positions[points[k]] - geometry.Positions[v]) / geometry.Lengths.Unit[0];
      Complex z = geometry.Frames.Tangential(v, p);
      z *= k == 0 ? 1.0 : p.norm() / std::abs(z);
      const double x = z.real();
      const double y = z.imag();
      equations.row(static_cast<Eigen::Index>(k)) << 1.0, x, y, 0.5 * x * x, x * y, 0.5 * y * y;
      heights[static_cast<Eigen::Index>(k)] = p.dot(geometry.Frames.Normal[v]);
    }
    const Eigen::VectorXd solution = RealLeastSquares(equations, heights);
    EXPECT_NEAR(shapes[v].Mean, -0.5 * (solution[3] + solution[5]), 1e-9);
    EXPECT_NEAR(shapes[v].Hopf.real(), -0.5 * (solution[3] - solution[5]), 1e-9);
    EXPECT_NEAR(shapes[v].Hopf.imag(), -solution[4], 1e-9);
    const Eigen::MatrixXd covariance =
      RealSolution(equations.transpose() * equations, Eigen::MatrixXd::Identity(6, 6));
    const double variance =
      0.25 * (covariance(3, 3) + covariance(5, 5)) - 0.5 * covariance(3, 5) + covariance(4, 4);
    EXPECT_NEAR(shapes[v].Variance, variance, 1e-8 * variance);
  }
}

TEST(ShapeFit, DoesNotCrossCreases)
{
  const SurfaceGeometry folded(Folded(Square(20), 1.2));
  const Creases creases = CreasesOf(folded);
  const std::vector<Shape> shapes = FitShapes(folded, creases);
  for (std::size_t v = 0; v < shapes.size(); ++v)
  {
    EXPECT_EQ(shapes[v].IsFitted(), creases.Vertex[v] == 0);
    EXPECT_LT(std::abs(shapes[v].Hopf) + std::abs(shapes[v].Mean), 1e-10);
  }
}

TEST(ShapeFit, IsMadeAgainWhereCreasesAreDropped)
{
  const SurfaceGeometry geometry(Noisy(Square(12), 0.01, 4));
  Creases creases = CreasesOf(geometry);
  const Index e = InnerEdge(geometry.Mesh, geometry.Mesh.GetComponents()[0]);
  const Index h = geometry.Mesh.HalfEdge(e);
  creases.Edge[e] = 1;
  creases.Vertex[geometry.Mesh.Tail(h)] = 1;
  creases.Vertex[geometry.Mesh.Head(h)] = 1;
  std::vector<Shape> shapes = FitShapes(geometry, creases);
  const std::vector<char> wereOnCreases = creases.Vertex;
  creases.DropSingleEdges(geometry.Mesh, { 1 }, [](std::vector<char>&) {});
  ASSERT_EQ(creases.Edge[e], 0);
  const std::vector<Shape> wanted = FitShapes(geometry, creases);
  Index changed = 0;
  for (std::size_t v = 0; v < shapes.size(); ++v)
  {
    changed += shapes[v].Variance != wanted[v].Variance ? 1 : 0;
  }
  // Two that were on it, and two beside it that saw nothing beyond it.
  EXPECT_EQ(changed, 4);
  FitShapesAgain(geometry, creases, wereOnCreases, shapes);
  for (std::size_t v = 0; v < shapes.size(); ++v)
  {
    EXPECT_EQ(shapes[v].Hopf, wanted[v].Hopf);
    EXPECT_EQ(shapes[v].Mean, wanted[v].Mean);
    EXPECT_EQ(shapes[v].Variance, wanted[v].Variance);
  }
}

TEST(ShapeFit, NeedlesAreGatheredOnceOnly)
{
  // With the neighbours of the tip at each vertex of the rim this would take hours.
  constexpr int count = 100000;
  Surface disk;
  disk.Points.emplace_back(0.0, 0.0, 0.0);
  for (int k = 0; k < count; ++k)
  {
    disk.Points.emplace_back(std::cos(2.0 * Pi * k / count), std::sin(2.0 * Pi * k / count), 0.0);
    disk.Triangles.push_back({ 0, 1 + k, 1 + (k + 1) % count });
  }
  const SurfaceGeometry geometry(disk);
  for (const Shape& shape : FitShapes(geometry, CreasesOf(geometry)))
  {
    ASSERT_LT(std::abs(shape.Hopf) + std::abs(shape.Mean), 1e-10);
  }
}

TEST(ShapeSmoothing, TakesNoiseAwayAndNothingElse)
{
  const Surface cylinder = Cylinder(80, 40, 3.0);
  for (const double noise : { 0.0, 0.01, 0.05 })
  {
    const Surface surface = noise > 0.0 ? Noisy(cylinder, noise, 5) : cylinder;
    const SurfaceGeometry geometry(surface);
    const std::vector<Shape> fits = FitShapes(geometry, CreasesOf(geometry));
    const double before = Spread(fits, geometry);
    double last = before;
    for (const double rings : { 0.0, 2.0, 4.0, 8.0 })
    {
      std::vector<Shape> shapes = fits;
      SmoothShapes(geometry, fits, rings, shapes);
      if (rings == 0.0)
      {
        // Noise is left to more than this.
        const Curvature curvature(geometry, DihedralAngles(geometry));
        for (std::size_t v = 0; v < shapes.size(); ++v)
        {
          shapes[v].Hopf = curvature.Hopf[v];
        }
      }
      const double after = Spread(shapes, geometry);
      if (noise == 0.0)
      {
        EXPECT_LT(after, 0.01);
      }
      else if (rings == 0.0)
      {
        EXPECT_LT(after, 0.1 * before) << noise;
      }
      else
      {
        EXPECT_LT(after, 0.6 * last) << noise << ' ' << rings;
        last = after;
      }
    }
  }
}

TEST(ShapeSmoothing, DoesNotBlurWhereThereIsNoNoise)
{
  const SurfaceGeometry geometry(Torus(96, 48));
  const std::vector<Shape> fits = FitShapes(geometry, CreasesOf(geometry));
  std::vector<Shape> shapes = fits;
  SmoothShapes(geometry, fits, 0.0, shapes);
  for (std::size_t v = 0; v < fits.size(); ++v)
  {
    EXPECT_LT(std::abs(shapes[v].Hopf - fits[v].Hopf), 1e-14);
    EXPECT_DOUBLE_EQ(shapes[v].Variance, fits[v].Variance);
  }
}
