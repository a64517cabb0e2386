// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PieceMatching.h"

#include <gtest/gtest.h>

#include <chrono>
#include <vector>

namespace DirectionFields::Parallel
{
namespace
{
/// Appends a piece of points on a line, x = first ... last in steps of 1, whose edges are all on its border.
void AddStrip(Pieces& pieces, int first, int last, double y, double noise = 0.0)
{
  if (pieces.FirstPoint.empty())
  {
    pieces.FirstPoint.push_back(0);
  }
  const vtkIdType begin = pieces.FirstPoint.back();
  for (int x = first; x <= last; ++x)
  {
    pieces.Coordinates.insert(pieces.Coordinates.end(), { x + noise, y, 0.0 });
    if (x > first)
    {
      const vtkIdType end = begin + x - first;
      pieces.BorderEdges.insert(pieces.BorderEdges.end(), { end - 1, end });
    }
  }
  pieces.FirstPoint.push_back(begin + last - first + 1);
}

TEST(PieceMatching, JoinsPointsWithinTheToleranceAndNoOthers)
{
  Pieces pieces;
  AddStrip(pieces, 0, 9, 0.0);
  AddStrip(pieces, 5, 14, 0.0, 4e-6);
  AddStrip(pieces, 0, 14, 1e-3);
  const JoinedPoints joined = JoinPieces(pieces, 5e-6);
  EXPECT_EQ(joined.Shared, 5);
  EXPECT_EQ(joined.Count, 10 + 5 + 15);
  EXPECT_EQ(joined.Number[5], joined.Number[10]);
  EXPECT_TRUE(joined.Moved.empty());
  EXPECT_EQ(JoinPieces(pieces, 3e-6).Shared, 0);
}

TEST(PieceMatching, JoinsThreePiecesOfAPointWhoseRoundingDiffers)
{
  Pieces pieces;
  AddStrip(pieces, 0, 3, 0.0);
  AddStrip(pieces, 3, 6, 0.0, 3e-6);
  AddStrip(pieces, 3, 4, 0.0, -1e-6);
  const JoinedPoints joined = JoinPieces(pieces, 5e-6);
  EXPECT_EQ(joined.Number[3], joined.Number[4]);
  EXPECT_EQ(joined.Number[3], joined.Number[8]);
}

TEST(PieceMatching, TwoPointsOfOnePieceStayApartButTakeOnePlace)
{
  Pieces pieces;
  AddStrip(pieces, 0, 3, 0.0);
  // Beside the first strip, on the same piece: a seam.
  const vtkIdType other = pieces.FirstPoint.back();
  AddStrip(pieces, 0, 3, 1e-6);
  pieces.FirstPoint.erase(pieces.FirstPoint.begin() + 1);
  AddStrip(pieces, 100, 101, 0.0);
  ASSERT_EQ(pieces.Count(), 2u);
  const JoinedPoints joined = JoinPieces(pieces, 5e-6);
  EXPECT_EQ(joined.Shared, 0);
  EXPECT_EQ(joined.Count, 10);
  EXPECT_EQ(joined.Moved.size(), 4u);
  for (const auto& [point, place] : joined.Moved)
  {
    EXPECT_EQ(point, place + other);
  }
}

/// Two sides of a seam along x = 0 at y = 0, 1, 2, on two pieces that meet at y = 1, each side with a point beside.
TEST(PieceMatching, EdgesTellTheSidesOfASeamApart)
{
  Pieces pieces;
  pieces.FirstPoint = { 0, 6, 12 };
  for (const double y : { 0.0, 2.0 })
  {
    // Left, right, each with its point on the seam at y = 1, at the piece's end, and beside it at y = 1.
    pieces.Coordinates.insert(
      pieces.Coordinates.end(), { 0, 1, 0, 0, 1, 0, 0, y, 0, 0, y, 0, -1, 1, 0, 1, 1, 0 });
    const vtkIdType begin = y == 0.0 ? 0 : 6;
    for (const vtkIdType point : { 0, 4, 1, 5, 0, 2, 1, 3 })
    {
      pieces.BorderEdges.push_back(begin + point);
    }
  }
  const JoinedPoints joined = JoinPieces(pieces, 1e-6);
  EXPECT_EQ(joined.Number[0], joined.Number[6]);
  EXPECT_EQ(joined.Number[1], joined.Number[7]);
  EXPECT_NE(joined.Number[0], joined.Number[1]);
  EXPECT_EQ(joined.Shared, 4);
}

TEST(PieceMatching, ASheetThatEndsInsideOfAnotherPieceIsJoinedToIt)
{
  Pieces pieces;
  AddStrip(pieces, 0, 5, 0.0);
  pieces.BorderEdges.clear();
  AddStrip(pieces, 2, 4, 0.0, 1e-6);
  const JoinedPoints joined = JoinPieces(pieces, 5e-6);
  EXPECT_EQ(joined.Shared, 3);
  EXPECT_EQ(joined.Number[6], joined.Number[2]);
}

TEST(PieceMatching, GlobalIdsComeFirstWhereTheyAreRight)
{
  Pieces pieces;
  AddStrip(pieces, 0, 2, 0.0);
  AddStrip(pieces, 0, 2, 0.0);
  pieces.GlobalIds = { 7, 8, 9, 17, 18, 9 };
  EXPECT_TRUE(AreGlobalIdsRight(pieces, 1e-6));
  EXPECT_EQ(JoinPieces(pieces, 1e-6).Shared, 1);
  pieces.GlobalIds = { 7, 8, 9, 9, 18, 19 };
  EXPECT_FALSE(AreGlobalIdsRight(pieces, 1e-6));
}

TEST(PieceMatching, FindsTheNearestPointWithinTheTolerance)
{
  Pieces pieces;
  AddStrip(pieces, 0, 9, 0.0);
  AddStrip(pieces, 3, 5, 2e-6);
  const WantedPoints wanted = { { 4.0, 1.5e-6, 0.0, 7.0, 0.0, 1e-6, 7.0, 1e-3, 0.0 }, {} };
  EXPECT_EQ(FindPoints(pieces, wanted, 5e-6), (std::vector<vtkIdType>{ 11, 7, -1 }));
}

/// Points much denser than the tolerance, and many at one place: neither may be compared with each other.
TEST(PieceMatching, DensePointsTakeLinearTime)
{
  Pieces pieces;
  pieces.FirstPoint = { 0 };
  for (int piece = 0; piece < 2; ++piece)
  {
    for (int i = 0; i < 200000; ++i)
    {
      pieces.Coordinates.insert(
        pieces.Coordinates.end(), { i < 100000 ? i * 1e-12 : 1.0, 0.0, 0.0 });
      if (i > 0)
      {
        const vtkIdType point = pieces.FirstPoint.back() + i;
        pieces.BorderEdges.insert(pieces.BorderEdges.end(), { point - 1, point });
      }
    }
    pieces.FirstPoint.push_back(200000 * (piece + 1));
  }
  const auto began = std::chrono::steady_clock::now();
  // Of the many at one place an edge tells the first one apart.
  EXPECT_EQ(JoinPieces(pieces, 1e-6).Shared, 100001);
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(30));
}
}
}
