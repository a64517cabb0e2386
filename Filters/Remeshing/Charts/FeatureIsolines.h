// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FeatureIsolines_h
#define DirectionFields_FeatureIsolines_h

#include "Charts/CutMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Edges of features one after the other, from a vertex that is a lattice point to the next one, or all
/// around where there is none.
struct FeatureIsoline
{
  /// Isoline of a charted mesh, and whether the stretch runs from its head to its tail.
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

/// Every isoline edge belongs to one stretch. Takes time linear in the mesh.
/// @param isPoint not 0 for vertices that are lattice points
std::vector<FeatureIsoline> FindFeatureIsolines(
  const CutMesh& mesh, const std::vector<char>& isPoint);
}

#endif
