// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fields whose energy is that of the intrinsic Delaunay triangulation.

#include "Geometry/IntrinsicTriangulation.h"
#include "Geometry/SurfaceGeometry.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
/// A field that must have converged.
Result ComputeSound(const Surface& surface, int degree, bool delaunay)
{
  Options options;
  options.Degree = degree;
  options.IntrinsicDelaunay = delaunay;
  const Result result = DirectionField(surface).Compute(options);
  for (const ComponentReport& component : result.Components)
  {
    EXPECT_TRUE(component.Converged);
    if (component.Closed)
    {
      EXPECT_EQ(component.IndexSum, degree * component.EulerCharacteristic);
    }
  }
  return result;
}

double Eigenvalue(const Surface& surface, int degree, bool delaunay)
{
  return ComputeSound(surface, degree, delaunay).Components.at(0).Eigenvalue;
}
}

TEST(IntrinsicDelaunay, DelaunayMeshesStayBitForBit)
{
  for (const Surface& surface : { Icosphere(3), Square(6), Disk(5), Cube(), Hemisphere(3) })
  {
    const SurfaceGeometry g(surface);
    const IntrinsicTriangulation delaunay(g);
    EXPECT_EQ(delaunay.NumberOfFlips, 0);
    EXPECT_EQ(delaunay.Lengths.SquaredLength, g.Lengths.SquaredLength);
    EXPECT_EQ(delaunay.Lengths.Area, g.Lengths.Area);
    EXPECT_EQ(delaunay.Transport.EdgeAngle, g.Transport.EdgeAngle);
    EXPECT_EQ(delaunay.Transport.Rotation, g.Transport.Rotation);
    EXPECT_EQ(delaunay.Transport.Curvature, g.Transport.Curvature);
    const Result with = ComputeSound(surface, 4, true);
    const Result without = ComputeSound(surface, 4, false);
    EXPECT_EQ(with.Representation, without.Representation);
    EXPECT_EQ(with.SingularityIndex, without.SingularityIndex);
  }
}

TEST(IntrinsicDelaunay, KeepsParallelFieldsOfBadlyTriangulatedPlanes)
{
  for (const Surface& surface : { BadSquare(9, 1), Folded(BadSquare(12, 2), 0.9) })
  {
    for (const int degree : { 1, 4, 6 })
    {
      const Result result = ComputeSound(surface, degree, true);
      EXPECT_NEAR(result.Components[0].Eigenvalue, 0.0, 1e-9);
      const Result without = ComputeSound(surface, degree, false);
      for (std::size_t i = 0; i < surface.Points.size(); ++i)
      {
        EXPECT_NEAR(std::abs(result.Representation[i] - without.Representation[i]), 0.0, 1e-6);
      }
    }
  }
}

TEST(IntrinsicDelaunay, IsTheSameHoweverTheSurfaceIsTriangulated)
{
  for (const Surface& surface :
    { FlatlySubdivided(Jittered(Torus(9, 7), 0.05, 4), 2), FlatlySubdivided(Potato(1), 2) })
  {
    const Surface bad = Scrambled(surface, 8);
    ASSERT_GT(IntrinsicTriangulation(SurfaceGeometry(bad)).NumberOfFlips, 200);
    for (const int degree : { 1, 4 })
    {
      const double expected = Eigenvalue(surface, degree, true);
      EXPECT_NEAR(Eigenvalue(bad, degree, true) / expected, 1.0, 1e-9);
      EXPECT_GT(std::abs(Eigenvalue(bad, degree, false) / expected - 1.0), 1e-3);
    }
  }
}

TEST(IntrinsicDelaunay, EigenvaluesOfASphereOfSliversComeCloserToTheSmoothSpheres)
{
  for (const int degree : { 1, 2, 4 })
  {
    double with = 0.0;
    double without = 0.0;
    for (const unsigned seed : { 1, 2, 3, 4 })
    {
      const Surface sphere = BadSphere(3, 0.14, seed);
      with += std::abs(Eigenvalue(sphere, degree, true) - degree);
      without += std::abs(Eigenvalue(sphere, degree, false) - degree);
    }
    EXPECT_LT(with, 0.8 * without) << with << ' ' << without;
  }
}

TEST(IntrinsicDelaunay, DegenerateTrianglesGiveAFiniteField)
{
  Surface surface = BadSphere(2, 0.2, 8);
  surface.Points[surface.Triangles[10][0]] = surface.Points[surface.Triangles[10][1]];
  surface.Points[surface.Triangles[200][0]] = 0.3 * surface.Points[surface.Triangles[200][1]] +
    0.7 * surface.Points[surface.Triangles[200][2]];
  const Surface point{ { { 2, 2, 2 }, { 2, 2, 2 }, { 2, 2, 2 } }, { { 0, 1, 2 } } };
  for (const Surface& s : { surface, FlatlySubdivided(surface, 1), point })
  {
    const Result result = ComputeSound(s, 4, true);
    for (const Complex& u : result.Representation)
    {
      EXPECT_TRUE(std::isfinite(std::abs(u)));
    }
  }
}

TEST(IntrinsicDelaunay, EverythingButTheOperatorsStays)
{
  const Surface surface = Jittered(ChamferedCube(5), 0.04, 3);
  Options options;
  options.Alignment = Alignment::PrincipalCurvature;
  options.ConstrainSharpEdges = true;
  options.ConstrainCurvature = true;
  DirectionField field(surface);
  for (const ConstraintSolver solver : { ConstraintSolver::LeastSquares, ConstraintSolver::Energy })
  {
    options.ConstraintSolver = solver;
    options.IntrinsicDelaunay = false;
    const Result without = field.Compute(options);
    options.IntrinsicDelaunay = true;
    const Result with = field.Compute(options);
    EXPECT_TRUE(with.Components[0].Converged);
    EXPECT_EQ(with.Components[0].IndexSum, 8);
    EXPECT_EQ(with.Constraint, without.Constraint);
    EXPECT_EQ(with.ConstraintDirection, without.ConstraintDirection);
    EXPECT_EQ(with.Curvature, without.Curvature);
    EXPECT_EQ(with.Normal, without.Normal);
    EXPECT_EQ(with.XAxis, without.XAxis);
    EXPECT_NE(with.Components[0].Eigenvalue, without.Components[0].Eigenvalue);
    EXPECT_NE(with.Representation, without.Representation);
    for (std::size_t i = 0; i < surface.Points.size(); ++i)
    {
      if (with.Constraint[i] != ConstraintKind::None)
      {
        EXPECT_LT(Deviation(with, static_cast<Index>(i), with.ConstraintDirection[i]), 1e-5);
      }
    }
    // The stages kept between calls are those of the option.
    const Result fresh = DirectionField(surface).Compute(options);
    EXPECT_EQ(fresh.Representation, with.Representation);
    options.IntrinsicDelaunay = false;
    EXPECT_EQ(field.Compute(options).Representation, without.Representation);
  }
}

TEST(IntrinsicDelaunay, DependsOnTheShapeOnlyAndOnNoThreads)
{
  const Surface surface = Jittered(Potato(3), 0.06, 11);
  ASSERT_GT(IntrinsicTriangulation(SurfaceGeometry(surface)).NumberOfFlips, 50);
  const Result result = ComputeSound(surface, 4, true);
  std::vector<Index> newPoint;
  std::vector<Index> newTriangle;
  const Eigen::Matrix3d rotation = ObliqueRotation(1.9);
  const Surface other =
    Transformed(Shuffled(surface, 5, newPoint, newTriangle), 1e3 * rotation, { 5e3, 1, 2 });
  const Result moved = ComputeSound(other, 4, true);
  EXPECT_NEAR(moved.Components[0].Eigenvalue * 1e6 / result.Components[0].Eigenvalue, 1.0, 1e-9);
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    EXPECT_EQ(moved.SingularityIndex[newTriangle[t]], result.SingularityIndex[t]);
  }
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    EXPECT_NEAR(
      std::abs(moved.Representation[newPoint[i]]), std::abs(result.Representation[i]), 1e-5);
  }

  Options options;
  options.IntrinsicDelaunay = true;
  for (const int threads : { 1, 2, 5 })
  {
    options.NumberOfThreads = threads;
    EXPECT_EQ(DirectionField(surface).Compute(options).Representation, result.Representation);
  }
}
