// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/TriangleRuns.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <utility>

using namespace DirectionFields;

TEST(TriangleRuns, FindTheSameAsTheTree)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (const double scale : { 1.0, 1e-150, 1e150 })
  {
    Surface surface = Meshes::Torus(47, 23);
    for (Vector3& point : surface.Points)
    {
      point *= scale;
    }
    LargeArray<Index> order(surface.Triangles.size());
    std::iota(order.begin(), order.end(), 0);
    const TriangleRuns runs(surface, std::move(order));
    const ClosestPoints tree(surface);
    std::vector<Vector3> places = { surface.Points[17], surface.Points.back(), Vector3::Zero() };
    for (int k = 0; k < 50; ++k)
    {
      const double size = scale * (k % 5 == 0 ? 100.0 : 4.0);
      const Vector3 place(normal(random), normal(random), normal(random));
      places.push_back(size * place);
    }
    for (const Vector3& place : places)
    {
      const ClosestPoints::Answer found = runs.Find(place);
      const ClosestPoints::Answer expected = tree.Find(place);
      EXPECT_EQ(found.Triangle, expected.Triangle);
      EXPECT_EQ(found.Weights, expected.Weights);
      EXPECT_EQ(found.Position, expected.Position);
    }
  }
}

TEST(TriangleRuns, FindOnlyTrianglesOfTheOrder)
{
  const Surface surface = Meshes::Torus(11, 7);
  EXPECT_EQ(
    TriangleRuns(surface, { 3 }).Find(surface.Points[surface.Triangles[80][0]]).Triangle, 3);
  EXPECT_EQ(TriangleRuns(surface, {}).Find(Vector3::Zero()).Triangle, None);
}
