// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TracedStreamline_h
#define DirectionFields_TracedStreamline_h

#include "Streamlines/StreamlineTrace.h"

#include <array>
#include <vector>

namespace DirectionFields::Internal
{
/// A line along a field.
struct TracedStreamline
{
  /// In their order; the arcs of those before the seed are negative.
  std::vector<LinePiece> Pieces;
  /// Why it ends, at its begin and at its end.
  std::array<StreamlineEnd, 2> Ends = { StreamlineEnd::None, StreamlineEnd::None };
  /// The singularities that it ends in; None if it does not.
  std::array<Index, 2> Zeros = { None, None };
  /// The lines that it stops at, for StreamlineEnd::Crossing; None else.
  std::array<Index, 2> Crossed = { None, None };
  /// Number of the seed: of the point given, or of the singularity.
  Index Seed = None;
  /// -1 where the field points against the line.
  int Sense = 1;
  bool IsClosed = false;
  /// The component of the surface.
  Index Component = None;

  /// In the unit of the component.
  double Length() const
  {
    return this->Pieces.empty()
      ? 0.0
      : this->Pieces.back().Arc + this->Pieces.back().Length() - this->Pieces.front().Arc;
  }
};

/// One line of two from the same seed, of which the first one is turned around.
/// @param backward runs against the field's direction of the other one
TracedStreamline Joined(TracedStreamline&& backward, TracedStreamline&& forward);

/// Traces a line in one direction until it ends by itself or is as long as given.
TracedStreamline TraceLine(const TracedField& field, const LineStart& start, double mostLength);

/// The start of the line along a ray of a singularity, at a small distance from that, and the
/// straight pieces from the singularity to there.
struct RayStart
{
  /// Its triangle is None where the pieces leave the surface.
  LineStart Start;
  std::vector<LinePiece> Pieces;
  /// The line's length from Start on until which it cannot run into the singularity that it comes
  /// from.
  double FreeUntil;
};
RayStart StartOf(const TracedField& field, const ZeroRay& ray);

/// The streamline from a singularity as far as these pieces.
TracedStreamline BeginOf(const ZeroRay& ray, const RayStart& start);

/// Traces a line from a singularity.
TracedStreamline TraceRay(const TracedField& field, const ZeroRay& ray, double mostLength);

/// The families of lines of a field of degree n: lines that cross are of different ones. n / 2 for
/// even n, which have opposite directions, else n.
inline int NumberOfFamilies(int degree)
{
  return degree % 2 == 0 ? degree / 2 : degree;
}
}

#endif
