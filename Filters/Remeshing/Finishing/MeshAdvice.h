// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MeshAdvice_h
#define DirectionFields_MeshAdvice_h

#include "FaceMesh/Faces.h"
#include "Mesh/TriangleMesh.h"
#include "Types.h"

#include <string>
#include <vector>

namespace DirectionFields::Internal
{
/// The mesh that was asked for, and how far it is from the surface.
struct MeshWishes
{
  /// Quads are wanted; otherwise triangles are.
  bool IsOfQuads = true;
  /// Only quads are.
  bool IsPure = false;
  bool IsSmoothed = true;
  /// Irregular vertices are added where sizes need them.
  bool AddsPairs = true;
  /// Sizes grow from one edge to the next by a limited factor.
  bool HasGradation = false;
  /// How many faces are wanted; 0 where a length of edges is.
  Index NumberOfFaces = 0;
  /// The wanted length of edges, that at thin parts, and the diagonal of the box around the
  /// surface, in its unit.
  double EdgeLength = 0.0;
  double ShortestEdge = 0.0;
  double Extent = 0.0;
  /// Largest distances in the unit of the surface: of the mesh from the surface, of the surface
  /// from the mesh, and of their boundaries from each other.
  double ToSurface = 0.0;
  double ToMesh = 0.0;
  double OfBoundary = 0.0;
  /// The part of the vertices that are on lines or are given points, and whether these are more
  /// than sharp edges.
  double PartOnFeatures = 0.0;
  bool HasHard = false;
  /// Faces that look to the other side than the surface.
  Index Turned = 0;
  /// The part of the kept edges that the directions given cross; 0 without such directions.
  double PartCrossed = 0.0;
  /// The wanted length of edges at each vertex of the mesh, in the unit of its points; empty for
  /// the same everywhere.
  std::vector<double> Sizes;
};

/// Tells the user the shortcomings of a mesh, and their remedies: a sentence each for many
/// triangles, faces that are flat, folded or turned over, places far from the surface, another
/// number of faces than was asked for, and sizes that are not reached. None for a mesh that is as
/// it should be.
std::vector<std::string> MeshAdvice(
  const std::vector<Vector3>& points, const Faces& faces, const MeshWishes& wishes);

/// Tells the user where the mesh is connected in another way than the surface: a sentence each for
/// points where sheets only touched, and another V - E + F. One-sided surfaces and those with edges
/// of three triangles are connected as before.
/// @param touching   as CountTouching
/// @param before     V - E + F of the surface, its sheets taken apart at those points
/// @param after      V - E + F of the mesh
/// @param edgeLength the wanted length of edges
std::vector<std::string> TopologyAdvice(Index touching, int before, int after, double edgeLength);

/// The points of a surface where sheets meet that no seam joins: they are apart in its mesh.
/// @param original of each point the one that it is a copy of, or itself
Index CountTouching(const TriangleMesh& mesh, const std::vector<Index>& original);

/// The components of a surface, in the sense of triangles with common corners, of which no triangle
/// is used.
/// @param isUsed not 0 for each triangle that is
Index CountUnused(const std::vector<Triangle>& triangles, const std::vector<char>& isUsed);
}

#endif
