// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Streamlines/LineMeetings.h"

#include "Support/Threads.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index FewTriangles = 64;
/// All pairs of so many segments of a triangle are compared.
constexpr std::size_t FewSegments = 32;
/// Crossings this much beyond the end of a piece, as a part of it, are no less crossings: rounding
/// must not open a gap between two pieces.
constexpr double Beyond = 1e-9;
/// A meeting nearer to the common singularity of two pieces than this part of them is the
/// singularity.
constexpr double AtZero = 1e-6;

/// A piece as seen on the front.
struct Segment
{
  Index Triangle, Line, Number;
  Complex Begin, End;
  double Arc;
  /// Whether it begins or ends in a singularity.
  bool FromZero, ToZero;
};

double Cross(const Complex& a, const Complex& b)
{
  return a.real() * b.imag() - a.imag() * b.real();
}

bool IsAtZero(const Segment& segment, double part)
{
  return (segment.FromZero && part < AtZero) || (segment.ToZero && part > 1.0 - AtZero);
}

/// The meeting of two segments of one triangle, if there is any.
std::optional<Meeting> MeetingOf(const Segment& a, const Segment& b)
{
  const Complex along = a.End - a.Begin;
  const Complex other = b.End - b.Begin;
  const Complex apart = b.Begin - a.Begin;
  const double determinant = Cross(along, other);
  if (determinant == 0.0)
  {
    return {};
  }
  const double s = Cross(apart, other) / determinant;
  const double t = Cross(apart, along) / determinant;
  const auto isInside = [](double part) { return part >= -Beyond && part <= 1.0 + Beyond; };
  if (!isInside(s) || !isInside(t) || IsAtZero(a, s) || IsAtZero(b, t))
  {
    return {};
  }
  const double atA = a.Arc + s * std::abs(along);
  const double atB = b.Arc + t * std::abs(other);
  if (a.Line == b.Line && std::abs(a.Number - b.Number) <= 1)
  {
    return {};
  }
  const bool aIsLate = atA != atB ? atA > atB : a.Line > b.Line;
  return aIsLate ? Meeting{ a.Line, b.Line, atA, atB } : Meeting{ b.Line, a.Line, atB, atA };
}

/// Finds the pairs of segments whose boxes overlap. A line that winds around crosses the same
/// triangle thousands of times, in parallel to itself: the segments along either of two
/// perpendicular directions are passed through across it, where few of them overlap.
class Overlaps
{
public:
  Overlaps(std::vector<Segment>::const_iterator begin, std::vector<Segment>::const_iterator end)
  {
    const auto lengthOf = [](const Segment& segment)
    { return std::abs(segment.End - segment.Begin); };
    const Segment& longest = *std::max_element(
      begin, end, [&](const Segment& a, const Segment& b) { return lengthOf(a) < lengthOf(b); });
    const double length = lengthOf(longest);
    const Complex turn = length > 0.0 ? std::conj(longest.End - longest.Begin) / length : 1.0;
    // Crossings beyond the ends count, and the turn rounds.
    const double margin = 1e-6 * length;
    for (auto segment = begin; segment != end; ++segment)
    {
      const Complex p = turn * segment->Begin;
      const Complex q = turn * segment->End;
      const Box box{ { std::min(p.real(), q.real()) - margin,
                       std::min(p.imag(), q.imag()) - margin },
        { std::max(p.real(), q.real()) + margin, std::max(p.imag(), q.imag()) + margin },
        static_cast<std::size_t>(segment - begin) };
      const bool isAlong = std::abs(p.real() - q.real()) >= std::abs(p.imag() - q.imag());
      this->Boxes[isAlong ? 0 : 1].push_back(box);
    }
    // Those along the first direction are ordered by the second coordinate, others by the first.
    for (const int family : { 0, 1 })
    {
      Sort(this->Boxes[family], 1 - family);
    }
  }

  /// Calls visit(i, k) once for each pair, in any order, until it is false.
  template <typename Visit>
  void ForEach(const Visit& visit)
  {
    for (const int family : { 0, 1 })
    {
      const std::vector<Box>& boxes = this->Boxes[family];
      for (std::size_t i = 0; i < boxes.size(); ++i)
      {
        if (!VisitFrom(boxes[i], boxes, i + 1, 1 - family, visit))
        {
          return;
        }
      }
    }
    Sort(this->Boxes[0], 0);
    for (const int family : { 0, 1 })
    {
      // Each pair of one of both families is found from the box that begins first.
      const std::vector<Box>& others = this->Boxes[1 - family];
      std::size_t first = 0;
      for (const Box& box : this->Boxes[family])
      {
        const auto isBefore = [&](const Box& other)
        { return family == 0 ? other.Least[0] < box.Least[0] : other.Least[0] <= box.Least[0]; };
        while (first < others.size() && isBefore(others[first]))
        {
          ++first;
        }
        if (!VisitFrom(box, others, first, 0, visit))
        {
          return;
        }
      }
    }
  }

private:
  struct Box
  {
    std::array<double, 2> Least;
    std::array<double, 2> Most;
    std::size_t Number;
  };

  static void Sort(std::vector<Box>& boxes, int axis)
  {
    std::sort(boxes.begin(), boxes.end(),
      [axis](const Box& a, const Box& b) { return a.Least[axis] < b.Least[axis]; });
  }

  template <typename Visit>
  static bool VisitFrom(
    const Box& box, const std::vector<Box>& others, std::size_t first, int axis, const Visit& visit)
  {
    for (std::size_t k = first; k < others.size() && others[k].Least[axis] <= box.Most[axis]; ++k)
    {
      const int across = 1 - axis;
      if (others[k].Least[across] <= box.Most[across] &&
        box.Least[across] <= others[k].Most[across] &&
        !visit(std::min(box.Number, others[k].Number), std::max(box.Number, others[k].Number)))
      {
        return false;
      }
    }
    return true;
  }

  std::array<std::vector<Box>, 2> Boxes;
};

/// Adds the meetings of the segments of one triangle, in the order of the segments.
/// @return how many there are; not all of them where that is more than most
std::size_t AddMeetings(std::vector<Segment>::const_iterator begin,
  std::vector<Segment>::const_iterator end, const std::function<bool(Index, Index)>& isSame,
  std::size_t most, std::vector<Meeting>& meetings)
{
  struct Found
  {
    std::size_t First, Second;
    Meeting Where;
  };
  std::vector<Found> found;
  const auto visit = [&](std::size_t a, std::size_t b)
  {
    if (isSame(begin[a].Line, begin[b].Line))
    {
      return true;
    }
    if (const std::optional<Meeting> meeting = MeetingOf(begin[a], begin[b]))
    {
      found.push_back({ a, b, *meeting });
    }
    return found.size() <= most;
  };
  const auto count = static_cast<std::size_t>(end - begin);
  if (count > FewSegments)
  {
    Overlaps(begin, end).ForEach(visit);
    std::sort(found.begin(), found.end(),
      [](const Found& one, const Found& other)
      { return std::tie(one.First, one.Second) < std::tie(other.First, other.Second); });
  }
  else
  {
    for (std::size_t a = 0; a < count; ++a)
    {
      for (std::size_t b = a + 1; b < count; ++b)
      {
        visit(a, b);
      }
    }
  }
  for (const Found& one : found)
  {
    meetings.push_back(one.Where);
  }
  return found.size();
}

/// The pieces of all trails, as seen on the front.
std::vector<Segment> SegmentsOf(const GivenField& field, const std::vector<Trail>& trails)
{
  const TriangleMesh& mesh = field.GetMesh();
  std::vector<Segment> segments;
  for (Index i = 0; i < static_cast<Index>(trails.size()); ++i)
  {
    const std::vector<LinePiece>& pieces = *trails[i].Pieces;
    const auto count = static_cast<Index>(pieces.size());
    for (Index k = 0; k < count && pieces[k].Arc <= trails[i].Length; ++k)
    {
      const LinePiece& piece = pieces[k];
      // Lines set out from singularities; the last piece of a line may lead into one.
      Segment segment{ piece.Triangle, i, k, piece.Begin, piece.End, piece.Arc, k == 0,
        k + 1 == count };
      if (!mesh.IsFront(piece.Triangle))
      {
        segment.Triangle = mesh.Mirror(3 * piece.Triangle) / 3;
        segment.Begin = Mirrored(field, piece.Triangle, piece.Begin);
        segment.End = Mirrored(field, piece.Triangle, piece.End);
      }
      segments.push_back(segment);
    }
  }
  std::stable_sort(segments.begin(), segments.end(),
    [](const Segment& a, const Segment& b) { return a.Triangle < b.Triangle; });
  return segments;
}
}

std::optional<std::vector<Meeting>> FindMeetings(const GivenField& field,
  const std::vector<Trail>& trails, const std::function<bool(Index, Index)>& isSame,
  std::size_t most)
{
  const std::vector<Segment> segments = SegmentsOf(field, trails);
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    if (i == 0 || segments[i].Triangle != segments[i - 1].Triangle)
    {
      first.push_back(i);
    }
  }
  first.push_back(segments.size());
  const auto groups = static_cast<Index>(first.size()) - 1;
  std::vector<std::vector<Meeting>> found(NumberOfPieces(groups, FewTriangles));
  std::atomic<std::size_t> counted{ 0 };
  ParallelFor(groups, FewTriangles,
    [&](Index begin, Index end)
    {
      for (Index g = begin; g < end && counted <= most; ++g)
      {
        counted += AddMeetings(segments.begin() + static_cast<std::ptrdiff_t>(first[g]),
          segments.begin() + static_cast<std::ptrdiff_t>(first[g + 1]), isSame, most,
          found[begin / FewTriangles]);
      }
    });
  if (counted > most)
  {
    return {};
  }
  std::vector<Meeting> meetings;
  for (const std::vector<Meeting>& part : found)
  {
    meetings.insert(meetings.end(), part.begin(), part.end());
  }
  return meetings;
}
}
