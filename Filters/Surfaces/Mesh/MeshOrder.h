// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MeshOrder_h
#define DirectionFields_MeshOrder_h

#include "Mesh/TriangleMesh.h"
#include "Support/LargeArray.h"
#include "Support/RadixSort.h"

#include <cstdint>
#include <vector>

namespace DirectionFields::Internal
{
/// The triangles around a vertex.
struct Fan
{
  /// The first outgoing half-edge: on the boundary the first one counter-clockwise, else the one of
  /// the least number.
  Index First;
  /// The number of triangles.
  Index Corners;
};

/// The fan that a half-edge leaves the vertex of. Only needs the twins.
Fan FindFan(const TriangleMesh& mesh, Index start);

/// Numbers triangles and vertices component by component, as the description of TriangleMesh says.
/// Works on a mesh that is being built, whose edges have no numbers yet.
class MeshOrder
{
public:
  /// @param components the component of each triangle, renumbered by Sort
  MeshOrder(TriangleMesh& mesh, LargeArray<Index>& components)
    : Mesh(mesh)
    , TriangleComponent(components)
  {
  }

  /// @param points of the surface
  void Sort(const std::vector<Vector3>& points);

private:
  /// Orders the components by their first triangles in the input.
  void OrderComponents();
  /// Sorts the vertices of each component along a Morton curve of its own, so that no other
  /// component has a say in it.
  void SortVertices(const std::vector<Vector3>& points);
  /// Sorts the triangles by their lowest vertices, and so by component.
  void SortTriangles();
  /// Sets the components' ranges of triangles.
  void CountTriangles();
  /// Moves all that belongs to triangles and half-edges.
  /// @param order  the triangles in their new order
  /// @param number the new number of each
  void MoveTriangles(
    const LargeArray<Keyed<std::uint32_t>>& order, const LargeArray<Index>& number);

  TriangleMesh& Mesh;
  LargeArray<Index>& TriangleComponent;
};
}

#endif
