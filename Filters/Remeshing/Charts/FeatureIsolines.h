// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FeatureIsolines_h
#define DirectionFields_FeatureIsolines_h

#include "Charts/CutMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Consecutive edges of a feature, from one grid point to the next, or the whole loop if there is
/// no grid point on it.
struct FeatureIsoline
{
  /// An isoline of a cut mesh, and whether it is traversed from its head to its tail.
  struct Step
  {
    std::size_t Isoline;
    bool IsReversed;
  };
  std::vector<Step> Steps;
};

/// An end of an isoline edge.
inline Index EndOf(const CutMesh& mesh, const CutMesh::IsolineEdge& edge, bool atHead)
{
  return mesh.Triangles[edge.Triangle].Vertex[(edge.Corner + (atHead ? 1 : 0)) % 3];
}

/// Every isoline edge belongs to one feature isoline. Takes time linear in the mesh.
/// @param isPoint not 0 for vertices that are grid points
std::vector<FeatureIsoline> FindFeatureIsolines(
  const CutMesh& mesh, const std::vector<char>& isPoint);
}

#endif
