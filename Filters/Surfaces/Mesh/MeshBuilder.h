// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MeshBuilder_h
#define DirectionFields_MeshBuilder_h

#include "Mesh/TriangleMesh.h"
#include "Support/LargeArray.h"
#include "Surface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Makes a mesh of a surface, whatever is wrong with that: sorts the triangles, matches their
/// edges, winds and covers them, makes every fan a vertex, and numbers everything by component.
class MeshBuilder
{
public:
  /// @param mesh empty, filled by Build
  explicit MeshBuilder(TriangleMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// Throws MeshError for invalid ids and non-finite coordinates.
  void Build(const Surface& surface);

private:
  /// Matches the edges and finds the components.
  void Collect(const Surface& surface);
  /// Finds the components, turns the minority of their triangles and covers components that cannot
  /// be oriented.
  void Orient();
  /// Finds the members of a component from one of its triangles, and which of them have to be
  /// turned to be wound like that. Returns whether that is possible for all of them at once.
  bool Spread(
    Index seed, Index component, std::vector<Index>& members, std::vector<char>& isTurned);
  /// Turns the others where most members of a component would be turned. Returns how many are.
  Index TurnMinority(const std::vector<Index>& members, std::vector<char>& isTurned) const;
  /// Turns triangles: (a, b, c) becomes (a, c, b), its half-edges 0 and 2 change places.
  void Turn(const std::vector<char>& turned);
  /// Appends the other side of the triangles that are covered.
  void Cover(const std::vector<char>& isCovered);
  /// Makes every fan of triangles a vertex.
  void LinkVertices();
  /// Numbers the fans as vertices where a point has several of them.
  void SplitPoints();
  /// Numbers the edges by their first half-edges.
  void NumberEdges();
  /// Of the two vertices of a cover that have the same point, the one that has fewer triangles of
  /// the front is on the back.
  void ChooseFrontVertices();

  TriangleMesh& Mesh;
  /// The component of each triangle.
  LargeArray<Index> TriangleComponent;
};
}

#endif
