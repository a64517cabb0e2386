// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Geometry/IntrinsicTriangulation.h"
#include "Geometry/SurfaceGeometry.h"
#include "Meshes/Angles.h"
#include "Meshes/DenseAlgebra.h"
#include "Meshes/LocalMatrices.h"
#include "Meshes/Surfaces.h"
#include "Sections/Assembly.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
struct Flipped : SurfaceGeometry
{
  explicit Flipped(const Surface& surface)
    : SurfaceGeometry(surface)
    , Delaunay(*this)
  {
  }
  IntrinsicTriangulation Delaunay;
};

void ExpectConsistent(const TriangleMesh& mesh)
{
  for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Index twin = mesh.Twin(h);
    const Index direct = mesh.HalfEdge(mesh.Edge(h));
    ASSERT_TRUE(direct == h || direct == twin);
    if (twin != None)
    {
      ASSERT_EQ(mesh.Twin(twin), h);
      ASSERT_EQ(mesh.Edge(twin), mesh.Edge(h));
      ASSERT_EQ(mesh.Tail(twin), mesh.Head(h));
      ASSERT_EQ(mesh.Head(twin), mesh.Tail(h));
    }
  }
  // The fans of the vertices are all corners, each once.
  Index corners = 0;
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    Index h = mesh.Outgoing(v);
    do
    {
      ASSERT_EQ(mesh.Tail(h), v);
      ASSERT_LE(++corners, mesh.GetNumberOfHalfEdges());
      h = mesh.NextOutgoing(h);
    } while (h != None && h != mesh.Outgoing(v));
  }
  ASSERT_EQ(corners, mesh.GetNumberOfHalfEdges());
}

template <typename Angles>
std::vector<double> AngleSums(const TriangleMesh& mesh, const Angles& angles)
{
  std::vector<double> sums(mesh.GetNumberOfVertices(), 0.0);
  for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    sums[mesh.Tail(h)] += angles.CornerAngle(mesh, h);
  }
  return sums;
}

/// All that holds for the intrinsic Delaunay triangulation of any surface.
void ExpectDelaunay(const Flipped& g)
{
  const TriangleMesh& mesh = g.Delaunay.Mesh;
  const Metric& metric = g.Delaunay.Lengths;
  const Connection& connection = g.Delaunay.Transport;
  ExpectConsistent(mesh);
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = mesh.HalfEdge(e);
    const Index twin = mesh.Twin(h);
    if (twin != None)
    {
      EXPECT_LE(metric.CornerAngle(mesh, TriangleMesh::Previous(h)) +
          metric.CornerAngle(mesh, TriangleMesh::Previous(twin)),
        Pi + 1e-9);
    }
    // Surfaces with a boundary keep it.
    const Index before = g.Mesh.HalfEdge(e);
    EXPECT_EQ(twin == None, g.Mesh.Twin(before) == None);
    if (twin == None)
    {
      EXPECT_EQ(mesh.Tail(h), g.Mesh.Tail(before));
      EXPECT_EQ(mesh.Head(h), g.Mesh.Head(before));
      EXPECT_EQ(mesh.IsNonManifold(h), g.Mesh.IsNonManifold(before));
      EXPECT_EQ(metric.SquaredLength[e], g.Lengths.SquaredLength[e]);
    }
  }
  for (std::size_t c = 0; c < mesh.GetComponents().size(); ++c)
  {
    const TriangleMesh::Component& component = mesh.GetComponents()[c];
    const double area = std::accumulate(metric.Area.begin() + component.FirstTriangle,
      metric.Area.begin() + component.EndTriangle, 0.0);
    EXPECT_NEAR(area / g.Lengths.ComponentArea[c], 1.0, 1e-9);
    for (Index h = 3 * component.FirstTriangle; h < 3 * component.EndTriangle; ++h)
    {
      ASSERT_GE(mesh.Tail(h), component.FirstVertex);
      ASSERT_LT(mesh.Tail(h), component.EndVertex);
    }
  }
  const std::vector<double> before = AngleSums(g.Mesh, g.Lengths);
  const std::vector<double> after = AngleSums(mesh, metric);
  const std::vector<double> scaled = AngleSums(mesh, connection);
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    EXPECT_NEAR(after[v], before[v], 1e-8);
    EXPECT_EQ(mesh.IsBoundary(v), g.Mesh.IsBoundary(v));
    EXPECT_NEAR(scaled[v], mesh.IsBoundary(v) ? before[v] : 2.0 * Pi, 1e-8);
    EXPECT_NEAR(connection.AngleSum[v], g.Transport.AngleSum[v], 1e-8);
  }
  const double total =
    std::accumulate(connection.Curvature.begin(), connection.Curvature.end(), 0.0);
  EXPECT_NEAR(
    total, std::accumulate(g.Transport.Curvature.begin(), g.Transport.Curvature.end(), 0.0), 1e-7);
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    double sum = 0.0;
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      sum += connection.RotationAlong(mesh, h);
    }
    EXPECT_NEAR(Wrapped(sum - connection.Curvature[t]), 0.0, 1e-8);
  }
}

/// Both matrices of a component, added up corner by corner.
std::array<Eigen::MatrixXcd, 2> DenseOperators(
  const IntrinsicTriangulation& triangulation, int degree)
{
  const TriangleMesh& mesh = triangulation.Mesh;
  const Index n = mesh.GetNumberOfVertices();
  Eigen::MatrixXcd energy = Eigen::MatrixXcd::Zero(n, n);
  Eigen::MatrixXcd mass = Eigen::MatrixXcd::Zero(n, n);
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    std::array<double, 3> squaredLength;
    std::array<Complex, 3> r;
    for (int c = 0; c < 3; ++c)
    {
      squaredLength[c] = triangulation.Lengths.SquaredLength[mesh.Edge(3 * t + c)];
      r[c] = std::polar(1.0, degree * triangulation.Transport.RotationAlong(mesh, 3 * t + c));
    }
    const LocalMatrices local(squaredLength, triangulation.Lengths.Area[t],
      degree * triangulation.Transport.Curvature[t], r, 0.0);
    for (int c = 0; c < 3; ++c)
    {
      const Index i = mesh.Tail(3 * t + c);
      const Index j = mesh.Head(3 * t + c);
      energy(i, i) += local.EnergyDiagonal[c];
      energy(i, j) += local.Energy[c];
      energy(j, i) += std::conj(local.Energy[c]);
      mass(i, i) += local.MassDiagonal;
      mass(i, j) += local.Mass[c];
      mass(j, i) += std::conj(local.Mass[c]);
    }
  }
  return { energy, mass };
}

Operators Assemble(const IntrinsicTriangulation& triangulation, int degree)
{
  return AssembleOperators(triangulation, triangulation.Mesh.GetComponents()[0], degree, 0.0);
}
}

TEST(IntrinsicTriangulation, EdgesAreDelaunayOnAnySurface)
{
  Surface fin = BadSquare(4, 1);
  fin.Points.emplace_back(0.5, 0.25, 1.0);
  fin.Triangles.push_back(
    { fin.Triangles[7][0], fin.Triangles[7][1], static_cast<Index>(fin.Points.size()) - 1 });
  for (const Surface& surface :
    { BadSphere(3, 0.15, 1), Scrambled(FlatlySubdivided(Torus(9, 7), 2), 6), BadSquare(12, 5), fin,
      Jittered(Hemisphere(3), 0.1, 2), Jittered(DoubleTorus(), 0.1, 3),
      Joined(BadSphere(2, 0.2, 4), Jittered(Torus(9, 40), 0.03, 5)), Folded(BadSquare(6, 4), 1.0) })
  {
    const Flipped g(surface);
    EXPECT_GT(g.Delaunay.NumberOfFlips, 0);
    ExpectDelaunay(g);
  }
}

TEST(IntrinsicTriangulation, AFlatMeshBecomesThePlaneDelaunayTriangulation)
{
  const Surface surface = BadSquare(10, 7);
  const Flipped g(surface);
  const TriangleMesh& mesh = g.Delaunay.Mesh;
  ExpectDelaunay(g);
  Surface flipped{ surface.Points, {} };
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    const Triangle corners = { mesh.Point(mesh.Tail(3 * t)), mesh.Point(mesh.Tail(3 * t + 1)),
      mesh.Point(mesh.Tail(3 * t + 2)) };
    flipped.Triangles.push_back(corners);
    const Vector3& a = surface.Points[corners[0]];
    const Vector3& b = surface.Points[corners[1]];
    const Vector3& c = surface.Points[corners[2]];
    ASSERT_GT((b - a).cross(c - a).z(), 0.0);
    // No other point is inside of its circle.
    for (const Vector3& d : surface.Points)
    {
      Eigen::Matrix3d circle;
      circle << a.x() - d.x(), a.y() - d.y(), (a - d).squaredNorm(), b.x() - d.x(), b.y() - d.y(),
        (b - d).squaredNorm(), c.x() - d.x(), c.y() - d.y(), (c - d).squaredNorm();
      EXPECT_LT(circle.determinant(), 1e-12);
    }
  }
  for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Vector3 edge =
      surface.Points[mesh.Point(mesh.Head(h))] - surface.Points[mesh.Point(mesh.Tail(h))];
    const double length = std::sqrt(g.Delaunay.Lengths.SquaredLength[mesh.Edge(h)]);
    EXPECT_NEAR(length * g.Lengths.Unit[0], edge.norm(), 1e-13);
  }

  const Flipped direct(flipped);
  EXPECT_EQ(direct.Delaunay.NumberOfFlips, 0);
  const Operators one = Assemble(g.Delaunay, 1);
  const Operators other = Assemble(direct.Delaunay, 1);
  const double unit = g.Lengths.Unit[0] / direct.Lengths.Unit[0];
  // Vertices are numbered by first use, frames count from the smallest neighbour: compare by points
  // and without phases.
  const auto byPoint = [](const SparseMatrix& matrix, const TriangleMesh& numbers)
  {
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(matrix.rows(), matrix.cols());
    for (Index column = 0; column < matrix.outerSize(); ++column)
    {
      for (SparseMatrix::InnerIterator it(matrix, column); it; ++it)
      {
        dense(numbers.Point(static_cast<Index>(it.row())), numbers.Point(column)) =
          std::abs(it.value());
      }
    }
    return dense;
  };
  EXPECT_LT((byPoint(one.Energy, g.Mesh) - byPoint(other.Energy, direct.Mesh)).norm(), 1e-10);
  EXPECT_LT(
    (unit * unit * byPoint(one.Mass, g.Mesh) - byPoint(other.Mass, direct.Mesh)).norm(), 1e-11);
}

TEST(IntrinsicTriangulation, BendingChangesNothing)
{
  // Edges are flipped across the fold; all lengths, angles and transports are the plane's.
  const Surface surface =
    Transformed(BadSquare(12, 3), Vector3(1.0, 2.5, 1.0).asDiagonal(), Vector3::Zero());
  struct Edge
  {
    double SquaredLength, Rotation;
  };
  const auto edges = [](const Flipped& g)
  {
    const TriangleMesh& mesh = g.Delaunay.Mesh;
    std::map<std::pair<Index, Index>, Edge> byPoints;
    for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      byPoints[{ mesh.Point(mesh.Tail(h)), mesh.Point(mesh.Head(h)) }] = {
        g.Delaunay.Lengths.SquaredLength[mesh.Edge(h)] * g.Lengths.Unit[0] * g.Lengths.Unit[0],
        g.Delaunay.Transport.RotationAlong(mesh, h)
      };
    }
    return byPoints;
  };
  const auto flat = edges(Flipped(surface));
  const auto folded = edges(Flipped(Folded(surface, 1.2)));
  ASSERT_EQ(flat.size(), folded.size());
  Index across = 0;
  for (const auto& [points, edge] : flat)
  {
    const Edge& other = folded.at(points);
    EXPECT_NEAR(other.SquaredLength / edge.SquaredLength, 1.0, 1e-12);
    EXPECT_NEAR(Wrapped(other.Rotation - edge.Rotation), 0.0, 1e-11);
    across +=
      (surface.Points[points.first].x() - 0.5) * (surface.Points[points.second].x() - 0.5) < 0.0;
  }
  EXPECT_GT(across, 3);
}

TEST(IntrinsicTriangulation, EdgesOnAConeAreThoseOfItsDevelopment)
{
  // Rays from an apex, each with points at radii of its own; strips of slivers between the rays.
  constexpr int Rays = 5;
  constexpr int Along = 14;
  std::mt19937 random(2);
  Surface surface{ { Vector3::Zero() }, {} };
  for (int ray = 0; ray < Rays; ++ray)
  {
    const double around = 2.0 * Pi * ray / Rays;
    const Vector3 direction = Vector3(std::cos(around), std::sin(around), 0.8).normalized();
    for (int k = 1; k <= Along; ++k)
    {
      surface.Points.push_back((k + 0.8 * (random() / 4294967296.0)) * direction);
    }
  }
  const auto number = [](int ray, int k) { return k == 0 ? 0 : 1 + (ray % Rays) * Along + k - 1; };
  for (int ray = 0; ray < Rays; ++ray)
  {
    surface.Triangles.push_back({ 0, number(ray, 1), number(ray + 1, 1) });
    for (int left = 1, right = 1; left < Along || right < Along;)
    {
      const bool stepLeft = right == Along || (left < Along && random() % 2 == 0);
      surface.Triangles.push_back({ number(ray, left),
        stepLeft ? number(ray, left + 1) : number(ray + 1, right + 1), number(ray + 1, right) });
      ++(stepLeft ? left : right);
    }
  }
  const Flipped g(surface);
  ExpectDelaunay(g);
  EXPECT_GT(g.Delaunay.NumberOfFlips, 20);
  const double facet =
    std::acos(surface.Points[1].normalized().dot(surface.Points[1 + Along].normalized()));
  const double whole = Rays * facet;
  const auto polar = [&](Index vertex)
  {
    const Index point = g.Mesh.Point(vertex);
    return std::pair(
      surface.Points[point].norm(), point == 0 ? 0.0 : facet * ((point - 1) / Along));
  };
  // The edge from i to j turned counter-clockwise about the apex by an angle: how long it is, and
  // its direction at i from the ray outwards.
  const auto developed = [](double from, double to, double turn)
  {
    const Complex edge = std::polar(to, turn) - from;
    return std::pair(std::abs(edge), std::arg(edge));
  };
  // Where angle 0 of each vertex points, from the first edge; the surface's own edges say it, too.
  std::vector<double> zero(g.Mesh.GetNumberOfVertices(), 10.0);
  for (const auto& [mesh, metric, connection] : { std::tie(g.Mesh, g.Lengths, g.Transport),
         std::tie(g.Delaunay.Mesh, g.Delaunay.Lengths, g.Delaunay.Transport) })
  {
    int edges = 0;
    for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      const Index i = mesh.Tail(h);
      const Index j = mesh.Head(h);
      if (mesh.Point(i) == 0 || mesh.Point(j) == 0 || mesh.IsBoundary(i))
      {
        continue;
      }
      const auto [from, fromAngle] = polar(i);
      const auto [to, toAngle] = polar(j);
      const double turn = std::remainder(toAngle - fromAngle, whole);
      const auto [length, direction] = developed(from, to, turn);
      EXPECT_NEAR(std::sqrt(metric.SquaredLength[mesh.Edge(h)]) * g.Lengths.Unit[0], length, 1e-11);
      const double from0 = connection.EdgeAngle[h] - direction;
      zero[i] = zero[i] == 10.0 ? from0 : zero[i];
      EXPECT_NEAR(Wrapped(from0 - zero[i]), 0.0, 1e-10);
      ++edges;
    }
    EXPECT_GT(edges, 200);
  }
}

TEST(IntrinsicTriangulation, SelfEdgesAndDoubleEdgesAddUp)
{
  // Leaning spikes: around an apex of small angle an edge closes up.
  int selfEdges = 0;
  int doubleEdges = 0;
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    Surface surface = Jittered(seed % 2 == 0 ? Tetrahedron() : Octahedron(), 0.3, seed);
    surface.Points[0] *= 6.0;
    surface.Points[0].x() += 4.0;
    const Flipped g(surface);
    ExpectDelaunay(g);
    std::set<std::pair<Index, Index>> seen;
    for (Index e = 0; e < g.Delaunay.Mesh.GetNumberOfEdges(); ++e)
    {
      const Index h = g.Delaunay.Mesh.HalfEdge(e);
      const auto ends = std::minmax({ g.Delaunay.Mesh.Tail(h), g.Delaunay.Mesh.Head(h) });
      selfEdges += ends.first == ends.second;
      doubleEdges += !seen.insert(ends).second;
    }
    for (const int degree : { 1, 4 })
    {
      const Operators operators = Assemble(g.Delaunay, degree);
      const auto [energy, mass] = DenseOperators(g.Delaunay, degree);
      EXPECT_LT((Eigen::MatrixXcd(operators.Energy) - energy).norm(), 1e-12 * energy.norm());
      EXPECT_LT((Eigen::MatrixXcd(operators.Mass) - mass).norm(), 1e-12 * mass.norm());
      EXPECT_TRUE(IsPositiveDefinite(mass));
      const double smallest = DenseEigenpairs(energy, mass).Values[0];
      EXPECT_GT(smallest, 0.0);
      Options options;
      options.Degree = degree;
      options.IntrinsicDelaunay = true;
      const Result result = DirectionField(surface).Compute(options);
      EXPECT_EQ(result.Components[0].IndexSum, 2 * degree);
      const double unit = g.Lengths.Unit[0];
      EXPECT_NEAR(result.Components[0].Eigenvalue * unit * unit / smallest, 1.0, 1e-9);
    }
  }
  EXPECT_GT(selfEdges, 3);
  EXPECT_GT(doubleEdges, 3);
}

TEST(IntrinsicTriangulation, DoublyCoveredTriangle)
{
  // All curvature is in the three corners. A point close to a side above and one close to another
  // below make slivers.
  const Surface coarse{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0.4, 0.9, 0 }, { 0.5, 0.03, 0 },
                          { 0.25, 0.5, 0 } },
    { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 1, 0, 4 }, { 2, 1, 4 }, { 0, 2, 4 } } };
  for (int level = 0; level < 3; ++level)
  {
    const Surface surface = FlatlySubdivided(coarse, level);
    const Flipped g(surface);
    ASSERT_TRUE(g.Mesh.GetComponents()[0].Closed);
    ExpectDelaunay(g);
    double total = 0.0;
    for (const double curvature : g.Delaunay.Transport.Curvature)
    {
      total += curvature;
    }
    EXPECT_NEAR(total, 4.0 * Pi, 1e-9);
  }
}
