// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MergePoints_h
#define DirectionFields_MergePoints_h

#include "Mesh/TriangleMesh.h"
#include "Surface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// For each point the first one that a triangle uses and that has exactly the same coordinates:
/// itself where there is none before it, and where no triangle uses it. 0 and -0 are the same, NaN
/// is not the same as anything. It takes linear time, except where hashing has very bad luck.
std::vector<Index> FirstAtSamePlace(const Surface& surface);

/// The triangles with the first of their points at the same place; the points stay, so that their
/// ids do.
Surface Merged(const Surface& surface, const std::vector<Index>& first);

/// For each point the first of those that it becomes one with across seams; empty where there are
/// no seams. At a seam exactly two edges of the boundary have their ends at the same places, in
/// whatever direction: the two sides of a cut, two facets of a soup, two patches. The ends of the
/// two become one, so that surfaces that only touch stay apart: bodies that meet in a point or
/// along an edge, sheets that meet three at a time. So do triangles of the same three places (the
/// rim of a sheet that is there twice), and the sides of one triangle. Corners at the same place of
/// a triangle that is connected with none become one, too, which makes it collapse, and so do the
/// ends of an edge of the boundary, as in the middle of a disk that is made of quads. Takes time
/// linear in the boundary, and in the points where there are seams.
std::vector<Index> FirstAcrossSeams(const TriangleMesh& mesh, const std::vector<Vector3>& points);

/// A mesh whose points at the same places have become one.
struct MergedMesh
{
  /// The mesh of the surface, and its mesh with the first of all points at the same place, or with
  /// the first across seams. Throw MeshError as TriangleMesh does.
  static MergedMesh OfPoints(const Surface& surface);
  static MergedMesh OfPlaces(const Surface& surface);
  static MergedMesh AcrossSeams(const Surface& surface);

  /// For each point the one that stands for it in the mesh; empty where each stands for itself.
  std::vector<Index> FirstPoint;
  TriangleMesh Mesh;
};

/// Points on the boundary of a mesh, and how many of them lie exactly on another of them.
struct BoundaryPoints
{
  BoundaryPoints(const TriangleMesh& mesh, const std::vector<Vector3>& points);

  /// At least half of them coincide: the surface falls into pieces that only look connected.
  bool LookLikeSoup() const
  {
    return this->Coincident > 0 && this->Coincident >= this->Count - this->Coincident;
  }

  Index Count = 0;
  Index Coincident = 0;
};
}

#endif
