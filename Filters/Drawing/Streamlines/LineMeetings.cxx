// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Streamlines/LineMeetings.h"

#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index FewTriangles = 64;
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

/// Adds the meeting of two segments of one triangle, if there is any.
void Meet(const Segment& a, const Segment& b, std::vector<Meeting>& meetings)
{
  const Complex along = a.End - a.Begin;
  const Complex other = b.End - b.Begin;
  const Complex apart = b.Begin - a.Begin;
  const double determinant = Cross(along, other);
  if (determinant == 0.0)
  {
    return;
  }
  const double s = Cross(apart, other) / determinant;
  const double t = Cross(apart, along) / determinant;
  const auto isInside = [](double part) { return part >= -Beyond && part <= 1.0 + Beyond; };
  if (!isInside(s) || !isInside(t) || IsAtZero(a, s) || IsAtZero(b, t))
  {
    return;
  }
  const double atA = a.Arc + s * std::abs(along);
  const double atB = b.Arc + t * std::abs(other);
  if (a.Line == b.Line && std::abs(a.Number - b.Number) <= 1)
  {
    return;
  }
  const bool aIsLate = atA != atB ? atA > atB : a.Line > b.Line;
  meetings.push_back(
    aIsLate ? Meeting{ a.Line, b.Line, atA, atB } : Meeting{ b.Line, a.Line, atB, atA });
}
}

std::vector<Meeting> FindMeetings(const GivenField& field,
  const std::vector<const std::vector<LinePiece>*>& lines, double length,
  const std::function<bool(Index, Index)>& isSame)
{
  const TriangleMesh& mesh = field.GetMesh();
  std::vector<Segment> segments;
  for (Index i = 0; i < static_cast<Index>(lines.size()); ++i)
  {
    const std::vector<LinePiece>& pieces = *lines[i];
    for (Index k = 0; k < static_cast<Index>(pieces.size()) && pieces[k].Arc <= length; ++k)
    {
      const LinePiece& piece = pieces[k];
      // Lines set out from singularities; the last piece of a line may lead into one.
      Segment segment{ piece.Triangle, i, k, piece.Begin, piece.End, piece.Arc, k == 0,
        k + 1 == static_cast<Index>(pieces.size()) };
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
  ParallelFor(groups, FewTriangles,
    [&](Index begin, Index end)
    {
      for (Index g = begin; g < end; ++g)
      {
        for (std::size_t a = first[g]; a < first[g + 1]; ++a)
        {
          for (std::size_t b = a + 1; b < first[g + 1]; ++b)
          {
            if (!isSame(segments[a].Line, segments[b].Line))
            {
              Meet(segments[a], segments[b], found[begin / FewTriangles]);
            }
          }
        }
      }
    });
  std::vector<Meeting> meetings;
  for (const std::vector<Meeting>& part : found)
  {
    meetings.insert(meetings.end(), part.begin(), part.end());
  }
  return meetings;
}
}
