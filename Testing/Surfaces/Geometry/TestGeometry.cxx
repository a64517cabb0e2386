// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Geometry/DihedralAngles.h"
#include "Geometry/SurfaceGeometry.h"

#include "Curvature/Curvature.h"
#include "Meshes/Angles.h"
#include "Meshes/Surfaces.h"
#include "Sections/Assembly.h"
#include "Sections/ReferenceSection.h"
#include "Sections/Singularities.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
/// The half-edge of each of a mesh in another mesh of the same triangles.
std::vector<Index> HalfEdgesIn(const TriangleMesh& other, const TriangleMesh& mesh)
{
  const auto key = [](const TriangleMesh& m, Index h)
  { return std::pair(m.InputTriangle(h / 3), m.Point(m.Tail(h))); };
  std::map<std::pair<Index, Index>, Index> found;
  for (Index h = 0; h < other.GetNumberOfHalfEdges(); ++h)
  {
    found[key(other, h)] = h;
  }
  std::vector<Index> halfEdges;
  for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    halfEdges.push_back(found.at(key(mesh, h)));
  }
  return halfEdges;
}
}

TEST(Metric, RightTriangle)
{
  const Surface s{ { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 4, 0 } }, { { 0, 1, 2 } } };
  const TriangleMesh mesh(s);
  const Metric metric(mesh, mesh.Positions(s.Points));
  EXPECT_DOUBLE_EQ(metric.Unit[0], 4.0);
  EXPECT_NEAR(metric.Area[0] * 16.0, 6.0, 1e-14);
  EXPECT_NEAR(metric.CornerAngle(mesh, 0), Pi / 2.0, 1e-15);
  EXPECT_NEAR(metric.CornerAngle(mesh, 1), std::atan2(4.0, 3.0), 1e-15);
  EXPECT_NEAR(metric.CornerAngle(mesh, 2), std::atan2(3.0, 4.0), 1e-15);
  EXPECT_EQ(metric.DegenerateTriangles, 0);
}

TEST(Metric, CornerAnglesOfATriangleSumToPi)
{
  const Surface s = Jittered(Torus(17, 11), 0.08, 3);
  const TriangleMesh mesh(s);
  const Metric metric(mesh, mesh.Positions(s.Points));
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    EXPECT_NEAR(metric.CornerAngle(mesh, 3 * t) + metric.CornerAngle(mesh, 3 * t + 1) +
        metric.CornerAngle(mesh, 3 * t + 2),
      Pi, 1e-12);
  }
}

TEST(Metric, SameAtAnyScale)
{
  const Surface s = Potato(2);
  const TriangleMesh mesh(s);
  const Metric metric(mesh, mesh.Positions(s.Points));
  for (const double scale : { 1e-150, 1e-9, 1e9, 1e150 })
  {
    const Surface scaled = Transformed(s, scale * Eigen::Matrix3d::Identity(), Vector3::Zero());
    const Metric other(mesh, mesh.Positions(scaled.Points));
    EXPECT_NEAR(other.Unit[0] / metric.Unit[0] / scale, 1.0, 1e-13);
    for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      EXPECT_NEAR(other.CornerAngle(mesh, h), metric.CornerAngle(mesh, h), 1e-12);
    }
  }
}

TEST(Metric, DegenerateTrianglesGetAnglesAndArea)
{
  // A point on the diagonal of a square: one triangle has no area. And a doubled point.
  const Surface flat{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0.5, 0.5, 0 } },
    { { 0, 1, 2 }, { 0, 2, 4 }, { 0, 4, 3 }, { 4, 2, 3 } } };
  const Surface doubled{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 0 } },
    { { 0, 1, 2 }, { 0, 2, 4 }, { 4, 2, 3 } } };
  const Surface point{ { { 2, 2, 2 }, { 2, 2, 2 }, { 2, 2, 2 } }, { { 0, 1, 2 } } };
  for (const Surface& s : { flat, doubled, point })
  {
    const TriangleMesh mesh(s);
    const Metric metric(mesh, mesh.Positions(s.Points));
    EXPECT_EQ(metric.DegenerateTriangles, 1);
    for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      EXPECT_GT(metric.CornerAngle(mesh, h), 1e-10);
      EXPECT_GT(metric.Area[h / 3], 1e-8);
    }
    // Triangles with area change by the millionth only.
    if (s.Points.size() > 3)
    {
      EXPECT_NEAR(metric.Area[0] * metric.Unit[0] * metric.Unit[0], 0.5, 1e-5);
    }
  }
}

TEST(Connection, TotalCurvatureIsTwoPiChi)
{
  const std::vector<std::pair<Surface, int>> surfaces = { { Tetrahedron(), 2 }, { Cube(), 2 },
    { Potato(2), 2 }, { Torus(12, 9), 0 }, { DoubleTorus(), -2 } };
  for (const auto& [surface, chi] : surfaces)
  {
    const SurfaceGeometry g(surface);
    double sum = 0.0;
    for (const double curvature : g.Transport.Curvature)
    {
      sum += curvature;
    }
    EXPECT_NEAR(sum, 2.0 * Pi * chi, 1e-10);
  }
}

TEST(Connection, TransportAroundATriangleIsItsCurvature)
{
  for (const Surface& surface : { Cube(), Potato(2), Hemisphere(2), Jittered(Disk(5), 0.1, 1) })
  {
    const SurfaceGeometry g(surface);
    for (Index t = 0; t < g.Mesh.GetNumberOfTriangles(); ++t)
    {
      double sum = 0.0;
      for (Index h = 3 * t; h < 3 * t + 3; ++h)
      {
        sum += g.Transport.RotationAlong(g.Mesh, h);
      }
      EXPECT_NEAR(Wrapped(sum - g.Transport.Curvature[t]), 0.0, 1e-12);
    }
  }
}

TEST(Connection, FlatPatchStaysFlatUpToItsBoundary)
{
  const SurfaceGeometry g(Transformed(Disk(6), ObliqueRotation(1.1), { 1, 2, 3 }));
  for (const double curvature : g.Transport.Curvature)
  {
    EXPECT_NEAR(curvature, 0.0, 1e-12);
  }
  // Transport between any two vertices keeps the direction in space.
  for (Index e = 0; e < g.Mesh.GetNumberOfEdges(); ++e)
  {
    const Index i = g.Mesh.Tail(g.Mesh.HalfEdge(e));
    const Index j = g.Mesh.Head(g.Mesh.HalfEdge(e));
    const double rho = g.Transport.Rotation[e];
    const Vector3 arrived = std::cos(rho) * g.Frames.X[j] + std::sin(rho) * g.Frames.Y(j);
    EXPECT_LT((g.Frames.X[i] - arrived).norm(), 1e-12);
  }
}

TEST(TangentFrames, AreOrthonormalAndPointOutwards)
{
  const SurfaceGeometry g(Icosphere(3));
  for (Index v = 0; v < g.Mesh.GetNumberOfVertices(); ++v)
  {
    const Vector3& p = g.Positions[v];
    EXPECT_GT(g.Frames.Normal[v].dot(p), 0.999);
    EXPECT_NEAR(g.Frames.X[v].norm(), 1.0, 1e-14);
    EXPECT_NEAR(g.Frames.X[v].dot(g.Frames.Normal[v]), 0.0, 1e-14);
    EXPECT_NEAR(g.Frames.X[v].cross(g.Frames.Y(v)).dot(g.Frames.Normal[v]), 1.0, 1e-14);
  }
}

TEST(TangentFrames, AnglesFitTheEdges)
{
  const SurfaceGeometry g(Potato(3));
  // On a fine smooth surface the angle theta in the frame is the projected edge's own.
  for (Index h = 0; h < g.Mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Index i = g.Mesh.Tail(h);
    const Vector3 edge = g.Positions[g.Mesh.Head(h)] - g.Positions[i];
    const double angle = std::atan2(edge.dot(g.Frames.Y(i)), edge.dot(g.Frames.X[i]));
    EXPECT_NEAR(Wrapped(angle - g.Transport.EdgeAngle[h]), 0.0, 0.05);
  }
}

TEST(TangentFrames, DependOnlyOnTheShapeUpToTheReferenceAngle)
{
  // The direction of a fixed edge's angle in space is the same whichever edge angle 0 stands for.
  const Surface surface = Potato(2);
  const Eigen::Matrix3d rotation = ObliqueRotation(2.2);
  const SurfaceGeometry g(surface);
  const SurfaceGeometry turned(Transformed(surface, rotation, { -4, 1, 2 }));
  int otherReference = 0;
  const std::vector<Index> halfEdge = HalfEdgesIn(turned.Mesh, g.Mesh);
  for (Index h = 0; h < g.Mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Index v = g.Mesh.Tail(h);
    const double a = g.Transport.EdgeAngle[h];
    const double b = turned.Transport.EdgeAngle[halfEdge[h]];
    const Index w = turned.Mesh.Tail(halfEdge[h]);
    otherReference += std::abs(Wrapped(a - b)) > 0.1;
    const Vector3 inSpace = std::cos(a) * g.Frames.X[v] + std::sin(a) * g.Frames.Y(v);
    const Vector3 inTurned = std::cos(b) * turned.Frames.X[w] + std::sin(b) * turned.Frames.Y(w);
    EXPECT_LT((rotation * inSpace - inTurned).norm(), 1e-12);
  }
  EXPECT_GT(otherReference, 0);
}

TEST(Geometry, SameBytesForAnyNumberOfThreads)
{
  // Large and small components, split points among them.
  Surface surface = Joined(Joined(Potato(5), Jittered(Square(70), 0.003, 8)), Cube());
  surface.Triangles.push_back({ 0, surface.Triangles[0][1], 10500 });
  const auto numbers = [&surface](int number)
  {
    Threads threads(number);
    const Threads::Scope scope(threads);
    const SurfaceGeometry g(surface);
    std::vector<double> all;
    const auto add = [&all](const auto& values)
    { all.insert(all.end(), values.begin(), values.end()); };
    add(g.Lengths.SquaredLength);
    add(g.Lengths.Area);
    add(g.Lengths.Unit);
    add(g.Lengths.ComponentArea);
    add(g.Transport.EdgeAngle);
    add(g.Transport.AngleSum);
    add(g.Transport.Rotation);
    add(g.Transport.Curvature);
    std::vector<Complex> field;
    for (Index v = 0; v < g.Mesh.GetNumberOfVertices(); ++v)
    {
      add(g.Frames.Normal[v]);
      add(g.Frames.X[v]);
      field.push_back(std::polar(1.0, 0.01 * v));
    }
    add(SingularityIndices(g, 4, field));
    const Curvature curvature(g, DihedralAngles(g));
    add(curvature.Mean);
    add(curvature.Gaussian);
    for (const TriangleMesh::Component& component : g.Mesh.GetComponents())
    {
      Operators operators = AssembleOperators(g, component, 4, 0.3);
      for (const SparseMatrix& matrix : { operators.Energy, operators.Mass })
      {
        for (Index k = 0; k < matrix.nonZeros(); ++k)
        {
          all.push_back(matrix.innerIndexPtr()[k]);
          all.push_back(matrix.valuePtr()[k].real());
          all.push_back(matrix.valuePtr()[k].imag());
        }
      }
      const ReferenceSection reference(g, component, 4);
      ComplexVector u = reference.Start();
      reference.FixPhase(u);
      for (const Complex& value : u)
      {
        all.push_back(value.real());
        all.push_back(value.imag());
      }
    }
    return all;
  };
  const std::vector<double> serial = numbers(1);
  EXPECT_EQ(numbers(2), serial);
  EXPECT_EQ(numbers(3), serial);
}

/// Of more vertices than are looked at in one piece.
TEST(Singularities, IndicesAreThoseOfEachTriangleAlone)
{
  const int degree = 4;
  const SurfaceGeometry g(Potato(5));
  std::vector<Complex> field;
  for (Index v = 0; v < g.Mesh.GetNumberOfVertices(); ++v)
  {
    field.push_back(std::polar(1.0 + 0.1 * (v % 7), 0.7 * v));
  }
  const std::vector<int> indices = SingularityIndices(g, degree, field);
  int singular = 0;
  for (Index t = 0; t < g.Mesh.GetNumberOfTriangles(); ++t)
  {
    double sum = degree * g.Transport.Curvature[t];
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      const Complex transported =
        std::polar(1.0, degree * g.Transport.RotationAlong(g.Mesh, h)) * field[g.Mesh.Tail(h)];
      sum += std::arg(field[g.Mesh.Head(h)] / transported);
    }
    ASSERT_NEAR(sum / (2.0 * Pi), indices[t], 1e-9) << t;
    singular += indices[t] != 0;
  }
  EXPECT_GT(singular, 1000);
}

TEST(Connection, ScaledCornerAnglesFillTheConesOfTheVertices)
{
  for (const Surface& surface : { Cube(), Potato(2), Disk(4), Hemisphere(2) })
  {
    const SurfaceGeometry g(surface);
    std::vector<double> sum(g.Mesh.GetNumberOfVertices(), 0.0);
    std::vector<double> unscaled(g.Mesh.GetNumberOfVertices(), 0.0);
    for (Index h = 0; h < g.Mesh.GetNumberOfHalfEdges(); ++h)
    {
      sum[g.Mesh.Tail(h)] += g.Transport.CornerAngle(g.Mesh, h);
      unscaled[g.Mesh.Tail(h)] += g.Lengths.CornerAngle(g.Mesh, h);
    }
    for (Index h = 0; h < g.Mesh.GetNumberOfHalfEdges(); ++h)
    {
      const Index v = g.Mesh.Tail(h);
      EXPECT_NEAR(sum[v], g.Transport.AngleSum[v], 1e-13);
      EXPECT_NEAR(g.Transport.CornerAngle(g.Mesh, h) / sum[v],
        g.Lengths.CornerAngle(g.Mesh, h) / unscaled[v], 1e-13);
    }
  }
}
