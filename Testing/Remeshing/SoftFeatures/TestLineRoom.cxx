// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SoftFeatures/LineRoom.h"

#include <gtest/gtest.h>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
constexpr double Width = 1.0;
constexpr double Spacing = 0.5;

/// Places on a line of the plane z = 0 that looks up.
std::vector<LineRoom::Place> Line(
  const LineRoom& room, const Vector3& start, const Vector3& end, double up = 1.0)
{
  std::vector<LineRoom::Place> places;
  room.AppendPlaces(start, end, Vector3(0.0, 0.0, up), places);
  return places;
}

/// A room with a line from (0, 0) to (10, 0), of number 7.
LineRoom Example()
{
  LineRoom room(Width, Spacing);
  room.Add(Line(room, Vector3::Zero(), Vector3(10.0, 0.0, 0.0)), 7);
  return room;
}
}

TEST(LineRoom, PlacesAreAsCloseAsTheSpacing)
{
  const LineRoom room(Width, Spacing);
  const std::vector<LineRoom::Place> places = Line(room, Vector3::Zero(), Vector3(3.2, 0.0, 0.0));
  ASSERT_EQ(places.size(), 7u);
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    EXPECT_NEAR(places[k].Position.x(), 3.2 * (static_cast<double>(k) + 0.5) / 7.0, 1e-12);
    EXPECT_EQ(places[k].Along, Vector3(1.0, 0.0, 0.0));
  }
  EXPECT_EQ(Line(room, Vector3::Zero(), Vector3::Zero()).size(), 1u);
}

TEST(LineRoom, OnlyLinesWithinTheRoomAreBeside)
{
  const LineRoom room = Example();
  for (const double side : { -1.0, 1.0 })
  {
    const auto at = [&](double y)
    { return Line(room, Vector3(0.0, side * y, 0.0), Vector3(10.0, side * y, 0.0)); };
    EXPECT_EQ(room.CrowdedPart(at(0.9)), 1.0);
    EXPECT_EQ(room.LinesBeside(at(0.9)), std::vector<Index>({ 7 }));
    EXPECT_EQ(room.CrowdedPart(at(1.1)), 0.0);
    EXPECT_TRUE(room.LinesBeside(at(1.1)).empty());
  }
  // One that is beside it for half of its way.
  EXPECT_NEAR(
    room.CrowdedPart(Line(room, Vector3(5.0, 0.5, 0.0), Vector3(15.0, 0.5, 0.0))), 0.5, 0.051);
}

TEST(LineRoom, LinesThatCrossContinueOrAreOnTheOtherSideAreNoMatter)
{
  const LineRoom room = Example();
  EXPECT_EQ(room.CrowdedPart(Line(room, Vector3(5.0, -5.0, 0.0), Vector3(5.0, 5.0, 0.0))), 0.0);
  EXPECT_EQ(room.CrowdedPart(Line(room, Vector3(10.0, 0.0, 0.0), Vector3(20.0, 0.0, 0.0))), 0.0);
  EXPECT_EQ(
    room.CrowdedPart(Line(room, Vector3(0.0, 0.5, 0.0), Vector3(10.0, 0.5, 0.0), -1.0)), 0.0);
}

TEST(LineRoom, AnyNumbersArePlaces)
{
  LineRoom room(1e-300, 1e-300);
  const std::vector<LineRoom::Place> places =
    Line(room, Vector3(-1e300, 0.0, 0.0), Vector3(1e300, 0.0, 0.0));
  EXPECT_FALSE(places.empty());
  EXPECT_LE(places.size(), 100000u);
  EXPECT_EQ(room.CrowdedPart({}), 0.0);
  room.Add({ places.front() }, 0);
  EXPECT_EQ(room.CrowdedPart({ places.back() }), 0.0);
}
