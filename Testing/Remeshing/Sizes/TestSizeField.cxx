// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Sizes/SizeField.h"

#include "Finishing/MeshAdvice.h"
#include "Meshes/Surfaces.h"
#include "Remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

using namespace DirectionFields;

namespace
{
template <typename Value>
std::vector<double> AtPoints(const Surface& surface, const Value& value)
{
  std::vector<double> values;
  for (const Vector3& point : surface.Points)
  {
    values.push_back(value(point));
  }
  return values;
}

RemeshOptions WithLengths(std::vector<double>&& lengths, double gradation = 0.0)
{
  RemeshOptions options;
  options.Sizing = std::move(lengths);
  options.SizingIsLength = true;
  options.Gradation = gradation;
  return options;
}

RemeshResult Remeshed(const Surface& surface, const RemeshOptions& options)
{
  return Remesh(std::make_shared<Surface>(surface)).Compute(options);
}

/// From 1 to 4 times as long from one half of a square to the other one.
double Jump(const Vector3& point)
{
  return point.x() < 0.5 ? 0.02 : 0.08;
}
}

/// Sizes grow by the slope along edges and no faster, from the smallest ones on, and are as large
/// as can be.
TEST(SizeField, GrowsNoFasterThanTheSlope)
{
  constexpr double slope = 0.5;
  const Surface square = Meshes::Square(20);
  const auto wanted = [](const Vector3& p) { return p.norm() < 1e-9 ? 0.1 : 0.35 + 0.1 * p.y(); };
  const std::vector<double> before = AtPoints(square, wanted);
  std::vector<double> sizes = before;
  LimitGrowth(square, slope, sizes);
  for (const Triangle& t : square.Triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double length = (square.Points[t[c]] - square.Points[t[(c + 1) % 3]]).norm();
      EXPECT_LE(std::abs(sizes[t[c]] - sizes[t[(c + 1) % 3]]), slope * length + 1e-12);
    }
  }
  for (std::size_t p = 0; p < sizes.size(); ++p)
  {
    const Vector3& at = square.Points[p];
    EXPECT_LE(sizes[p], before[p]);
    if (at.norm() > 1.0)
    {
      EXPECT_EQ(sizes[p], before[p]);
    }
    // Along a side of the square the way is straight.
    if (at.y() == 0.0)
    {
      EXPECT_NEAR(sizes[p], std::min(before[p], 0.1 + slope * at.x()), 1e-12);
    }
  }
}

/// Triangles that share no points, but places, are one surface.
TEST(SizeField, GrowsOverPointsAtOnePlace)
{
  const Surface square = Meshes::Square(6);
  const Surface soup = Meshes::Soup(square);
  const auto wanted = [](const Vector3& p) { return p.norm() < 1e-9 ? 0.1 : 1.0; };
  std::vector<double> sizes = AtPoints(square, wanted);
  std::vector<double> apart = AtPoints(soup, wanted);
  LimitGrowth(square, 1.0, sizes);
  LimitGrowth(soup, 1.0, apart);
  for (std::size_t t = 0; t < square.Triangles.size(); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(apart[soup.Triangles[t][c]], sizes[square.Triangles[t][c]], 1e-12);
    }
  }
}

/// Points that no triangle has are no places, whatever their coordinates.
TEST(SizeField, PointsWithoutTrianglesChangeNothing)
{
  constexpr std::size_t every = 3;
  const Surface soup = Meshes::Soup(Meshes::Square(6));
  const auto wanted = [](const Vector3& p) { return p.norm() < 1e-9 ? 0.1 : 1.0; };
  Surface mixed;
  for (const Vector3& point : soup.Points)
  {
    mixed.Points.push_back(point);
    if (mixed.Points.size() % every == every - 1)
    {
      mixed.Points.emplace_back(std::nan(""), 0.0, 0.0);
    }
  }
  const auto numberOf = [](Index p) { return p + p / 2; };
  for (const Triangle& t : soup.Triangles)
  {
    mixed.Triangles.push_back({ numberOf(t[0]), numberOf(t[1]), numberOf(t[2]) });
  }
  std::vector<double> sizes = AtPoints(soup, wanted);
  std::vector<double> among = AtPoints(mixed, wanted);
  LimitGrowth(soup, 1.0, sizes);
  LimitGrowth(mixed, 1.0, among);
  for (std::size_t p = 0; p < soup.Points.size(); ++p)
  {
    EXPECT_EQ(among[numberOf(static_cast<Index>(p))], sizes[p]) << p;
  }
}

/// The edge length times the size is the length in the user's unit, whatever that is.
TEST(SizeField, HasTheLengthsThatAreGiven)
{
  const Surface square = Meshes::Square(10);
  for (const double ratio : { 1.0, 5.0, 60.0 })
  {
    const auto length = [ratio](const Vector3& p) { return 3.0 * std::pow(ratio, p.x() * p.y()); };
    const std::vector<double> given = AtPoints(square, length);
    const RelativeSizes sizes = SizesFor(square, given, 16.0);
    EXPECT_TRUE(sizes.Notes.empty());
    for (std::size_t p = 0; p < given.size(); ++p)
    {
      EXPECT_NEAR(16.0 * sizes.EdgeLength * sizes.Sizes[p], given[p], 1e-12 * given[p]);
      EXPECT_TRUE(sizes.Sizes[p] < 8.0 + 1e-9 && sizes.Sizes[p] > 0.125 - 1e-9);
    }
  }
  const RelativeSizes wide = SizesFor(
    square, AtPoints(square, [](const Vector3& p) { return std::pow(200.0, p.x()); }), 1.0);
  ASSERT_EQ(wide.Notes.size(), 1U);
  EXPECT_NE(wide.Notes[0].find("from 1 to 200"), std::string::npos);
}

TEST(SizeField, LengthsHaveToBePositiveNumbers)
{
  const Surface square = Meshes::Square(4);
  for (const double bad : { 0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    std::vector<double> lengths(square.Points.size(), 0.1);
    lengths[7] = bad;
    EXPECT_THROW(Remeshed(square, WithLengths(std::move(lengths))), std::invalid_argument);
  }
  EXPECT_THROW(Remeshed(square, WithLengths({})), std::invalid_argument);
  RemeshOptions options;
  options.Gradation = 0.9;
  EXPECT_THROW(Remeshed(square, options), std::invalid_argument);
}

/// A square of edges of a tenth has 100 faces, in any unit, and they all have that length.
TEST(SizeField, LengthsAreMet)
{
  for (const double unit : { 1.0, 1e-5, 1e6 })
  {
    const Surface square = Meshes::Square(12, unit);
    const RemeshResult mesh =
      Remeshed(square, WithLengths(std::vector<double>(square.Points.size(), 0.1 * unit)));
    EXPECT_EQ(mesh.Quads, 100);
    EXPECT_NEAR(mesh.EdgeLength, 0.1 * unit, 1e-9 * unit);
    EXPECT_TRUE(mesh.IsSized);
    EXPECT_EQ(mesh.EdgesAsWanted, 1.0);
  }
}

/// Without irregular vertices for it a jump of sizes is missed on both sides of it, and one that is
/// limited is met better. With them it is met as it is.
TEST(SizeField, GradationOrPairsHelpToMeetThem)
{
  const Surface square = Meshes::Square(60);
  const auto remeshed = [&](double gradation, bool addsPairs)
  {
    RemeshOptions options = WithLengths(AtPoints(square, Jump), gradation);
    options.AddIrregularPairs = addsPairs;
    return Remeshed(square, options);
  };
  const RemeshResult jump = remeshed(0.0, false);
  const RemeshResult graded = remeshed(1.15, false);
  const RemeshResult paired = remeshed(0.0, true);
  const RemeshResult both = remeshed(1.3, true);
  RecordProperty("Jump", std::to_string(jump.EdgesAsWanted));
  RecordProperty("Graded", std::to_string(graded.EdgesAsWanted));
  RecordProperty("Paired", std::to_string(paired.EdgesAsWanted));
  RecordProperty("Both", std::to_string(both.EdgesAsWanted));
  EXPECT_LT(jump.EdgesAsWanted, graded.EdgesAsWanted);
  EXPECT_LT(jump.Faces.size(), graded.Faces.size());
  EXPECT_GT(paired.EdgesAsWanted, 0.9);
  EXPECT_GT(paired.IrregularVertices, 0);
  EXPECT_EQ(jump.IrregularVertices, 0);
}

/// Relative sizes out of range are said, and only these.
TEST(SizeField, SizesOutOfRangeAreSaid)
{
  const Surface square = Meshes::Square(12);
  RemeshOptions options;
  options.NumberOfFaces = 100;
  options.Sizing.assign(square.Points.size(), 1.0);
  const auto saysSo = [&]
  {
    const RemeshResult mesh = Remeshed(square, options);
    return std::any_of(mesh.Notes.begin(), mesh.Notes.end(),
      [](const std::string& note)
      { return note.find("at 1 point that of the Sizing Array") != std::string::npos; });
  };
  options.Sizing[5] = 8.0;
  EXPECT_FALSE(saysSo());
  options.Sizing[5] = 8.5;
  EXPECT_TRUE(saysSo());
}

/// Five edges of length 1, two of length 2.
TEST(MeshAdvice, CountsEdgesOfTheWantedLength)
{
  const std::vector<Vector3> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
    { 3, 0, 0 }, { 3, 1, 0 } };
  Faces faces;
  faces.Corners = { { 0, 1, 2, 3 }, { 1, 4, 5, 2 } };
  MeshWishes wishes;
  wishes.Sizes.assign(points.size(), 1.2);
  EXPECT_NEAR(EdgesAsWanted(points, faces, wishes.Sizes), 5.0 / 7.0, 1e-15);
  wishes.Sizes.assign(points.size(), 1.7);
  EXPECT_NEAR(EdgesAsWanted(points, faces, wishes.Sizes), 2.0 / 7.0, 1e-15);
  // The edges between have the mean of their ends.
  wishes.Sizes = { 1, 1, 1, 1, 3, 3 };
  EXPECT_NEAR(EdgesAsWanted(points, faces, wishes.Sizes), 6.0 / 7.0, 1e-15);
}
