// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SurfacePatches_h
#define DirectionFields_SurfacePatches_h

#include "FaceMesh/MovableFaces.h"
#include "Preparation/PreparedSurface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The parts into which lines divide a surface, each with its closest points. Beside an edge the
/// closest triangle may be one around the corner, on which a face does not lie.
class SurfacePatches
{
public:
  /// @param edgeLength wanted; lines are on edges of triangles, up to a small part of it
  SurfacePatches(const PreparedSurface& surface, const FeatureLines& features, double edgeLength);

  const std::vector<SurfacePatch>& GetAll() const { return this->All; }
  /// The patch of each face: that of most faces which the edges of lines enclose with it. Where a
  /// patch had no faces, since an edge of a line is missing around it, it has those that lie on it.
  /// @param surface all triangles that are used
  std::vector<Index> OfFaces(const FaceMesh& mesh, const ClosestPoints& surface) const;
  /// The patch of each vertex; None for those on lines, and where faces of others are.
  std::vector<Index> OfVertices(const FaceMesh& mesh, const ClosestPoints& surface) const;
  /// The faces that are turned over: they look to the other side than their patch below them.
  /// Ascending.
  std::vector<Index> FindTurned(const FaceMesh& mesh, const ClosestPoints& surface) const;

private:
  /// Where a surface is rough, some triangle near a face looks to any side. In its unit.
  double Reach;
  /// The patch of each triangle that is used.
  std::vector<Index> Patch;
  std::vector<SurfacePatch> All;
};

/// The number of faces that are turned over. The surface is only divided if some face looks to the
/// other side than the triangle that is closest to it.
/// @param patches of the surface; null if there are none yet
Index CountTurned(const FaceMesh& mesh, const PreparedSurface& prepared,
  const ClosestPoints& surface, const FeatureLines& features, double edgeLength,
  const SurfacePatches* patches);
}

#endif
