// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "Streamlines/LineMeetings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
using Lines = std::vector<std::vector<LinePiece>>;

/// A line of one piece, between two others that are elsewhere, so that no end is a singularity.
std::vector<LinePiece> LineThrough(const Complex& begin, const Complex& end)
{
  std::vector<LinePiece> pieces(3);
  pieces[0].Triangle = 1;
  pieces[1] = { 0, begin, end, end - begin, end - begin, 0.5 };
  pieces[2].Triangle = 2;
  pieces[2].Arc = 0.5 + std::abs(end - begin);
  return pieces;
}

/// All meetings, or none where there are more than most.
std::vector<Meeting> MeetingsOf(const Lines& lines, std::size_t most = 1000000)
{
  const Surface surface = Meshes::Square(4);
  const Result computed = Fields::Compute(surface, 4);
  const GivenField field(surface, Fields::Of(computed));
  std::vector<Trail> trails;
  for (const std::vector<LinePiece>& line : lines)
  {
    trails.push_back({ &line, 1e9 });
  }
  return FindMeetings(
    field, trails, [](Index, Index) { return false; }, most)
    .value_or(std::vector<Meeting>());
}

double SideOf(const Complex& p, const Complex& a, const Complex& b)
{
  return (std::conj(b - a) * (p - a)).imag();
}

/// Whether each of two segments has its ends on both sides of the other.
bool DoCross(const LinePiece& one, const LinePiece& other)
{
  return SideOf(one.Begin, other.Begin, other.End) * SideOf(one.End, other.Begin, other.End) <
    0.0 &&
    SideOf(other.Begin, one.Begin, one.End) * SideOf(other.End, one.Begin, one.End) < 0.0;
}

/// Compares with all pairs, in their order.
void ExpectAllMeetings(const Lines& lines)
{
  const std::vector<Meeting> found = MeetingsOf(lines);
  std::size_t next = 0;
  for (Index a = 0; a < static_cast<Index>(lines.size()); ++a)
  {
    for (Index b = a + 1; b < static_cast<Index>(lines.size()); ++b)
    {
      if (DoCross(lines[a][1], lines[b][1]))
      {
        ASSERT_LT(next, found.size());
        const Meeting& meeting = found[next++];
        EXPECT_EQ(std::minmax(meeting.Line, meeting.Other), std::minmax(a, b));
        const auto at = [&](Index line, double arc)
        {
          const LinePiece& piece = lines[line][1];
          return piece.Begin + (arc - piece.Arc) / piece.Length() * (piece.End - piece.Begin);
        };
        EXPECT_LT(
          std::abs(at(meeting.Line, meeting.Late) - at(meeting.Other, meeting.Early)), 1e-9);
      }
    }
  }
  EXPECT_EQ(next, found.size());
}
}

TEST(LineMeetings, AreThoseOfAllPairsOfSegments)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto somewhere = [&] { return Complex(uniform(random), uniform(random)); };
  for (const int count : { 2, 20, 33, 300 })
  {
    for (const double length : { 0.05, 1.0 })
    {
      Lines lines;
      for (int i = 0; i < count; ++i)
      {
        const Complex begin = somewhere();
        lines.push_back(LineThrough(begin, begin + length * (somewhere() - 0.5)));
      }
      ExpectAllMeetings(lines);
    }
  }
}

TEST(LineMeetings, OfTwoFamiliesAreAllTheirPairs)
{
  // As of a line that winds around: nearly parallel, at any angle, and crossed by others.
  for (const double angle : { 0.0, 0.3, 0.7853981633974483, 1.4 })
  {
    Lines lines;
    const Complex turn = std::polar(1.0, angle);
    for (int i = 0; i < 40; ++i)
    {
      const double across = 0.02 * i;
      lines.push_back(
        LineThrough(turn * Complex(-1.0, across), turn * Complex(1.0, across + 0.001)));
      lines.push_back(LineThrough(turn * Complex(across, -1.0), turn * Complex(across, 1.0)));
    }
    ExpectAllMeetings(lines);
    EXPECT_EQ(MeetingsOf(lines).size(), 1600u);
    EXPECT_EQ(MeetingsOf(lines, 1600).size(), 1600u);
    EXPECT_EQ(MeetingsOf(lines, 1599).size(), 0u);
  }
}
