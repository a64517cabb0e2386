// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/Stages.h"
#include "DirectionField.h"
#include "Guidance/CurveGuidance.h"
#include "Guidance/SoftConstraints.h"
#include "Meshes/Surfaces.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

using namespace DirectionFields;
using namespace DirectionFields::Internal;
using namespace Meshes;

namespace
{
/// A direction 20 degrees from the sides of a square.
const Vector3 Oblique(std::cos(Pi / 9.0), std::sin(Pi / 9.0), 0.0);
/// A direction 35 degrees from them.
const Vector3 Steep(std::cos(7.0 * Pi / 36.0), std::sin(7.0 * Pi / 36.0), 0.0);

/// A flat square of side 1 with irregular triangles.
Surface Sheet(int cells)
{
  const Surface even = Square(cells);
  Surface sheet = Jittered(even, 0.2 / cells, 1);
  for (std::size_t i = 0; i < sheet.Points.size(); ++i)
  {
    const Vector3& p = even.Points[i];
    const bool isInside = std::min(p.x(), p.y()) > 1e-9 && std::max(p.x(), p.y()) < 1.0 - 1e-9;
    sheet.Points[i] = isInside ? Vector3(sheet.Points[i].x(), sheet.Points[i].y(), 0.0) : p;
  }
  return sheet;
}

/// Crosses along the sides of a square, and of other directions that it is given.
Options AlongSides()
{
  Options options;
  options.ConstrainBoundary = true;
  options.ConstrainGuidance = true;
  return options;
}

/// A stroke through the middle of a square of side 1.
std::vector<Vector3> Stroke(const Vector3& direction, const Vector3& middle = { 0.5, 0.5, 0.0 })
{
  return { middle - 0.2 * direction, middle + 0.2 * direction };
}

Guidance Along(const Surface& surface, const std::vector<std::vector<Vector3>>& curves,
  const std::vector<double>& strengths)
{
  CurveGuidanceOptions options;
  options.Strengths = strengths;
  const CurveGuidance made = GuideByCurves(surface, curves, options);
  return { made.Vectors, made.Weights, made.Strengths };
}

/// The mean angle in degrees between a field and a direction at the points with guidance.
double MeanDeviation(const Result& field, const Guidance& guidance, const Vector3& direction)
{
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < guidance.Weights.size(); ++i)
  {
    if (guidance.Weights[i] > 0.0)
    {
      sum += Deviation(field, static_cast<Index>(i), direction);
      count += 1.0;
    }
  }
  return sum / count;
}

/// The section of (A + W) u = W g, solved densely, W from the areas of triangles; vertices of
/// strength 1 have the value g.
ComplexVector DenseSolution(
  const SurfaceGeometry& geometry, ComponentStage& stage, const Guidance& guidance)
{
  Eigen::MatrixXcd matrix(stage.GetMatrices().Energy);
  ComplexVector right = ComplexVector::Zero(matrix.rows());
  std::vector<double> areas(matrix.rows(), 0.0);
  for (Index h = 0; h < 3 * geometry.Mesh.GetNumberOfTriangles(); ++h)
  {
    areas[geometry.Mesh.Tail(h)] += geometry.Lengths.Area[h / 3] / 3.0;
  }
  double longest = 0.0;
  for (const Vector3& vector : guidance.Vectors)
  {
    longest = std::max(longest, vector.lpNorm<Eigen::Infinity>());
  }
  std::vector<Index> held;
  for (Index v = 0; v < matrix.rows(); ++v)
  {
    const Index point = geometry.Mesh.Point(v);
    const Complex z = geometry.Frames.Tangential(v, guidance.Vectors[point]);
    const double strength = guidance.Strengths[point];
    const Complex g = std::polar(1.0, 4.0 * std::arg(z));
    if (strength == 1.0)
    {
      held.push_back(v);
      right[v] = g;
    }
    else if (strength > 0.0)
    {
      const double w = std::abs(z) * guidance.Weights[point] / longest * strength /
        (1.0 - strength) * std::sqrt(stage.Sigma() * areas[v]);
      matrix(v, v) += w;
      right[v] += w * g;
    }
  }
  for (const Index v : held)
  {
    const Complex g = right[v];
    right -= matrix.col(v) * g;
    matrix.col(v).setZero();
    matrix.row(v).setZero();
    matrix(v, v) = 1.0;
    right[v] = g;
  }
  return matrix.ldlt().solve(right);
}
}

TEST(SoftConstraints, FieldsSolveTheSystemWithTheTermsOnItsDiagonal)
{
  // On an irregular closed surface. Only beside a hard vertex is the length of the pull told.
  const Surface surface = Jittered(Potato(2), 0.03, 3);
  Options options;
  options.ConstrainGuidance = true;
  options.Tolerance = 1e-10;
  for (const double last : { 0.7, 1.0 })
  {
    Guidance guidance;
    guidance.Vectors.assign(surface.Points.size(), Vector3::Zero());
    guidance.Weights.assign(surface.Points.size(), 0.0);
    guidance.Strengths.assign(surface.Points.size(), 0.0);
    const double strengths[] = { 0.2, 0.5, 0.9, last };
    for (int k = 0; k < 4; ++k)
    {
      guidance.Vectors[20 * k] = { 1.0, 0.3 * k, -0.2 };
      guidance.Weights[20 * k] = 1.0 - 0.25 * k;
      guidance.Strengths[20 * k] = strengths[k];
    }
    Stages stages(surface);
    const SurfaceGeometry& geometry = stages.GetGeometry();
    const ComplexVector exact =
      DenseSolution(geometry, stages.GetEnergy(options, {}).Components[0], guidance);
    for (const Solver solver : { Solver::Direct, Solver::Multigrid })
    {
      options.Solver = solver;
      const Result result = DirectionField(surface).Compute(options, guidance);
      EXPECT_TRUE(result.Components[0].Converged);
      EXPECT_EQ(result.Components[0].Constraints, last == 1.0 ? 1 : 0);
      for (Index v = 0; v < exact.size(); ++v)
      {
        const double angle = std::arg(exact[v]) / 4.0;
        const Vector3 direction =
          std::cos(angle) * geometry.Frames.X[v] + std::sin(angle) * geometry.Frames.Y(v);
        EXPECT_LT(Deviation(result, geometry.Mesh.Point(v), direction), 1e-4);
      }
    }
  }
}

TEST(SoftConstraints, DeviationsFallWithTheStrengthFromTheFreeFieldToNone)
{
  for (const bool isUnit : { false, true })
  {
    const Surface surface = Sheet(24);
    DirectionField solver(surface);
    Options options = AlongSides();
    options.UnitLength = isUnit;
    double last = 20.01;
    for (const double strength : { 0.0, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 1.0 })
    {
      const Guidance guidance = Along(surface, { Stroke(Oblique) }, { strength });
      const Guidance all = Along(surface, { Stroke(Oblique) }, {});
      const Result result = solver.Compute(options, guidance);
      const double deviation = MeanDeviation(result, all, Oblique);
      EXPECT_LT(deviation, last) << strength;
      EXPECT_TRUE(strength > 0.01 || deviation > 19.0) << strength << ": " << deviation;
      EXPECT_TRUE(strength != 0.5 || (deviation > 1.0 && deviation < 15.0)) << deviation;
      last = deviation;
    }
    // What is left are the curve's tangents in the corners' own frames.
    EXPECT_LT(last, 1e-4);
  }
}

TEST(SoftConstraints, StrokesOfStrengthOneAreExactBesideSoftOnes)
{
  const Surface surface = Sheet(24);
  const Vector3 low(0.5, 0.3, 0.0);
  const Vector3 high(0.5, 0.7, 0.0);
  const std::vector<std::vector<Vector3>> curves = { Stroke(Oblique, low), Stroke(Steep, high) };
  for (const bool isUnit : { false, true })
  {
    for (const Solver solver : { Solver::Direct, Solver::Multigrid })
    {
      Options options = AlongSides();
      options.UnitLength = isUnit;
      options.Solver = solver;
      const Guidance both = Along(surface, curves, { 1.0, 0.5 });
      const Result result = DirectionField(surface).Compute(options, both);
      double soft = 0.0;
      for (std::size_t i = 0; i < both.Strengths.size(); ++i)
      {
        const auto point = static_cast<Index>(i);
        if (both.Weights[i] > 0.0 && both.Strengths[i] == 1.0)
        {
          EXPECT_EQ(result.Constraint[i], ConstraintKind::Given);
          EXPECT_LT(Deviation(result, point, Oblique), 1e-4);
        }
        else if (both.Weights[i] > 0.0)
        {
          EXPECT_EQ(result.Constraint[i], ConstraintKind::None);
          soft = std::max(soft, Deviation(result, point, Steep));
        }
      }
      EXPECT_GT(soft, 1.0);
      EXPECT_LT(soft, 34.0);
    }
  }
}

TEST(SoftConstraints, StrengthOneEverywhereIsAsWithoutStrengths)
{
  const Surface surface = Potato(3);
  Options options;
  options.ConstrainGuidance = true;
  Guidance guidance = GuidanceAt(surface, { { 7, { 1, 0.2, 0.3 } }, { 60, { 0, 1, 0.5 } } });
  const Result without = DirectionField(surface).Compute(options, guidance);
  guidance.Strengths.assign(surface.Points.size(), 1.0);
  const Result with = DirectionField(surface).Compute(options, guidance);
  guidance.Strengths.assign(surface.Points.size(), 7.0);
  const Result more = DirectionField(surface).Compute(options, guidance);
  for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
  {
    EXPECT_EQ(without.Direction(i, 0), with.Direction(i, 0));
    EXPECT_EQ(without.Direction(i, 0), more.Direction(i, 0));
  }
  // Others than numbers, and zero, are no constraints.
  guidance.Strengths.assign(surface.Points.size(), std::numeric_limits<double>::quiet_NaN());
  const Result none = DirectionField(surface).Compute(options, guidance);
  EXPECT_EQ(none.Notes.size(), 1u);
  options.ConstrainGuidance = false;
  const Result smoothest = DirectionField(surface).Compute(options);
  for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
  {
    EXPECT_EQ(none.Direction(i, 0), smoothest.Direction(i, 0));
  }
  guidance.Strengths.resize(3);
  options.ConstrainGuidance = true;
  EXPECT_THROW(DirectionField(surface).Compute(options, guidance), std::invalid_argument);
}

TEST(SoftConstraints, StrokesWeighAsMuchOnFineMeshesAsOnCoarseOnes)
{
  std::vector<double> deviations;
  for (const int cells : { 24, 48, 96 })
  {
    const Surface surface = Sheet(cells);
    const Guidance guidance = Along(surface, { Stroke(Oblique) }, { 0.5 });
    const Result result = DirectionField(surface).Compute(AlongSides(), guidance);
    deviations.push_back(MeanDeviation(result, guidance, Oblique));
  }
  EXPECT_NEAR(deviations[1] / deviations[0], 1.0, 0.1);
  EXPECT_NEAR(deviations[2] / deviations[0], 1.0, 0.1);
}

TEST(SoftConstraints, FieldsDoNotDependOnTheUnitOfLength)
{
  for (const double size : { 1e-100, 1e100 })
  {
    const Surface unit = Sheet(12);
    Surface scaled = unit;
    for (Vector3& point : scaled.Points)
    {
      point *= size;
    }
    const Guidance guidance = Along(unit, { Stroke(Oblique) }, { 0.4 });
    const Result one = DirectionField(unit).Compute(AlongSides(), guidance);
    const Result other = DirectionField(scaled).Compute(AlongSides(), guidance);
    for (Index i = 0; i < static_cast<Index>(unit.Points.size()); ++i)
    {
      EXPECT_LT(Deviation(other, i, one.Direction(i, 0)), 1e-4);
    }
  }
}

TEST(SoftConstraints, OtherConstraintsHavePriority)
{
  const Surface surface = Square(12);
  Guidance guidance = GuidanceAt(surface, { { 6, Oblique }, { 84, Oblique } });
  guidance.Strengths.assign(surface.Points.size(), 0.999);
  const Result result = DirectionField(surface).Compute(AlongSides(), guidance);
  EXPECT_EQ(result.Constraint[6], ConstraintKind::Boundary);
  EXPECT_LT(Deviation(result, 6, Vector3::UnitX()), 1e-6);
  EXPECT_LT(Deviation(result, 84, Oblique), 1.0);
}

TEST(SoftConstraints, AtAnyStrengthTheFieldIsSoundAndTheSameForAnyNumberOfThreads)
{
  const Surface surface = Jittered(Potato(4), 0.01, 1);
  const std::vector<Vector3> ring = { { 0, 0, 0 }, { 2, 0.5, 0 } };
  for (const double strength : { 1e-300, 0.5, 1.0 - 1e-12, std::nextafter(1.0, 0.0) })
  {
    for (const Alignment alignment : { Alignment::None, Alignment::PrincipalCurvature })
    {
      Options options;
      options.ConstrainGuidance = true;
      options.UnitLength = alignment == Alignment::None;
      options.Alignment = alignment;
      options.NumberOfThreads = 1;
      const Guidance guidance = Along(surface, { ring }, { strength });
      const Result one = DirectionField(surface).Compute(options, guidance);
      EXPECT_TRUE(one.Components[0].Converged) << strength;
      options.NumberOfThreads = 2;
      const Result two = DirectionField(surface).Compute(options, guidance);
      int sum = 0;
      for (const int index : one.SingularityIndex)
      {
        sum += index;
      }
      EXPECT_EQ(sum, 8);
      for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
      {
        EXPECT_EQ(one.Direction(i, 0), two.Direction(i, 0));
        EXPECT_NEAR(one.Direction(i, 0).norm(), 1.0, 1e-12);
        if (strength > 0.9 && guidance.Weights[i] > 0.0)
        {
          EXPECT_LT(Deviation(one, i, guidance.Vectors[i]), 0.1);
        }
      }
    }
  }
}

TEST(SoftConstraints, AFieldThatWasComputedBeforeGivesTheSameBytes)
{
  const Surface surface = Potato(4);
  const std::vector<Vector3> line = { { 0, 0, 0 }, { 2, 0.5, 0 } };
  DirectionField kept(surface);
  Options options;
  options.ConstrainGuidance = true;
  for (const double strength : { 0.5, 1.0, 0.8, 0.8, 0.0, 0.5 })
  {
    const Guidance guidance = Along(surface, { line }, { strength });
    const Result again = kept.Compute(options, guidance);
    const Result anew = DirectionField(surface).Compute(options, guidance);
    for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
    {
      EXPECT_LT(Deviation(again, i, anew.Direction(i, 0)), 1e-4);
    }
  }
}

TEST(SoftConstraints, HardCurvesWinAtTheirPointsAndStifferOnesCountForMore)
{
  const Surface surface = Sheet(24);
  const std::vector<std::vector<Vector3>> curves = { Stroke(Oblique), Stroke(Steep) };
  CurveGuidanceOptions options;
  options.Strengths = { 1.0, 0.5 };
  const CurveGuidance both = GuideByCurves(surface, curves, options);
  const CurveGuidance hard = GuideByCurves(surface, { curves[0] }, {});
  EXPECT_TRUE(hard.Strengths.empty());
  int softer = 0;
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    if (hard.Weights[i] > 0.0)
    {
      EXPECT_EQ(both.Strengths[i], 1.0);
      EXPECT_EQ(both.Vectors[i], hard.Vectors[i]);
    }
    else if (both.Weights[i] > 0.0)
    {
      EXPECT_NEAR(both.Strengths[i], 0.5, 1e-12);
      ++softer;
    }
    else
    {
      EXPECT_EQ(both.Strengths[i], 0.0);
    }
  }
  EXPECT_GT(softer, 3);
  // Two curves at one place: s = 4 and s = 1 have the mean 2.5, and sum up as their fourth powers.
  options.Strengths = { 0.8, 0.5 };
  const CurveGuidance mixed =
    GuideByCurves(surface, { Stroke(Oblique), Stroke(Vector3::UnitX()) }, options);
  const Guidance same = Along(surface, { Stroke(Oblique), Stroke(Oblique) }, { 0.8, 0.5 });
  double least = 1.0;
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    if (same.Weights[i] > 0.0)
    {
      EXPECT_NEAR(same.Strengths[i], 2.5 / 3.5, 1e-12);
      least = std::min(least, same.Strengths[i]);
    }
    if (mixed.Weights[i] > 0.0)
    {
      EXPECT_GT(mixed.Strengths[i], 0.5 - 1e-12);
      EXPECT_LT(mixed.Strengths[i], 0.8 + 1e-12);
    }
  }
  EXPECT_LT(least, 1.0);
  options.Radius = 0.1;
  options.Strengths = { 1.0, 0.5 };
  const CurveGuidance wide = GuideByCurves(surface, { Stroke(Oblique), {} }, options);
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    EXPECT_EQ(wide.Strengths[i], wide.Weights[i] > 0.0 ? 1.0 : 0.0);
  }
  for (const std::vector<double>& wrong : { std::vector<double>{ 0.5 }, { 0.5, -0.1 }, { 0.5, 1.1 },
         { 0.5, std::numeric_limits<double>::quiet_NaN() } })
  {
    options.Strengths = wrong;
    EXPECT_THROW(GuideByCurves(surface, curves, options), std::invalid_argument);
  }
}
