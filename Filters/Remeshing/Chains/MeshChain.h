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
/// What a chain of edges of a mesh is: of the first three and Curve the first one in the order
/// Boundary, Border, Curve, Feature that holds.
enum class ChainKind : signed char
{
  /// Edges of one face.
  Boundary = 0,
  /// A sharp edge that is kept, or an edge where more than two faces meet, within a region.
  Feature = 1,
  /// Edges between faces of different regions.
  Border = 2,
  /// Edges along a given curve, within a region.
  Curve = 3,
  /// No edge, but a given point.
  Point = 4
};

/// Edges of a mesh that follow each other, from one place where such chains end, meet or turn to
/// the next one, or around.
struct MeshChain
{
  ChainKind Kind;
  /// The vertices in their order, at least two, but of a point one; of a closed chain the first one
  /// is the last one, too. The second region is on the left, and so are the faces of a boundary, if
  /// faces are wound counter-clockwise.
  std::vector<Index> Points;
  /// The regions beside it, the lower number first; None outside of the mesh, and without regions.
  std::array<Index, 2> Regions;
  /// The kind, of a curve its number, the regions, and a number among the chains of these, such as
  /// `Border steel/copper 1`: another chain has another name. `Point 3` is the given point 3.
  /// Numbers go by the places of the chains' middles, so that they are the same in a finer or
  /// coarser mesh of the surface, but where two middles are nearly as far along x, y and z.
  std::string Name;
  /// The number of the curve that it is on, of whatever kind it is, or of the point; None for none.
  Index Source = None;
};
}

#endif
