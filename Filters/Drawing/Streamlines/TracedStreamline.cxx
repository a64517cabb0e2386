// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Streamlines/TracedStreamline.h"

#include <cmath>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Follows a trace on from the pieces that a line has.
void Follow(
  StreamlineTrace& trace, const PieceLimit& limit, double mostLength, TracedStreamline& line)
{
  const double before = line.Length();
  while (line.Length() < mostLength)
  {
    std::optional<LinePiece> piece = trace.Next();
    if (!piece)
    {
      break;
    }
    if (line.Pieces.size() % PieceLimit::PerCall == PieceLimit::PerCall - 1)
    {
      limit.Count(line.Pieces.size());
    }
    piece->Arc += before;
    const double left = mostLength - piece->Arc;
    const double length = piece->Length();
    if (length > left)
    {
      piece->End = piece->Begin + (left / length) * (piece->End - piece->Begin);
      line.Pieces.push_back(*piece);
      line.Ends[1] = StreamlineEnd::Length;
      return;
    }
    line.Pieces.push_back(*piece);
  }
  line.Ends[1] = trace.End() == StreamlineEnd::None ? StreamlineEnd::Length : trace.End();
  line.Zeros[1] = trace.EndZero();
}
}

TracedStreamline Joined(TracedStreamline&& backward, TracedStreamline&& forward)
{
  TracedStreamline line = std::move(forward);
  std::vector<LinePiece> pieces;
  pieces.reserve(backward.Pieces.size() + line.Pieces.size());
  for (auto piece = backward.Pieces.rbegin(); piece != backward.Pieces.rend(); ++piece)
  {
    pieces.push_back(piece->Reversed());
  }
  pieces.insert(pieces.end(), line.Pieces.begin(), line.Pieces.end());
  line.Pieces = std::move(pieces);
  line.Ends[0] = backward.Ends[1];
  line.Zeros[0] = backward.Zeros[1];
  return line;
}

TracedStreamline TraceLine(const TracedField& field, const LineStart& start, double mostLength)
{
  TracedStreamline line;
  line.Sense = start.Sense;
  StreamlineTrace trace(field, start);
  Follow(trace, field.Limit, mostLength, line);
  return line;
}

RayStart StartOf(const TracedField& field, const ZeroRay& ray)
{
  const SingularPoint& zero = field.Zeros.GetZeros()[ray.Zero];
  RayStart start;
  start.Start =
    WalkStraight(field.Field, { zero.Triangle, zero.Place, std::polar(1.0, ray.Angle), ray.Sense },
      ray.Radius, &start.Pieces);
  // It leaves almost straight.
  const double area = field.Field.GetGeometry().Lengths.Area[zero.Triangle];
  start.FreeUntil = 4.0 * field.Capture * std::sqrt(2.0 * area);
  return start;
}

TracedStreamline BeginOf(const ZeroRay& ray, const RayStart& start)
{
  TracedStreamline line;
  line.Sense = ray.Sense;
  line.Seed = ray.Zero;
  line.Zeros[0] = ray.Zero;
  line.Ends[0] = StreamlineEnd::Singularity;
  line.Ends[1] = start.Start.Triangle == None ? StreamlineEnd::Boundary : StreamlineEnd::None;
  line.Pieces = start.Pieces;
  return line;
}

TracedStreamline TraceRay(const TracedField& field, const ZeroRay& ray, double mostLength)
{
  const RayStart start = StartOf(field, ray);
  TracedStreamline line = BeginOf(ray, start);
  if (start.Start.Triangle != None)
  {
    StreamlineTrace trace(field, start.Start);
    trace.StartAtZero(start.FreeUntil);
    Follow(trace, field.Limit, mostLength, line);
  }
  return line;
}
}
