// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MeshChain_h
#define DirectionFields_MeshChain_h

#include "Types.h"

#include <array>
#include <string>
#include <vector>

namespace DirectionFields
{
/// What a chain of edges of a mesh is, the first of these that holds.
enum class ChainKind : signed char
{
  /// Edges of one face.
  Boundary = 0,
  /// A sharp edge that is kept, a given curve, or an edge where more than two faces meet, within a
  /// region.
  Feature = 1,
  /// Edges between faces of different regions.
  Border = 2
};

/// Edges of a mesh that follow each other, from one place where such chains end, meet or turn to
/// the next one, or around.
struct MeshChain
{
  ChainKind Kind;
  /// The vertices in their order, at least two; of a closed chain the first one is the last one,
  /// too.
  std::vector<Index> Points;
  /// The regions beside it, the lower number first; None outside of the mesh, and without regions.
  std::array<Index, 2> Regions;
  /// The kind, the regions, and a number among the chains of these, such as
  /// `Border steel/copper 1`: another chain has another name. Numbers go by the places of the
  /// chains' middles, so that they are the same in a finer or coarser mesh of the surface, but
  /// where two middles are nearly as far along x, y and z.
  std::string Name;
};
}

#endif
