// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_VertexRemoval_h
#define DirectionFields_VertexRemoval_h

#include "Extraction/ExtractionMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Removes the vertices of a cell mesh that are not kept, one after the other, each by another triangulation
/// of the polygon around it. That cannot change the topology, whatever the map is like; where the map is
/// good, what is left is the triangulation of the lattice points, and where it folds, vertices stay.
class VertexRemoval
{
public:
  explicit VertexRemoval(ExtractionMesh& mesh)
    : Mesh(mesh)
  {
  }

  enum class Mode
  {
    /// All new triangles lie the right way round in the lattice's plane.
    Strict,
    /// They do so in space, seen along the mean normal of those that go, and there are not more than before
    /// that lie the wrong way round in the plane.
    Relaxed,
    /// As Strict, but triangles may have no area, as those between vertices at the same place do. For vertices
    /// with such neighbours only, so that these can become one.
    Joining
  };

  /// Removes what can be, in the order of the numbers, until nothing changes. Returns how many are left that
  /// are not kept.
  Index RemoveAll(Mode mode);
  /// Removes one vertex. Returns whether it could be.
  bool Remove(Index v, Mode mode);

  static constexpr int LargestRing = 40;

private:
  /// The quality of a triangle of the ring, or -1 where it is not allowed.
  double QualityOf(int i, int j, int k, Mode mode) const;
  /// Triangulates the polygon of these places in the ring, the edge from the last to the first given.
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
