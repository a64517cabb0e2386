// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Meshes/Surfaces.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

TEST(ConstraintRules, PriorityIsGivenBoundarySharpCurvature)
{
  // A sheet folded by 90 degrees along the line x = 1 from border to border.
  Surface fold = Square(8, 2.0);
  for (Vector3& p : fold.Points)
  {
    if (p.x() > 1.0)
    {
      p = { 1.0, p.y(), 1.0 - p.x() };
    }
  }
  const auto at = [](int i, int j) { return static_cast<Index>(9 * j + i); };
  Options options;
  options.ConstrainBoundary = true;
  options.ConstrainSharpEdges = true;
  options.ConstrainCurvature = true;
  options.ConstrainGuidance = true;
  const Vector3 oblique(0.3, 1.0, 0.0);
  const Result result = DirectionField(fold).Compute(options,
    GuidanceAt(fold, { { at(4, 4), oblique }, { at(0, 4), oblique }, { at(2, 2), oblique } }));
  EXPECT_EQ(result.Constraint[at(4, 4)], ConstraintKind::Given);
  EXPECT_EQ(result.Constraint[at(0, 4)], ConstraintKind::Given);
  EXPECT_EQ(result.Constraint[at(2, 2)], ConstraintKind::Given);
  EXPECT_EQ(result.Constraint[at(4, 0)], ConstraintKind::Boundary);
  EXPECT_EQ(result.Constraint[at(8, 3)], ConstraintKind::Boundary);
  EXPECT_EQ(result.Constraint[at(4, 3)], ConstraintKind::SharpEdge);
  EXPECT_EQ(result.Constraint[at(2, 4)], ConstraintKind::None);
  EXPECT_EQ(Count(result, ConstraintKind::Given), 3);
  EXPECT_EQ(Count(result, ConstraintKind::SharpEdge), 6);
  EXPECT_EQ(Count(result, ConstraintKind::Boundary), 31);
  // Without the sharp edges their vertices are the curved ones.
  options.ConstrainSharpEdges = false;
  options.ConstrainBoundary = false;
  options.ConsistencyAngle = 45.0;
  options.CurvatureTolerance = 1.0;
  const Result curved =
    DirectionField(fold).Compute(options, GuidanceAt(fold, { { at(2, 2), oblique } }));
  EXPECT_EQ(curved.Constraint[at(4, 4)], ConstraintKind::Curvature);
  EXPECT_LT(Deviation(curved, at(4, 4), Vector3::UnitY()), 5.0);
}

TEST(ConstraintRules, FeatureAngleDecidesWhatIsSharp)
{
  DirectionField field(Transformed(ChamferedCube(4), Eigen::Matrix3d::Identity(), { 0, 0, 0 }));
  Options options;
  options.ConstrainSharpEdges = true;
  options.FeatureAngle = 44.0;
  EXPECT_GT(field.Compute(options).Components[0].Constraints, 0);
  EXPECT_TRUE(field.Compute(options).Notes.empty());
  options.FeatureAngle = 46.0;
  const Result blunt = field.Compute(options);
  EXPECT_EQ(blunt.Components[0].Constraints, 0);
  EXPECT_TRUE(blunt.Constraint.empty());
  EXPECT_EQ(blunt.Notes.size(), 1u);
}

TEST(ConstraintRules, InconsistentCurvatureIsDropped)
{
  // On a cylinder the curvature runs around; one given direction contradicts it.
  const Surface cylinder = Cylinder(24, 8, 2.0);
  const Index point = 24 * 4 + 3;
  const Vector3& p = cylinder.Points[point];
  const Vector3 around(-p.y(), p.x(), 0.0);
  Options options;
  options.ConstrainCurvature = true;
  options.CurvatureTolerance = 0.1;
  options.ConstrainGuidance = true;
  const auto curvatures = [&](double degrees, double bound)
  {
    const double a = degrees * Pi / 180.0;
    options.ConsistencyAngle = bound;
    const Vector3 vector = std::cos(a) * around + std::sin(a) * Vector3::UnitZ();
    const Result result =
      DirectionField(cylinder).Compute(options, GuidanceAt(cylinder, { { point, vector } }));
    EXPECT_EQ(result.Constraint[point], ConstraintKind::Given);
    return Count(result, ConstraintKind::Curvature);
  };
  const Index all = curvatures(0.0, 30.0);
  EXPECT_EQ(all, 24 * 9 - 1);
  EXPECT_EQ(curvatures(25.0, 30.0), all);
  // Its six neighbours go.
  EXPECT_EQ(curvatures(35.0, 30.0), all - 6);
  EXPECT_EQ(curvatures(35.0, 40.0), all);
  // Modulo 90 degrees a cross is the same again.
  EXPECT_EQ(curvatures(80.0, 30.0), all);
}

TEST(ConstraintRules, DropAtSingularitiesIsPellenardsRule)
{
  // The curvature lines of an ellipsoid of revolution wind around its poles.
  Surface egg = Icosphere(4);
  for (Vector3& p : egg.Points)
  {
    p.z() *= 2.5;
  }
  Options options;
  options.ConstrainCurvature = true;
  options.CurvatureTolerance = 0.0;
  options.ConsistencyAngle = 180.0;
  DirectionField field(egg);
  const Index all = Count(field.Compute(options), ConstraintKind::Curvature);
  EXPECT_EQ(all, static_cast<Index>(egg.Points.size()));
  options.DropConstraintsAtSingularities = true;
  const Result dropped = field.Compute(options);
  const Index kept = Count(dropped, ConstraintKind::Curvature);
  EXPECT_LT(kept, all);
  EXPECT_GT(kept, all - 60);
  for (Index i = 0; i < static_cast<Index>(egg.Points.size()); ++i)
  {
    if (dropped.Constraint[i] == ConstraintKind::None)
    {
      EXPECT_GT(std::abs(egg.Points[i].z()), 1.5);
    }
  }
}

TEST(ConstraintRules, NonManifoldEdgesGetACrossOnEachSheet)
{
  // Three half planes that meet in the z axis.
  Surface book;
  const int rows = 6;
  for (int j = 0; j <= rows; ++j)
  {
    book.Points.emplace_back(0.0, 0.0, 1.0 * j / rows);
  }
  for (int sheet = 0; sheet < 3; ++sheet)
  {
    const double angle = 2.0 * Pi * sheet / 3.0 + 0.2;
    const Index first = static_cast<Index>(book.Points.size());
    for (int j = 0; j <= rows; ++j)
    {
      // Slanted at the outside, so that the sheet alone would not choose the axis.
      book.Points.emplace_back(std::cos(angle), std::sin(angle), 1.0 * j / rows + 0.3);
    }
    for (Index j = 0; j < rows; ++j)
    {
      book.Triangles.push_back({ j, first + j, first + j + 1 });
      book.Triangles.push_back({ j, first + j + 1, j + 1 });
    }
  }
  for (const ConstraintSolver solver : { ConstraintSolver::LeastSquares, ConstraintSolver::Energy })
  {
    Options options;
    options.ConstraintSolver = solver;
    const Result result = DirectionField(book).Compute(options);
    EXPECT_EQ(result.Repaired.NonManifoldEdges, rows);
    EXPECT_EQ(result.Repaired.NonManifoldPoints, rows + 1);
    ASSERT_EQ(result.OriginalPoint.size(), book.Points.size() + 2 * (rows + 1));
    EXPECT_EQ(result.Components.size(), 3u);
    EXPECT_EQ(Count(result, ConstraintKind::NonManifold), 3 * (rows + 1));
    ASSERT_EQ(result.SplitTriangles.size(), book.Triangles.size());
    std::vector<int> sheetsOf(result.OriginalPoint.size(), 0);
    for (std::size_t t = 0; t < book.Triangles.size(); ++t)
    {
      for (int c = 0; c < 3; ++c)
      {
        const Index split = result.SplitTriangles[t][c];
        EXPECT_EQ(result.OriginalPoint[split], book.Triangles[t][c]);
        sheetsOf[split] |= 1 << (t / (2 * rows));
        if (book.Triangles[t][c] <= rows)
        {
          EXPECT_LT(Deviation(result, split, Vector3::UnitZ()), 1e-6);
          EXPECT_LT(std::abs(result.Normal[split].z()), 1e-9);
        }
      }
    }
    for (const int sheets : sheetsOf)
    {
      EXPECT_EQ(sheets & (sheets - 1), 0) << "a point belongs to two sheets";
    }
  }
}

TEST(ConstraintRules, WhatIsNotThereChangesNothingAndIsSaid)
{
  const Surface surface = Potato(3);
  DirectionField field(surface);
  const Result plain = field.Compute({});
  Options options;
  options.ConstrainBoundary = true;
  options.ConstrainSharpEdges = true;
  options.ConstrainCurvature = true;
  options.CurvatureTolerance = 1e6;
  const Result result = field.Compute(options);
  EXPECT_EQ(result.Notes.size(), 3u);
  EXPECT_EQ(result.Representation, plain.Representation);
  EXPECT_EQ(result.SingularityIndex, plain.SingularityIndex);
}

TEST(ConstraintRules, CornersOfLinesDependOnNoNumbers)
{
  // The two directions of a right-angled corner cancel for lines, and on a grid both edges weigh the same.
  const Surface square = Square(6, 1.0);
  Options options;
  options.Degree = 2;
  options.ConstrainBoundary = true;
  const Result wanted = DirectionField(square).Compute(options);
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    std::vector<Index> newPoint;
    std::vector<Index> newTriangle;
    Surface shuffled = Shuffled(square, seed, newPoint, newTriangle);
    for (Triangle& triangle : shuffled.Triangles)
    {
      if (seed % 2 == 1)
      {
        std::swap(triangle[0], triangle[1]);
      }
    }
    // Nor on rounding, which the coordinates of any grid have.
    shuffled = Jittered(std::move(shuffled), seed > 2 ? 1e-13 : 0.0, seed);
    const Result found = DirectionField(shuffled).Compute(options);
    for (std::size_t i = 0; i < newPoint.size(); ++i)
    {
      ASSERT_EQ(found.Constraint[newPoint[i]], wanted.Constraint[i]);
      const Vector3 cross =
        found.ConstraintDirection[newPoint[i]].cross(wanted.ConstraintDirection[i]);
      EXPECT_LT(cross.norm(), 1e-11) << "point " << i << ", seed " << seed;
    }
  }
}

TEST(ConstraintRules, LonelyCurvatureIsDropped)
{
  // Noise is curved everywhere, but neighbours seldom agree on how.
  const Surface noisy = Jittered(Potato(5), 0.012, 3);
  const auto singular = [](const Result& result)
  {
    return static_cast<Index>(result.SingularityIndex.size() -
      std::count(result.SingularityIndex.begin(), result.SingularityIndex.end(), 0));
  };
  Options options;
  options.ConstrainCurvature = true;
  const Result result = DirectionField(noisy).Compute(options);
  EXPECT_GT(Count(result, ConstraintKind::Curvature), 200);
  EXPECT_LE(singular(result), 60);
  std::vector<Index> neighbours(noisy.Points.size(), 0);
  for (const Triangle& t : noisy.Triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      neighbours[t[c]] += result.Constraint[t[(c + 1) % 3]] != ConstraintKind::None;
    }
  }
  Index lonely = 0;
  for (std::size_t i = 0; i < neighbours.size(); ++i)
  {
    lonely += result.Constraint[i] != ConstraintKind::None && neighbours[i] == 0;
  }
  EXPECT_LE(lonely, Count(result, ConstraintKind::Curvature) / 50);
}

TEST(ConstraintRules, LeastSquaresBeyondTheirReachAreRefused)
{
  const Surface large = Square(501);
  ASSERT_GT(large.Points.size(), static_cast<std::size_t>(MostLeastSquaresVertices));
  Options options;
  options.ConstrainBoundary = true;
  options.ConstraintSolver = ConstraintSolver::LeastSquares;
  try
  {
    DirectionField(large).Compute(options);
    ADD_FAILURE() << "not refused";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("Set Constraint Solver to Energy"), std::string::npos);
  }
}

/// Where all diagonals of a square tube's sides slant in one way, the projections of a sharp edge's neighbours stand
/// at other angles to it than in the tangent cone. The sides can be unrolled: along the edges the field is parallel.
TEST(ConstraintRules, AFieldBesideSharpEdgesIsNotTurnedAgainstThem)
{
  constexpr int cells = 4;
  Surface tube = Cylinder(4 * cells, 10, 4.0);
  for (std::size_t i = 0; i < tube.Points.size(); ++i)
  {
    const int around = static_cast<int>(i) % (4 * cells);
    const Vector3 corner = Eigen::AngleAxisd(0.5 * Pi * (around / cells), Vector3::UnitZ()) *
      Vector3(1.0, 2.0 * (around % cells) / cells - 1.0, 0.0);
    tube.Points[i] = { corner.x(), corner.y(), tube.Points[i].z() };
  }
  for (const bool unit : { false, true })
  {
    for (const int degree : { 1, 2, 4 })
    {
      Options options;
      options.Degree = degree;
      options.ConstrainSharpEdges = true;
      options.UnitLength = unit;
      const Result result = DirectionField(tube).Compute(options);
      EXPECT_EQ(Count(result, ConstraintKind::SharpEdge), 4 * 11);
      for (std::size_t i = 0; i < tube.Points.size(); ++i)
      {
        EXPECT_LT(Deviation(result, static_cast<Index>(i), Vector3::UnitZ()), 1e-3);
        EXPECT_LT(result.EnergyDensity[i], 1e-12);
      }
    }
  }
}
