// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Stripes/StripeLines.h"

#include "Support/Threads.h"

#include <algorithm>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
constexpr std::int64_t Nothing = -1;

struct Segment
{
  std::int64_t From;
  std::int64_t To;
};

/// Segments with the two that meet at each point.
class SegmentChains
{
public:
  SegmentChains(std::vector<Segment>&& segments, std::int64_t points)
    : Segments(std::move(segments))
    , Slots(2 * points)
    , Taken(this->Segments.size(), 0)
  {
    std::fill(this->Slots.begin(), this->Slots.end(), Nothing);
    for (std::size_t s = 0; s < this->Segments.size(); ++s)
    {
      // A segment that leaves a point has the first place there if that is free.
      this->Put(this->Segments[s].From, 0, static_cast<std::int64_t>(s));
      this->Put(this->Segments[s].To, 1, static_cast<std::int64_t>(s));
    }
  }

  std::int64_t Size() const { return static_cast<std::int64_t>(this->Segments.size()); }
  const Segment& At(std::int64_t s) const { return this->Segments[s]; }
  bool IsTaken(std::int64_t s) const { return this->Taken[s] != 0; }
  bool IsEnd(std::int64_t point) const
  {
    return this->Slots[2 * point] == Nothing || this->Slots[2 * point + 1] == Nothing;
  }

  /// Adds the points of the chain that leaves a point by a segment.
  void Follow(std::int64_t segment, std::int64_t point, std::vector<std::int64_t>& points)
  {
    points.push_back(point);
    while (segment != Nothing && !this->Taken[segment])
    {
      this->Taken[segment] = 1;
      const Segment& way = this->Segments[segment];
      point = way.From == point ? way.To : way.From;
      points.push_back(point);
      const std::int64_t first = this->Slots[2 * point];
      segment = first == segment ? this->Slots[2 * point + 1] : first;
    }
  }

private:
  void Put(std::int64_t point, int slot, std::int64_t segment)
  {
    std::int64_t* const slots = this->Slots.data() + 2 * point;
    slots[slots[slot] == Nothing ? slot : 1 - slot] = segment;
  }

  std::vector<Segment> Segments;
  LargeArray<std::int64_t> Slots;
  std::vector<char> Taken;
};

/// The levels through a surface, triangle by triangle.
class Levels
{
public:
  Levels(const StripePieces& pieces, const std::vector<char>& isGhost)
    : Pieces(pieces)
    , IsGhost(isGhost)
    , OwnPoints(pieces.GetLevels().GetNumberOfCrossings() +
        static_cast<std::int64_t>(pieces.GetInnerPoints().size()))
  {
    this->AddStraight();
    this->AddAtCenters();
  }

  std::vector<Segment> TakeSegments() { return std::move(this->Segments); }
  std::int64_t GetNumberOfPoints() const
  {
    return this->OwnPoints + static_cast<std::int64_t>(this->Ends.size());
  }

  /// The center that a line ends in at a point, which is replaced by the center's; None at others.
  Index CenterAt(std::int64_t& point) const
  {
    if (point < this->OwnPoints)
    {
      return None;
    }
    const Index center = this->Ends[point - this->OwnPoints];
    point = this->Pieces.GetCenters()[center].Point;
    return center;
  }

private:
  bool Counts(Index triangle) const
  {
    const TriangleMesh& mesh = this->Pieces.GetLevels().GetWanted().GetMesh();
    return this->IsGhost.empty() || !this->IsGhost[mesh.InputTriangle(triangle)];
  }

  void AddStraight()
  {
    const Index triangles = this->Pieces.GetLevels().GetWanted().GetMesh().GetNumberOfTriangles();
    constexpr Index size = HeavyPiece;
    std::vector<std::vector<Segment>> found(NumberOfPieces(triangles, size));
    ParallelFor(triangles, size,
      [&](Index begin, Index end)
      {
        std::vector<Segment>& segments = found[begin / size];
        this->Pieces.ForStraight(begin, end,
          [&](Index triangle, const StripePiece& piece)
          {
            if (this->Counts(triangle))
            {
              piece.ForLevels(
                [&](std::int64_t from, std::int64_t to) {
                  segments.push_back({ from, to });
                });
            }
          });
      });
    for (const std::vector<Segment>& part : found)
    {
      this->Segments.insert(this->Segments.end(), part.begin(), part.end());
    }
  }

  /// Several lines may end in a center: each gets an end of its own after all other points.
  void AddAtCenters()
  {
    const std::vector<StripePieces::Center>& centers = this->Pieces.GetCenters();
    for (std::size_t k = 0; k < this->Pieces.GetPiecesAtCenters().size(); ++k)
    {
      const Index center = this->Pieces.GetPieceCenters()[k];
      const std::int64_t middle = centers[center].Point;
      const auto endOf = [&](std::int64_t point)
      {
        if (point != middle)
        {
          return point;
        }
        this->Ends.push_back(center);
        return this->GetNumberOfPoints() - 1;
      };
      if (this->Counts(centers[center].Triangle))
      {
        this->Pieces.GetPiecesAtCenters()[k].ForLevels(
          [&](std::int64_t from, std::int64_t to)
          {
            const std::int64_t begin = endOf(from);
            this->Segments.push_back({ begin, endOf(to) });
          });
      }
    }
  }

  const StripePieces& Pieces;
  const std::vector<char>& IsGhost;
  /// The points that StripePieces numbers.
  std::int64_t OwnPoints;
  std::vector<Segment> Segments;
  /// The centers of the points after those.
  std::vector<Index> Ends;
};
}

StripeLines::StripeLines(const StripePieces& pieces, const std::vector<char>& isGhost)
{
  Levels levels(pieces, isGhost);
  SegmentChains chains(levels.TakeSegments(), levels.GetNumberOfPoints());
  const auto add = [&](std::int64_t segment, std::int64_t point, bool closed)
  {
    chains.Follow(segment, point, this->Points);
    const Index begin = levels.CenterAt(this->Points[this->Offsets.back()]);
    const Index end = levels.CenterAt(this->Points.back());
    this->Offsets.push_back(static_cast<std::int64_t>(this->Points.size()));
    this->Closed.push_back(closed ? 1 : 0);
    this->EndCenters.push_back({ begin, end });
  };
  // First from the begins of lines, then from their ends: some lines change their sense between two
  // ends.
  for (std::int64_t s = 0; s < chains.Size(); ++s)
  {
    if (!chains.IsTaken(s) && chains.IsEnd(chains.At(s).From))
    {
      add(s, chains.At(s).From, false);
    }
  }
  for (std::int64_t s = 0; s < chains.Size(); ++s)
  {
    if (!chains.IsTaken(s) && chains.IsEnd(chains.At(s).To))
    {
      add(s, chains.At(s).To, false);
    }
  }
  for (std::int64_t s = 0; s < chains.Size(); ++s)
  {
    if (!chains.IsTaken(s))
    {
      add(s, chains.At(s).From, true);
    }
  }
}
}
