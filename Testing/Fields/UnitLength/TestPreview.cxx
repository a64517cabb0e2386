// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
Options Previewed(int degree)
{
  Options options;
  options.Degree = degree;
  options.UnitLength = true;
  options.Preview = true;
  return options;
}

/// The first field and its preview have the same directions up to a rotation that is the same everywhere; with
/// values that are given it is none.
void ExpectScaled(const Surface& surface, const Guidance& guidance, Options options, bool isTurned)
{
  const Result preview = DirectionField(surface).Compute(options, guidance);
  options.UnitLength = false;
  const Result first = DirectionField(surface).Compute(options, guidance);
  ASSERT_EQ(preview.SingularityIndex, first.SingularityIndex);
  Complex turn = 0.0;
  for (std::size_t v = 0; v < surface.Points.size(); ++v)
  {
    const Complex value = first.Representation[v];
    ASSERT_GT(std::abs(value), 1e-12);
    EXPECT_NEAR(std::abs(preview.Representation[v]), 1.0, 1e-12);
    const Complex ratio = preview.Representation[v] / (value / std::abs(value));
    turn = v == 0 && isTurned ? ratio : turn;
    EXPECT_LT(std::abs(ratio - (isTurned ? turn : 1.0)), 1e-9);
  }
}

Guidance AlongX(const Surface& surface, double strength)
{
  Guidance guidance;
  guidance.Vectors.assign(surface.Points.size(), Vector3::UnitX());
  guidance.Weights.assign(surface.Points.size(), 0.0);
  guidance.Strengths.assign(surface.Points.size(), strength);
  for (std::size_t v = 0; v < surface.Points.size(); v += 37)
  {
    guidance.Weights[v] = 1.0;
  }
  return guidance;
}
}

TEST(Preview, IsTheFirstFieldScaledToUnitLength)
{
  const Surface torus = Torus(40, 20, 1.0, 0.4);
  ExpectScaled(torus, {}, Previewed(2), true);
  ExpectScaled(Jittered(Icosphere(2), 0.05, 1), {}, Previewed(1), true);
  Options aligned = Previewed(4);
  aligned.Alignment = Alignment::PrincipalCurvature;
  ExpectScaled(torus, {}, aligned, false);
  Options bound = Previewed(4);
  bound.ConstrainBoundary = true;
  ExpectScaled(Jittered(Square(12), 0.02, 1), {}, bound, false);
  Options drawn = Previewed(4);
  drawn.ConstrainGuidance = true;
  for (const double strength : { 0.5, 1.0 })
  {
    ExpectScaled(torus, AlongX(torus, strength), drawn, false);
  }
}

TEST(Preview, HasTheEnergyThatTheDescentBeginsAt)
{
  const Surface surface = Torus(40, 20, 1.0, 0.4);
  Options options = Previewed(4);
  options.ConstrainGuidance = true;
  const Guidance guidance = AlongX(surface, 1.0);
  const ComponentReport preview = DirectionField(surface).Compute(options, guidance).Components[0];
  options.Preview = false;
  const ComponentReport whole = DirectionField(surface).Compute(options, guidance).Components[0];
  EXPECT_EQ(preview.UnitEnergyBefore, whole.UnitEnergyBefore);
  EXPECT_EQ(preview.UnitEnergyAfter, preview.UnitEnergyBefore);
  EXPECT_EQ(preview.UnitSteps, 0);
  EXPECT_LT(whole.UnitEnergyAfter, whole.UnitEnergyBefore);
  EXPECT_LT(whole.SmoothnessEnergy, preview.SmoothnessEnergy);
}

/// What follows on a preview, in the same object, is the field that comes without one.
TEST(Preview, LeavesNothingBehind)
{
  const Surface surface = Jittered(Torus(40, 20, 1.0, 0.4), 0.01, 3);
  const Guidance guidance = AlongX(surface, 1.0);
  Options options = Previewed(4);
  options.ConstrainGuidance = true;
  DirectionField field(surface);
  field.Compute(options, guidance);
  options.Preview = false;
  const Result after = field.Compute(options, guidance);
  EXPECT_EQ(
    after.Representation, DirectionField(surface).Compute(options, guidance).Representation);
}
