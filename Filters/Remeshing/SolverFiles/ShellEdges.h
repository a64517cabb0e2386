// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ShellEdges_h
#define DirectionFields_ShellEdges_h

#include "SolverFiles/ShellMesh.h"

#include <cstdint>

namespace DirectionFields::Internal
{
/// The edges of a mesh, ordered by their ends.
struct ShellEdges
{
  /// @param mesh with valid numbers
  explicit ShellEdges(const ShellMesh& mesh);

  /// The edges from a point to others of larger numbers: from the first one to before the second.
  std::array<std::int64_t, 2> From(Index point) const;

  /// The lower number first.
  std::vector<std::array<Index, 2>> Ends;
  /// Not 0 for edges of one face.
  std::vector<char> IsBoundary;
  /// From each corner of a face to the next one.
  std::vector<std::array<std::int64_t, 4>> OfFace;
};
}

#endif
