// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ConstrainedSets_h
#define DirectionFields_ConstrainedSets_h

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The vertices of a component whose directions are given, in sets that edges between given
/// vertices connect. Along such an edge the field turns as the given directions say, and no
/// singularity crosses it. A set has one degree of freedom, hence it is one unknown; so is each
/// other vertex.
struct ConstrainedSets
{
  /// @param isGiven of each vertex of the mesh; empty for none
  ConstrainedSets(const TriangleMesh& mesh, const TriangleMesh::Component& component,
    const std::vector<char>& isGiven);

  /// The unknown of each vertex of the component; empty where each vertex is its own.
  std::vector<Index> Unknown;
  Index NumberOfUnknowns;
  /// The unknowns that are sets of given vertices, ascending.
  std::vector<Index> GivenUnknowns;
  /// Whether both ends of an edge of the component are given; empty for none.
  std::vector<char> FixedEdge;

  Index UnknownOf(Index vertex) const
  {
    return this->Unknown.empty() ? vertex : this->Unknown[vertex];
  }
  bool IsFixed(Index edge) const { return !this->FixedEdge.empty() && this->FixedEdge[edge] != 0; }
};
}

#endif
