// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/Stages.h"
#include "Features/Creases.h"
#include "Geometry/DihedralAngles.h"
#include "Meshes/Surfaces.h"
#include "Meshes/System.h"
#include "SparseCholesky/SupernodalCholesky.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
std::vector<double> Dihedrals(const Surface& surface)
{
  return DihedralAngles(SurfaceGeometry(surface));
}

using Gradient = std::function<Vector3(const Vector3&)>;

Vector3 EllipsoidGradient(const Vector3& p)
{
  return { p.x() / 1.96, p.y(), p.z() / 0.49 };
}

/// Of the torus of radii 1 and 0.4.
Vector3 TorusGradient(const Vector3& p)
{
  const double r = std::hypot(p.x(), p.y());
  return { p.x() * (1.0 - 1.0 / r), p.y() * (1.0 - 1.0 / r), p.z() };
}

Surface Ellipsoid(Surface sphere)
{
  for (Vector3& p : sphere.Points)
  {
    p = p.normalized().cwiseProduct(Vector3(1.4, 1.0, 0.7));
  }
  return sphere;
}

/// Points moved along the torus, so that the density of the mesh varies fourfold.
Surface GradedTorus(int n)
{
  Surface s = Torus(n, n / 2);
  for (std::size_t i = 0; i < s.Points.size(); ++i)
  {
    const double a0 = 2.0 * Pi * static_cast<double>(i % n) / n;
    const double b0 = 2.0 * Pi * static_cast<double>(i / n) / (n / 2);
    const double a = a0 + 0.6 * std::sin(a0);
    const double b = b0 + 0.5 * std::sin(b0);
    const double r = 1.0 + 0.4 * std::cos(b);
    s.Points[i] = { r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b) };
  }
  return s;
}

/// Relative errors against the shape operator of an implicit surface.
struct Errors
{
  /// In the L2 norm.
  double Hopf;
  double Mean;
  double Gaussian;
  /// In the dual of the energy's norm, with the length 1, as the aligned system sees it.
  double WeakHopf;
};

Errors Compare(const Surface& surface, const Gradient& gradient)
{
  Stages stages(surface);
  const Curvature& curvature = stages.GetCurvature();
  const TriangleMesh& mesh = stages.GetMesh();
  const double unit = stages.GetGeometry().Lengths.Unit[0];
  const auto normal = [&](const Vector3& p) -> Vector3 { return gradient(p).normalized(); };
  const Index n = mesh.GetNumberOfVertices();
  ComplexVector exact(n);
  ComplexVector found(n);
  Eigen::VectorXd area = Eigen::VectorXd::Zero(n);
  for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    area[mesh.Tail(h)] += stages.GetGeometry().Lengths.Area[h / 3];
  }
  Eigen::Vector2d error(0, 0);
  Eigen::Vector2d size(0, 0);
  for (Index v = 0; v < n; ++v)
  {
    const Vector3& p = surface.Points[mesh.Point(v)];
    Eigen::Matrix3d shape;
    constexpr double step = 1e-5;
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 d = step * Vector3::Unit(k);
      shape.col(k) = (normal(p + d) - normal(p - d)) / (2.0 * step);
    }
    const Vector3& x = stages.GetGeometry().Frames.X[v];
    const Vector3 y = stages.GetGeometry().Frames.Y(v);
    const double xx = x.dot(shape * x);
    const double yy = y.dot(shape * y);
    const double xy = 0.5 * (x.dot(shape * y) + y.dot(shape * x));
    exact[v] = Complex(0.5 * (xx - yy), xy);
    found[v] = curvature.Hopf[v] / unit;
    const Eigen::Vector2d invariants(0.5 * (xx + yy), xx * yy - xy * xy);
    const Eigen::Vector2d computed(curvature.Mean[v] / unit, curvature.Gaussian[v] / unit / unit);
    error += area[v] * (computed - invariants).cwiseAbs2();
    size += area[v] * invariants.cwiseAbs2();
  }
  const Operators operators =
    AssembleOperators(stages.GetGeometry(), mesh.GetComponents()[0], 2, 0.0);
  ComplexCholesky factor;
  EXPECT_TRUE(factor.Compute(operators.Energy + unit * unit * operators.Mass));
  const auto weak = [&](const ComplexVector& q)
  {
    const ComplexVector mq = operators.Mass * q;
    return std::sqrt(mq.dot(factor.Solve(mq)).real());
  };
  const auto strong = [&](const ComplexVector& q)
  { return std::sqrt(q.dot(operators.Mass * q).real()); };
  return { strong(found - exact) / strong(exact), std::sqrt(error[0] / size[0]),
    std::sqrt(error[1] / size[1]), weak(found - exact) / weak(exact) };
}
}

TEST(Curvature, ConvergesOnStructuredMeshes)
{
  Errors ellipsoid = Compare(Ellipsoid(Icosphere(2)), EllipsoidGradient);
  for (int level = 3; level <= 5; ++level)
  {
    const Errors finer = Compare(Ellipsoid(Icosphere(level)), EllipsoidGradient);
    EXPECT_LT(finer.Hopf, 0.55 * ellipsoid.Hopf);
    EXPECT_LT(finer.Mean, 0.55 * ellipsoid.Mean);
    EXPECT_LT(finer.Gaussian, 0.55 * ellipsoid.Gaussian);
    ellipsoid = finer;
  }
  EXPECT_LT(ellipsoid.Hopf, 0.03);
  Errors torus = Compare(Torus(20, 10), TorusGradient);
  for (const int n : { 40, 80 })
  {
    const Errors finer = Compare(Torus(n, n / 2), TorusGradient);
    EXPECT_LT(finer.Hopf, 0.27 * torus.Hopf);
    EXPECT_LT(finer.Mean, 0.27 * torus.Mean);
    EXPECT_LT(finer.Gaussian, 0.27 * torus.Gaussian);
    torus = finer;
  }
  EXPECT_LT(torus.Hopf, 0.003);
}

TEST(Curvature, ConvergesWhereTheDensityVaries)
{
  // Without the inverse of the mass matrix q would follow the size of the triangles.
  Errors torus = Compare(GradedTorus(40), TorusGradient);
  for (const int n : { 80, 160 })
  {
    const Errors finer = Compare(GradedTorus(n), TorusGradient);
    EXPECT_LT(finer.Hopf, 0.35 * torus.Hopf);
    torus = finer;
  }
  EXPECT_LT(torus.Hopf, 0.005);
}

TEST(Curvature, ConvergesWeaklyOnIrregularMeshes)
{
  // Curvature measures of random meshes converge as measures, not at single vertices.
  double before = 1.0;
  for (int level = 2; level <= 5; ++level)
  {
    const Surface sphere = Jittered(Icosphere(level), 0.33 / (1 << level), level);
    const Errors errors = Compare(Ellipsoid(sphere), EllipsoidGradient);
    EXPECT_LT(errors.WeakHopf, 0.75 * before);
    before = errors.WeakHopf;
  }
  EXPECT_LT(before, 0.06);
}

TEST(Curvature, DihedralAnglesAreSignedAndExact)
{
  const Surface cube = Cube();
  int right = 0;
  for (const double angle : Dihedrals(cube))
  {
    EXPECT_TRUE(std::abs(angle) < 1e-12 || std::abs(angle - 0.5 * Pi) < 1e-12) << angle;
    right += angle > 1.0;
  }
  EXPECT_EQ(right, 12);
  Surface inside = cube;
  for (Triangle& t : inside.Triangles)
  {
    std::swap(t[0], t[1]);
  }
  for (const double angle : Dihedrals(inside))
  {
    EXPECT_LT(angle, 1e-12);
  }
  const Surface disk = Disk(3);
  for (const double angle : Dihedrals(disk))
  {
    EXPECT_EQ(angle, 0.0);
  }
}

TEST(Curvature, SphereIsUmbilic)
{
  Stages stages(Transformed(Icosphere(4), 2.5 * Eigen::Matrix3d::Identity(), { 1, 2, 3 }));
  const Curvature& curvature = stages.GetCurvature();
  const double unit = stages.GetGeometry().Lengths.Unit[0];
  double meanError = 0.0;
  double gaussianError = 0.0;
  for (std::size_t v = 0; v < curvature.Mean.size(); ++v)
  {
    // A third of the incident area is a sixth too small at the twelve vertices of valence five.
    const double mean = curvature.Mean[v] / unit * 2.5;
    const double gaussian = curvature.Gaussian[v] / unit / unit * 6.25;
    EXPECT_NEAR(mean, 1.0, 0.16);
    EXPECT_NEAR(gaussian, 1.0, 0.16);
    EXPECT_LT(std::abs(curvature.Hopf[v]) / unit * 2.5, 0.16);
    meanError += std::abs(mean - 1.0);
    gaussianError += std::abs(gaussian - 1.0);
  }
  EXPECT_LT(meanError / static_cast<double>(curvature.Mean.size()), 0.01);
  EXPECT_LT(gaussianError / static_cast<double>(curvature.Mean.size()), 0.01);
}

/// Angles and Laplacians by the formulas of trigonometry. On a cube all vertices but those within its faces are
/// on creases; a tetrahedron has too few points for quadrics.
TEST(Curvature, IsThatOfTheEdgesOnCreases)
{
  for (const Surface& surface : { ChamferedCube(6), Folded(Square(20), 1.0), Tetrahedron() })
  {
    const System system(surface, 2, 0.0);
    const std::vector<double> dihedral = DihedralAngles(system);
    const Curvature curvature(system, dihedral);
    const Creases creases(system, dihedral);
    std::vector<Index> fan;
    Index bent = 0;
    for (Index v = 0; v < system.Mesh.GetNumberOfVertices(); ++v)
    {
      if (creases.Vertex[v] == 0 && surface.Points.size() > 4)
      {
        continue;
      }
      ++bent;
      double angle = 0.0;
      double area = 0.0;
      Vector3 laplacian = Vector3::Zero();
      Complex hopf = 0.0;
      system.Mesh.GetFan(v, fan);
      for (const Index h : fan)
      {
        const std::array<double, 3> corners = system.Lengths.CornerAngles(system.Mesh, h / 3);
        const Index next = TriangleMesh::Next(h);
        const Index previous = TriangleMesh::Previous(h);
        angle += corners[h % 3];
        area += system.Lengths.Area[h / 3] / 3.0;
        laplacian += 0.5 / std::tan(corners[previous % 3]) *
          (system.Positions[system.Mesh.Tail(next)] - system.Positions[v]);
        laplacian += 0.5 / std::tan(corners[next % 3]) *
          (system.Positions[system.Mesh.Tail(previous)] - system.Positions[v]);
        const Index edge = system.Mesh.Edge(h);
        hopf -= 0.25 * dihedral[edge] * std::sqrt(system.Lengths.SquaredLength[edge]) *
          std::polar(1.0, 2.0 * system.Transport.EdgeAngle[h]);
      }
      laplacian /= system.Lengths.Unit[0] * area;
      const bool boundary = system.Mesh.IsBoundary(v);
      EXPECT_NEAR(std::abs(curvature.Mean[v]),
        0.5 * (boundary ? std::abs(laplacian.dot(system.Frames.Normal[v])) : laplacian.norm()),
        1e-11 * (1.0 + laplacian.norm()));
      EXPECT_NEAR(curvature.Gaussian[v], boundary ? 0.0 : (2.0 * Pi - angle) / area, 1e-13 / area);
      EXPECT_LT(std::abs(curvature.Hopf[v] - hopf / area), 1e-13 * std::abs(hopf) / area);
    }
    EXPECT_GE(bent, 4);
  }
}

TEST(Curvature, ResultsOfOneSurfaceShareIt)
{
  // Triangles that share no points are flat pieces each, unless the points are merged.
  const Surface surface = Soup(Potato(2));
  DirectionField solver(surface);
  Options options;
  options.MergePoints = MergePoints::Off;
  EXPECT_EQ(solver.Compute(options).Curvature, nullptr);
  options.Alignment = Alignment::PrincipalCurvature;
  const Result pieces = solver.Compute(options);
  ASSERT_NE(pieces.Curvature, nullptr);
  options.AlignmentStrength = 0.8;
  EXPECT_EQ(solver.Compute(options).Curvature, pieces.Curvature);
  options.Degree = 2;
  options.Alignment = Alignment::None;
  EXPECT_EQ(solver.Compute(options).Curvature, nullptr);
  options.ConstrainCurvature = true;
  EXPECT_EQ(solver.Compute(options).Curvature, pieces.Curvature);
  options.MergePoints = MergePoints::On;
  const Result merged = solver.Compute(options);
  EXPECT_EQ(merged.Curvature->Mean, DirectionField(surface).Compute(options).Curvature->Mean);
  EXPECT_NE(merged.Curvature->Mean, pieces.Curvature->Mean);
  options.MergePoints = MergePoints::Off;
  EXPECT_EQ(solver.Compute(options).Curvature->Mean, pieces.Curvature->Mean);
}
