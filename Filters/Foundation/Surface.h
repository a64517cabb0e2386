// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Surface_h
#define DirectionFields_Surface_h

#include "Types.h"

#include <vector>

namespace DirectionFields
{
/// A triangle mesh as it comes in: anything may be wrong with it.
struct Surface
{
  std::vector<Vector3> Points;
  /// Corners counter-clockwise as seen from outside.
  std::vector<Triangle> Triangles;
  /// Not 0 for triangles that belong to another piece of a surface in pieces: the field goes on
  /// over them, but they do not count. Empty where there are none, else one a triangle.
  std::vector<char> Ghost = {};
};

/// The faults that were mended in the input; zero everywhere for a clean mesh.
struct Repairs
{
  /// Triangles with a corner used twice; ignored, their index is 0.
  Index CollapsedTriangles = 0;
  /// Triangles with the same three corners as an earlier one; ignored, their index is 0. Two of
  /// opposite windings are no duplicates where each has a neighbour of its own, as in a pillow,
  /// whose two sheets share the corners of a triangle at the border.
  Index DuplicateTriangles = 0;
  /// Triangles wound against the majority of their component; turned for the computation.
  Index ReversedTriangles = 0;
  /// Triangles (nearly) without area; their shortest edge was lengthened by about a millionth of
  /// their longest edge (mollification, Sharp and Crane 2020).
  Index DegenerateTriangles = 0;
  /// Edges of more than two triangles; the surface is split into sheets there. An edge that two
  /// sheets share because of triangles with the same three corners is none.
  Index NonManifoldEdges = 0;
  /// Components that cannot be wound consistently (Möbius strip, Klein bottle); the field is
  /// computed on both of their sides at once.
  Index NonOrientableComponents = 0;
  /// Points where several fans of triangles meet; each fan gets a point of its own.
  Index NonManifoldPoints = 0;
  /// Points that share the place of another one and became one with it (Options::MergePoints).
  Index MergedPoints = 0;
};
}

#endif
