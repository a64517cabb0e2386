// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_VertexRemoval_h
#define DirectionFields_VertexRemoval_h

#include "Extraction/ExtractionMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Removes the vertices of an extraction mesh that need not stay, one after the other, each by
/// another triangulation of the polygon around it. That cannot change the topology for any map.
/// Where the map is good the result is the triangulation of the grid points; where it folds,
/// vertices remain.
class VertexRemoval
{
public:
  explicit VertexRemoval(ExtractionMesh& mesh)
    : Mesh(mesh)
  {
  }

  enum class Mode
  {
    /// All new triangles are positive in the plane of the grid.
    Strict,
    /// The new triangles are positive in space, seen along the mean normal of the removed ones, and
    /// no more of them than before are flipped in the plane.
    Relaxed,
    /// As Strict, but triangles may have no area, as between vertices at the same place. Only for
    /// vertices with such neighbours, so that these can be merged.
    Joining
  };

  /// Removes all possible vertices, in the order of their numbers, until nothing changes. Returns
  /// the number of vertices that should be removed but remain.
  Index RemoveAll(Mode mode);
  /// Removes one vertex. Returns whether it could be.
  bool Remove(Index v, Mode mode);

  static constexpr int LargestRing = 40;

private:
  /// The quality of a triangle of the ring, or -1 where it is not allowed.
  double QualityOf(int i, int j, int k, Mode mode) const;
  /// Triangulates the polygon of these places in the ring; the edge from the last to the first is
  /// given.
  bool Triangulate(const std::vector<int>& polygon, Mode mode, std::vector<Triangle>& triangles);
  bool FindFeature(std::array<Index, 2>& feature) const;
  void FindJoined();
  bool IsSimple();
  bool HasCoincidence() const;
  bool KeepsOrientations(const std::vector<Triangle>& triangles) const;

  ExtractionMesh& Mesh;
  ExtractionMesh::Layout Star;
  Vector3 Normal = Vector3::Zero();
  /// Whether two places of the ring are joined outside of the star.
  std::vector<char> Joined;
  std::vector<Index> Stamp;
  std::vector<Index> Scratch;
  std::vector<double> Best;
  std::vector<int> Choice;
};
}

#endif
