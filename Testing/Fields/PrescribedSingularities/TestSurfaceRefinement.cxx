// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PrescribedSingularities/SurfaceRefinement.h"

#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

using namespace DirectionFields;

namespace
{
double AreaOf(const Surface& surface, std::size_t t)
{
  const Triangle& c = surface.Triangles[t];
  return 0.5 *
    (surface.Points[c[1]] - surface.Points[c[0]])
      .cross(surface.Points[c[2]] - surface.Points[c[0]])
      .norm();
}

std::vector<char> Some(const Surface& surface, unsigned part)
{
  std::mt19937 random(11);
  std::vector<char> isSplit(surface.Triangles.size());
  for (char& split : isSplit)
  {
    split = random() % part == 0 ? 1 : 0;
  }
  return isSplit;
}
}

/// Each edge of a closed surface still has two triangles of opposite senses, so no corner lies within an edge.
TEST(SurfaceRefinement, IsAClosedSurfaceOfTheSameShape)
{
  const Surface potato = Meshes::Potato(3);
  for (const unsigned part : { 1u, 2u, 5u, 50u })
  {
    const std::vector<char> isSplit = Some(potato, part);
    const SurfaceRefinement refinement(potato, isSplit);
    const Surface& refined = refinement.Refined;
    std::map<std::pair<Index, Index>, int> halfEdges;
    std::vector<double> area(potato.Triangles.size(), 0.0);
    std::vector<int> parts(potato.Triangles.size(), 0);
    for (std::size_t t = 0; t < refined.Triangles.size(); ++t)
    {
      for (int c = 0; c < 3; ++c)
      {
        ++halfEdges[{ refined.Triangles[t][c], refined.Triangles[t][(c + 1) % 3] }];
      }
      area[refinement.Parent[t]] += AreaOf(refined, t);
      ++parts[refinement.Parent[t]];
    }
    for (const auto& [ends, count] : halfEdges)
    {
      EXPECT_EQ(count, 1);
      EXPECT_EQ(halfEdges.count({ ends.second, ends.first }), 1u);
    }
    const auto points = static_cast<int>(refined.Points.size());
    const auto triangles = static_cast<int>(refined.Triangles.size());
    EXPECT_EQ(points - static_cast<int>(halfEdges.size()) / 2 + triangles, 2);
    for (std::size_t t = 0; t < area.size(); ++t)
    {
      EXPECT_NEAR(area[t], AreaOf(potato, t), 1e-12);
      EXPECT_TRUE(isSplit[t] ? parts[t] == 4 : parts[t] >= 1 && parts[t] <= 4);
    }
    ASSERT_EQ(refinement.Ends.size(), refined.Points.size() - potato.Points.size());
    for (std::size_t k = 0; k < refinement.Ends.size(); ++k)
    {
      const auto& [a, b] = refinement.Ends[k];
      EXPECT_EQ(refined.Points[potato.Points.size() + k],
        Vector3(0.5 * potato.Points[a] + 0.5 * potato.Points[b]));
    }
  }
}

TEST(SurfaceRefinement, DirectionsAtMiddlesGoOnWithTheField)
{
  const Surface square = Meshes::Jittered(Meshes::Square(6), 0.02, 3);
  Surface flat = square;
  for (Vector3& point : flat.Points)
  {
    point.z() = 0.0;
  }
  const GivenField field(flat, Fields::PlanarField(flat, 4, [](const Vector3&) { return 0.4; }));
  const SurfaceRefinement refinement(flat, Some(flat, 3));
  const std::vector<Vector3> directions = DirectionsAtMiddles(field, refinement);
  ASSERT_EQ(directions.size(), 4 * refinement.Ends.size());
  ASSERT_FALSE(directions.empty());
  for (const Vector3& direction : directions)
  {
    EXPECT_NEAR(std::cos(4.0 * (std::atan2(direction.y(), direction.x()) - 0.4)), 1.0, 1e-9);
    EXPECT_NEAR(direction.norm(), 1.0, 1e-12);
  }
}

TEST(SurfaceRefinement, SplitsTheWrongTrianglesAndThoseThatShareAPoint)
{
  const Surface potato = Meshes::Potato(2);
  const Result base = Fields::Compute(potato, 4);
  const GivenField field(potato, DirectionsOf(base));
  EditedField edited;
  edited.WrongTriangles = { 17 };
  const std::vector<char> isSplit = TrianglesToSplit(field, edited);
  const Triangle& wrong = potato.Triangles[field.GetMesh().InputTriangle(17)];
  for (std::size_t t = 0; t < isSplit.size(); ++t)
  {
    bool shares = false;
    for (const Index i : potato.Triangles[t])
    {
      shares = shares || std::count(wrong.begin(), wrong.end(), i) > 0;
    }
    EXPECT_EQ(isSplit[t] != 0, shares);
  }
}
