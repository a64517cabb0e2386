// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SurfaceRefinement_h
#define DirectionFields_SurfaceRefinement_h

#include "PrescribedSingularities/SingularityEditor.h"
#include "Surface.h"

#include <array>
#include <vector>

namespace DirectionFields
{
/// A surface with some of its triangles split in four at the middles of their edges, and those next
/// to them in two, three or four, so that no corner lies within an edge.
struct SurfaceRefinement
{
  /// @param isSplit not 0 for triangles that are split in four
  SurfaceRefinement(const Surface& surface, const std::vector<char>& isSplit);

  /// The points of the surface, then the middles of edges.
  Surface Refined;
  /// The ends of the edge that each new point is the middle of.
  std::vector<std::array<Index, 2>> Ends;
  /// The triangle of the surface that each triangle is a part of.
  std::vector<Index> Parent;
};

/// The directions at the middles of edges: on an edge the interpolated field is the mean of the
/// vectors at its ends.
/// @param refinement of the surface of the editor's base
/// @return           n directions for each new point, one after the other; zero where the base has
///                   none
std::vector<Vector3> DirectionsAtMiddles(
  const GivenField& base, const SurfaceRefinement& refinement);

/// The triangles of the surface that are wrong in an edited field, with those that share a point
/// with them.
std::vector<char> TrianglesToSplit(const GivenField& base, const EditedField& edited);
}

#endif
