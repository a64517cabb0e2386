// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrivialConnection/RotationAtPlace.h"

#include "Geometry/SurfaceGeometry.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace DirectionFields;

TEST(RotationAtPlace, AddsUpToTheIndexLessTheHolonomyBelowAHalfTurnEach)
{
  const SurfaceGeometry geometry(Meshes::Potato(2));
  std::mt19937 random(2);
  const auto number = [&] { return random() / 4294967296.0; };
  int possible = 0;
  int refused = 0;
  for (int k = 0; k < 4000; ++k)
  {
    const FlatTriangle flat(geometry, static_cast<Index>(random() % 300));
    const double u = number();
    const double v = number() * (1.0 - u);
    const int index = static_cast<int>(random() % 5) - 2;
    const double holonomy = 2.0 * number() - 1.0;
    const auto rotation = RotationAround(flat, { u, v, 1.0 - u - v }, index, holonomy);
    ASSERT_EQ(rotation.has_value(), CanHaveIndex(index, holonomy));
    if (!rotation)
    {
      // Three edges of less than a half turn each cannot add up to it.
      EXPECT_GT(std::abs(2.0 * Pi * index - holonomy), 3.0 * MostRotation);
      ++refused;
      continue;
    }
    ++possible;
    EXPECT_NEAR(
      (*rotation)[0] + (*rotation)[1] + (*rotation)[2], 2.0 * Pi * index - holonomy, 1e-12);
    for (const double angle : *rotation)
    {
      EXPECT_LE(std::abs(angle), MostRotation + 1e-12);
    }
  }
  EXPECT_GT(possible, 1000);
  EXPECT_GT(refused, 1000);
}

/// Well inside of a flat triangle each edge turns by the angle under which it is seen.
TEST(RotationAtPlace, IsTheAngleUnderWhichAnEdgeIsSeen)
{
  const SurfaceGeometry geometry(Meshes::Jittered(Meshes::Square(4), 0.02, 1));
  for (Index t = 0; t < geometry.Mesh.GetNumberOfTriangles(); ++t)
  {
    const FlatTriangle flat(geometry, t);
    const std::array<double, 3> weights = { 0.3, 0.3, 0.4 };
    const Complex place = flat.Place(weights);
    const auto rotation = RotationAround(flat, weights, -1, 0.0);
    ASSERT_TRUE(rotation);
    for (int c = 0; c < 3; ++c)
    {
      const Complex a = flat.Corner(c) - place;
      const Complex b = flat.Corner((c + 1) % 3) - place;
      const double seen = std::acos((std::conj(a) * b).real() / (std::abs(a) * std::abs(b)));
      EXPECT_NEAR((*rotation)[c], -seen, 1e-9);
    }
  }
}

TEST(RotationAtPlace, KeepsPlacesAwayFromEdges)
{
  for (const std::array<double, 3>& weights :
    { std::array<double, 3>{ 1.0, 0.0, 0.0 }, { 0.5, 0.5, 0.0 }, { -0.2, 0.6, 0.6 } })
  {
    const std::array<double, 3> within = WithinTriangle(weights);
    EXPECT_NEAR(within[0] + within[1] + within[2], 1.0, 1e-15);
    for (const double weight : within)
    {
      EXPECT_GE(weight, LeastWeightOfPlace / (1.0 + 0.2 + 2.0 * LeastWeightOfPlace));
    }
  }
  const std::array<double, 3> inside = { 0.2, 0.3, 0.5 };
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(WithinTriangle(inside)[c], inside[c], 1e-15);
  }
}
