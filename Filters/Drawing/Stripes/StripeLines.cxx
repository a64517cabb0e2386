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
}

StripeLines::StripeLines(const StripePieces& pieces, const std::vector<char>& isGhost)
{
  const TriangleMesh& mesh = pieces.GetLevels().GetWanted().GetMesh();
  const auto counts = [&](Index triangle)
  { return isGhost.empty() || !isGhost[mesh.InputTriangle(triangle)]; };
  constexpr Index size = HeavyPiece;
  std::vector<std::vector<Segment>> found(NumberOfPieces(mesh.GetNumberOfTriangles(), size));
  ParallelFor(mesh.GetNumberOfTriangles(), size,
    [&](Index begin, Index end)
    {
      std::vector<Segment>& segments = found[begin / size];
      pieces.ForStraight(begin, end,
        [&](Index triangle, const StripePiece& piece)
        {
          if (counts(triangle))
          {
            piece.ForLevels(
              [&](std::int64_t from, std::int64_t to) {
                segments.push_back({ from, to });
              });
          }
        });
    });
  std::vector<Segment> segments;
  for (const std::vector<Segment>& part : found)
  {
    segments.insert(segments.end(), part.begin(), part.end());
  }
  // Several lines may end in a center: each gets an end of its own after all other points.
  const std::vector<StripePieces::Center>& centers = pieces.GetCenters();
  const std::int64_t ownPoints = pieces.GetLevels().GetNumberOfCrossings() +
    static_cast<std::int64_t>(pieces.GetInnerPoints().size());
  std::vector<Index> ends;
  for (std::size_t k = 0; k < pieces.GetPiecesAtCenters().size(); ++k)
  {
    const Index center = pieces.GetPieceCenters()[k];
    const std::int64_t middle = centers[center].Point;
    const auto endOf = [&](std::int64_t point)
    {
      if (point != middle)
      {
        return point;
      }
      ends.push_back(center);
      return ownPoints + static_cast<std::int64_t>(ends.size()) - 1;
    };
    if (counts(centers[center].Triangle))
    {
      pieces.GetPiecesAtCenters()[k].ForLevels(
        [&](std::int64_t from, std::int64_t to)
        {
          const std::int64_t begin = endOf(from);
          segments.push_back({ begin, endOf(to) });
        });
    }
  }
  SegmentChains chains(std::move(segments), ownPoints + static_cast<std::int64_t>(ends.size()));
  const auto centerOf = [&](std::int64_t& point) -> Index
  {
    if (point < ownPoints)
    {
      return None;
    }
    const Index center = ends[point - ownPoints];
    point = centers[center].Point;
    return center;
  };
  const auto add = [&](std::int64_t segment, std::int64_t point, bool closed)
  {
    chains.Follow(segment, point, this->Points);
    const Index begin = centerOf(this->Points[this->Offsets.back()]);
    const Index end = centerOf(this->Points.back());
    this->Offsets.push_back(static_cast<std::int64_t>(this->Points.size()));
    this->Closed.push_back(closed ? 1 : 0);
    this->EndCenters.push_back({ begin, end });
  };
  // First from where lines begin, then from where they end, which are some that change their sense on the way.
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
