// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_EdgeMatching_h
#define DirectionFields_EdgeMatching_h

#include "Support/LargeArray.h"
#include "Types.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Which half-edges of triangles are two sides of one edge, whatever the winding. Half-edge 3 t + c
/// runs from corner c of triangle t to the next one.
struct EdgeMatching
{
  struct Counts
  {
    /// Edges of more than two triangles, those apart that are shared by two sheets.
    Index NonManifold = 0;
    /// Edges of four triangles, two of which have the same corners and opposite windings. Each of
    /// these goes on in one of the others: there are two edges at the same place.
    Index Shared = 0;
    /// Edges whose two triangles have the third corner in common, too.
    Index Duplicate = 0;
    /// Edges whose two triangles are wound against each other.
    Index Reversed = 0;

    void operator+=(const Counts& other)
    {
      this->NonManifold += other.NonManifold;
      this->Shared += other.Shared;
      this->Duplicate += other.Duplicate;
      this->Reversed += other.Reversed;
    }
  };

  /// @param corners  three of each triangle, all different; the triangles sorted by the least ones
  /// @param vertices number of vertices
  EdgeMatching(const LargeArray<Index>& corners, Index vertices);

  /// The other side of each half-edge; None on the boundary and where the edge has more than two
  /// triangles.
  LargeArray<Index> Twins;
  /// Whether the edge of a half-edge was not matched because it has more than two triangles; empty
  /// where no edge has.
  std::vector<char> IsNonManifold;
  Counts Edges;
};
}

#endif
