// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which side of the surface glyphs are on, and which data of the surface are kept.

#include "Glyphs.h"
#include "Glyphs/OutwardSides.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

using namespace DirectionFields;
using namespace Fields;

namespace
{
Surface InsideOut(Surface surface)
{
  for (Triangle& triangle : surface.Triangles)
  {
    std::swap(triangle[0], triangle[1]);
  }
  return surface;
}

std::vector<signed char> All(const Surface& surface, int side)
{
  return std::vector<signed char>(surface.Triangles.size(), static_cast<signed char>(side));
}

/// The glyphs of the smoothest field.
Glyphs Draw(const Surface& surface, int degree, const GlyphOptions& options)
{
  const Result result = Compute(surface, degree);
  return MakeGlyphs(surface, Of(result), {}, {}, options);
}

bool IsSame(const Glyphs& a, const Glyphs& b)
{
  return a.Mesh.Points == b.Mesh.Points && a.Mesh.Normals == b.Mesh.Normals &&
    a.Mesh.Offsets == b.Mesh.Offsets && a.Mesh.Connectivity == b.Mesh.Connectivity &&
    a.Mesh.Glyph == b.Mesh.Glyph && a.Mesh.Branch == b.Mesh.Branch && a.Point == b.Point &&
    a.Magnitude == b.Magnitude && a.Direction == b.Direction && a.Spacing == b.Spacing;
}

/// For each glyph how many of its points satisfy a condition, and how many do not.
template <typename Condition>
std::vector<std::pair<int, int>> Parted(const Glyphs& glyphs, const Condition& condition)
{
  std::vector<std::pair<int, int>> parted(glyphs.Point.size(), { 0, 0 });
  for (std::size_t i = 0; i < glyphs.Mesh.Glyph.size(); ++i)
  {
    for (auto j = glyphs.Mesh.Offsets[i]; j < glyphs.Mesh.Offsets[i + 1]; ++j)
    {
      const std::int64_t point = glyphs.Mesh.Connectivity[j];
      auto& counts = parted[glyphs.Mesh.Glyph[i]];
      ++(condition(glyphs.Mesh.Points[point], glyphs.Mesh.Normals[point]) ? counts.first
                                                                          : counts.second);
    }
  }
  return parted;
}

/// The polygons run counter-clockwise about their normals.
void CheckWinding(const GlyphMesh& mesh)
{
  for (std::size_t i = 0; i < mesh.Glyph.size(); ++i)
  {
    const std::int64_t* const corners = &mesh.Connectivity[mesh.Offsets[i]];
    const Vector3& origin = mesh.Points[corners[0]];
    const Vector3 normal =
      (mesh.Points[corners[1]] - origin).cross(mesh.Points[corners[2]] - origin);
    EXPECT_GT(normal.dot(mesh.Normals[corners[0]]), 0.0);
  }
}
}

TEST(OutwardSides, AreThoseOfPositiveVolume)
{
  const Surface sphere = Meshes::Icosphere(2);
  EXPECT_EQ(OutwardSides(sphere), All(sphere, 1));
  EXPECT_EQ(OutwardSides(InsideOut(sphere)), All(sphere, -1));
  // Far from the origin, and of any size.
  const Surface far = Meshes::Transformed(
    InsideOut(sphere), 1e-3 * Eigen::Matrix3d::Identity(), Vector3(1e3, -2e3, 5e2));
  EXPECT_EQ(OutwardSides(far), All(sphere, -1));

  // Bodies wound inside out one by one, and triangles against the majority of their body.
  Surface two = Meshes::Joined(sphere,
    Meshes::Transformed(
      InsideOut(Meshes::Torus(12, 8)), Eigen::Matrix3d::Identity(), Vector3(5.0, 0.0, 0.0)));
  std::vector<signed char> expected = All(two, 1);
  std::fill(
    expected.begin() + static_cast<std::ptrdiff_t>(sphere.Triangles.size()), expected.end(), -1);
  EXPECT_EQ(OutwardSides(two), expected);
  for (const std::size_t t : { std::size_t(7), std::size_t(50), two.Triangles.size() - 3 })
  {
    std::swap(two.Triangles[t][1], two.Triangles[t][2]);
    expected[t] = static_cast<signed char>(-expected[t]);
  }
  EXPECT_EQ(OutwardSides(two), expected);

  // Facets that share places but no points.
  const Surface soup = Meshes::Soup(two);
  EXPECT_EQ(OutwardSides(soup), expected);
}

TEST(OutwardSides, AreNoneWhereThereIsNoOutside)
{
  for (const Surface& surface : { Meshes::Square(3), Meshes::Hemisphere(2),
         Meshes::MoebiusStrip(20, 2), Meshes::KleinBottle(20, 10), Meshes::ProjectivePlane(2) })
  {
    EXPECT_EQ(OutwardSides(surface), All(surface, 0));
  }
  EXPECT_TRUE(OutwardSides(Surface()).empty());

  // Unsound triangles beside a body.
  Surface sphere = InsideOut(Meshes::Icosphere(1));
  std::vector<signed char> expected = All(sphere, -1);
  sphere.Points.emplace_back(std::nan(""), 0.0, 0.0);
  const auto last = static_cast<Index>(sphere.Points.size()) - 1;
  for (const Triangle& triangle : { Triangle{ 0, 1, last }, Triangle{ 0, 1, last + 1 },
         Triangle{ -1, 2, 3 }, Triangle{ 4, 4, 5 } })
  {
    sphere.Triangles.insert(sphere.Triangles.begin() + 9, triangle);
    expected.insert(expected.begin() + 9, 0);
  }
  EXPECT_EQ(OutwardSides(sphere), expected);
}

TEST(GlyphSides, AreOutsideOfWhatIsInsideOut)
{
  const Surface sphere = Meshes::Icosphere(3);
  for (const int n : { 1, 2, 4, 6 })
  {
    for (const GlyphMode mode : { GlyphMode::SpreadEvenly, GlyphMode::AllPoints })
    {
      for (const bool follow : { true, false })
      {
        GlyphOptions options;
        options.Mode = mode;
        options.FollowSurface = follow;
        options.MaximumNumber = 300;
        options.Offset = 0.2;
        const Glyphs outside = Draw(sphere, n, options);
        const Glyphs inside = Draw(InsideOut(sphere), n, options);
        for (const Glyphs& glyphs : { outside, inside })
        {
          EXPECT_GT(glyphs.Point.size(), 240u);
          for (std::size_t i = 0; i < glyphs.Mesh.Points.size(); ++i)
          {
            EXPECT_GT(glyphs.Mesh.Points[i].norm(), 1.0);
            EXPECT_GT(glyphs.Mesh.Points[i].dot(glyphs.Mesh.Normals[i]), 0.9);
          }
          CheckWinding(glyphs.Mesh);
        }
        // The front is where the winding says that it is.
        options.Side = GlyphSide::Front;
        EXPECT_TRUE(IsSame(Draw(sphere, n, options), outside));
        const Glyphs front = Draw(InsideOut(sphere), n, options);
        for (const Vector3& point : front.Mesh.Points)
        {
          EXPECT_LT(point.norm(), 1.0);
        }
        options.Side = GlyphSide::Back;
        EXPECT_TRUE(IsSame(Draw(InsideOut(sphere), n, options), inside));
      }
    }
  }
}

TEST(GlyphSides, AreOutsideOfEachBodyAndOfTurnedTriangles)
{
  // Two bodies, one of them inside out, and some triangles against the others.
  const Vector3 shift(4.0, 0.0, 0.0);
  const Surface sphere = Meshes::Icosphere(3);
  Surface surface = Meshes::Joined(
    sphere, Meshes::Transformed(InsideOut(sphere), Eigen::Matrix3d::Identity(), shift));
  for (std::size_t t = 0; t < surface.Triangles.size(); t += 5)
  {
    std::swap(surface.Triangles[t][0], surface.Triangles[t][1]);
  }
  for (const int n : { 2, 4 })
  {
    GlyphOptions options;
    options.MaximumNumber = 500;
    options.Offset = 0.1;
    const Glyphs glyphs = Draw(surface, n, options);
    int right = 0;
    for (const Vector3& point : glyphs.Mesh.Points)
    {
      const bool second = point.x() > 2.0;
      right += second ? 1 : 0;
      EXPECT_GT((point - (second ? shift : Vector3(0.0, 0.0, 0.0))).norm(), 1.0);
    }
    const double part = static_cast<double>(right) / static_cast<double>(glyphs.Mesh.Points.size());
    EXPECT_NEAR(part, 0.5, 0.05);
  }
}

TEST(GlyphSides, AreBothOfWhatIsOpen)
{
  const Surface square = Meshes::Square(6);
  for (const int n : { 1, 2, 4 })
  {
    for (const GlyphType type :
      { GlyphType::Lines, GlyphType::Arrows, GlyphType::Ribbons, GlyphType::Tubes })
    {
      GlyphOptions options;
      options.Type = type;
      options.MaximumNumber = 40;
      const Glyphs both = Draw(square, n, options);
      EXPECT_GT(both.Point.size(), 30u);
      EXPECT_LE(both.Point.size(), 40u);
      for (const auto& [above, below] :
        Parted(both, [](const Vector3&point, const Vector3&) { return point.z() > 0.0; }))
      {
        EXPECT_GT(above, 0);
        EXPECT_TRUE(above == below || type == GlyphType::Tubes);
      }
      if (type == GlyphType::Arrows || type == GlyphType::Ribbons)
      {
        CheckWinding(both.Mesh);
      }

      // Glyphs on both sides are those on the one and those on the other.
      options.Side = GlyphSide::Both;
      EXPECT_TRUE(IsSame(Draw(square, n, options), both));
      options.Side = GlyphSide::Front;
      const Glyphs front = Draw(square, n, options);
      options.Side = GlyphSide::Back;
      const Glyphs back = Draw(square, n, options);
      EXPECT_EQ(front.Point, both.Point);
      EXPECT_EQ(back.Point, both.Point);
      EXPECT_EQ(front.Mesh.Points.size() + back.Mesh.Points.size(), both.Mesh.Points.size());
      ASSERT_EQ(front.Mesh.Points.size(), back.Mesh.Points.size());
      double sumFront = 0.0;
      double sumBack = 0.0;
      for (std::size_t i = 0; i < front.Mesh.Points.size(); ++i)
      {
        sumFront += front.Mesh.Points[i].z();
        sumBack += back.Mesh.Points[i].z();
      }
      EXPECT_GT(sumFront, 0.0);
      EXPECT_NEAR(sumBack, -sumFront, 1e-9);
      // Beyond the surface with a negative height.
      options.Offset = -0.3;
      for (const Vector3& point : Draw(square, n, options).Mesh.Points)
      {
        EXPECT_GT(point.z(), 0.0);
      }
    }
  }

  // Curved surfaces have no other places on the one side than on the other.
  GlyphOptions options;
  options.MaximumNumber = 200;
  options.Offset = 0.2;
  for (const auto& [outside, inside] : Parted(Draw(Meshes::Hemisphere(3), 4, options),
         [](const Vector3&point, const Vector3&) { return point.norm() > 1.0; }))
  {
    EXPECT_GT(outside, 0);
    EXPECT_GT(inside, 0);
  }
}

TEST(GlyphSides, AreBothOfWhatCannotBeOriented)
{
  GlyphOptions options;
  options.MaximumNumber = 100;
  for (const int n : { 1, 2, 4 })
  {
    for (const Surface& surface : { Meshes::MoebiusStrip(60, 6), Meshes::KleinBottle(60, 30) })
    {
      const Result result = Compute(surface, n);
      const Glyphs glyphs = MakeGlyphs(surface, Of(result), {}, {}, options);
      EXPECT_GT(glyphs.Point.size(), 80u);
      options.Side = GlyphSide::Front;
      const Glyphs front = MakeGlyphs(surface, Of(result), {}, {}, options);
      options.Side = GlyphSide::Automatic;
      EXPECT_GT(glyphs.Mesh.Points.size(), 1.8 * front.Mesh.Points.size());
      // The normals of each glyph point to both sides alike.
      std::vector<Vector3> sum(glyphs.Point.size(), Vector3::Zero());
      for (std::size_t i = 0; i < glyphs.Mesh.Glyph.size(); ++i)
      {
        for (auto j = glyphs.Mesh.Offsets[i]; j < glyphs.Mesh.Offsets[i + 1]; ++j)
        {
          sum[glyphs.Mesh.Glyph[i]] += glyphs.Mesh.Normals[glyphs.Mesh.Connectivity[j]];
        }
      }
      for (const Vector3& vector : sum)
      {
        EXPECT_LT(vector.norm(), 1e-9);
      }
    }
  }
}

TEST(GlyphSurface, KeepsThePlacesOfAllFields)
{
  const auto surface = std::make_shared<const Surface>(Meshes::Potato(3));
  GlyphSurface kept(surface);
  GlyphOptions options;
  options.MaximumNumber = 200;
  std::vector<Index> points;
  for (const int n : { 4, 1, 6 })
  {
    const Result result = Compute(*surface, n);
    const Glyphs glyphs = MakeGlyphs(kept, Of(result), options);
    EXPECT_TRUE(IsSame(glyphs, MakeGlyphs(*surface, Of(result), {}, {}, options)));
    points = points.empty() ? glyphs.Point : points;
    EXPECT_EQ(glyphs.Point, points);
    // Places do not depend on the looks of glyphs.
    GlyphOptions other = options;
    other.Type = GlyphType::Tubes;
    other.Scale = 0.5;
    other.Offset = 0.3;
    other.FollowSurface = false;
    other.Side = GlyphSide::Both;
    EXPECT_TRUE(
      IsSame(MakeGlyphs(kept, Of(result), other), MakeGlyphs(*surface, Of(result), {}, {}, other)));
  }
  EXPECT_EQ(kept.GetNumberOfSamplings(), 1);
  const Result result = Compute(*surface, 4);
  int samplings = 1;
  const auto expectAnew = [&]
  {
    EXPECT_TRUE(IsSame(
      MakeGlyphs(kept, Of(result), options), MakeGlyphs(*surface, Of(result), {}, {}, options)));
    EXPECT_EQ(kept.GetNumberOfSamplings(), ++samplings);
  };
  options.MaximumNumber = 100;
  expectAnew();
  options.Spacing = 0.9;
  expectAnew();
  options.Mode = GlyphMode::AllPoints;
  expectAnew();
  // A search that was stopped leaves no places that are half found.
  options.Mode = GlyphMode::SpreadEvenly;
  EXPECT_TRUE(MakeGlyphs(kept, Of(result), options, [](double) { return false; }).Aborted);
  ++samplings;
  expectAnew();
}

TEST(GlyphSurface, IsDrawnOnAlikeByAnyNumberOfThreads)
{
  const Surface surface = Meshes::Potato(4);
  const Result result = Compute(surface, 4);
  GlyphOptions options;
  options.MaximumNumber = 1500;
  Glyphs expected;
  for (const int number : { 1, 2, 3, 8 })
  {
    Threads threads(number);
    const Threads::Scope scope(threads);
    const Glyphs glyphs = MakeGlyphs(surface, Of(result), {}, {}, options);
    if (number == 1)
    {
      expected = glyphs;
    }
    EXPECT_TRUE(IsSame(glyphs, expected)) << number;
  }
}
