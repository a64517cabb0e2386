// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TriangleMesh_h
#define DirectionFields_TriangleMesh_h

#include "Support/LargeArray.h"
#include "Surface.h"
#include "Types.h"

#include <functional>
#include <vector>

namespace DirectionFields
{
namespace Internal
{
class MeshBuilder;
class MeshOrder;
}

/// Half-edge structure of an oriented manifold triangle mesh, with or without boundary.
///
/// Half-edge 3 t + c runs from corner c of triangle t to corner (c + 1) % 3. Triangles, edges and
/// vertices are numbered component by component, so that everything of a component is contiguous,
/// and the components by their first triangles in the input. Within a component vertices follow a
/// Morton curve (Z-order) through their points, triangles their lowest vertices and edges their
/// lowest half-edges: neighbours on the surface are mostly close in memory, in whatever order they
/// came in.
///
/// A vertex is a fan of triangles at a used point. A surface that is no manifold is split into
/// sheets: an edge of more than two triangles becomes boundary for all of them, and where several
/// fans meet in a point each is a vertex of its own.
///
/// A component that cannot be oriented (Möbius strip, Klein bottle) is represented by its
/// orientable double cover: each of its triangles, vertices and edges is there twice, once for each
/// side of the surface, and Mirror leads from the one to the other. Everything on it that knows
/// intrinsic geometry only is mapped to its complex conjugate by that.
class TriangleMesh
{
public:
  /// Ranges of numbers, the end excluded.
  struct Component
  {
    Index FirstTriangle, EndTriangle;
    Index FirstEdge, EndEdge;
    Index FirstVertex, EndVertex;
    bool Closed;
    /// It is the double cover of a component that cannot be oriented; so are all ranges and counts.
    bool IsCover;

    Index Vertices() const { return this->EndVertex - this->FirstVertex; }
    Index Edges() const { return this->EndEdge - this->FirstEdge; }
    Index Triangles() const { return this->EndTriangle - this->FirstTriangle; }
  };

  /// Winds every component like the majority of its triangles. Throws MeshError for invalid ids and
  /// non-finite coordinates.
  explicit TriangleMesh(const Surface& surface);

  static Index Next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index Previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

  Index GetNumberOfVertices() const { return static_cast<Index>(this->VertexPoint.size()); }
  Index GetNumberOfEdges() const { return static_cast<Index>(this->EdgeHalfEdge.size()); }
  Index GetNumberOfTriangles() const { return static_cast<Index>(this->Corners.size() / 3); }
  Index GetNumberOfHalfEdges() const { return static_cast<Index>(this->Corners.size()); }

  Index Tail(Index h) const { return this->Corners[h]; }
  Index Head(Index h) const { return this->Corners[Next(h)]; }
  /// None on the boundary.
  Index Twin(Index h) const { return this->Twins[h]; }
  Index Edge(Index h) const { return this->Edges[h]; }
  /// The edge was split because more than two triangles share it.
  bool IsNonManifold(Index h) const
  {
    return !this->NonManifold.empty() && this->NonManifold[h] != 0;
  }
  /// Several edges may join the same vertices: along slits, between sheets that share the corners
  /// of a triangle, and after flips.
  bool MayRepeatNeighbours() const { return !this->NonManifold.empty() || this->Flipped; }
  /// The half-edge that gives an edge its direction.
  Index HalfEdge(Index edge) const { return this->EdgeHalfEdge[edge]; }
  bool GivesDirection(Index h) const { return this->EdgeHalfEdge[this->Edges[h]] == h; }
  /// An outgoing half-edge of a vertex; on the boundary the first one counter-clockwise.
  Index Outgoing(Index vertex) const { return this->VertexHalfEdge[vertex]; }
  bool IsBoundary(Index vertex) const { return this->Twins[this->VertexHalfEdge[vertex]] == None; }
  /// The next outgoing half-edge counter-clockwise; None after the last one of a boundary vertex.
  Index NextOutgoing(Index h) const { return this->Twins[Previous(h)]; }

  /// The outgoing half-edges of a vertex counter-clockwise, from Outgoing on.
  void GetFan(Index vertex, std::vector<Index>& fan) const
  {
    fan.clear();
    const Index first = this->VertexHalfEdge[vertex];
    Index h = first;
    do
    {
      fan.push_back(h);
      h = this->NextOutgoing(h);
    } while (h != None && h != first);
  }

  /// The same edge on the other side of a cover, where it runs the other way; None elsewhere.
  Index Mirror(Index h) const
  {
    const Index mirror = this->Mirrors.empty() ? None : this->Mirrors[h / 3];
    return mirror == None ? None : 3 * mirror + 2 - h % 3;
  }
  /// The same point on the other side of a cover; None elsewhere.
  Index MirrorVertex(Index vertex) const
  {
    const Index mirror = this->Mirror(this->VertexHalfEdge[vertex]);
    return mirror == None ? None : this->Head(mirror);
  }
  /// The side that results are taken from: everything but the other side of covers. It is connected
  /// by a spanning tree of triangles, so that as few edges as may be lead away from it.
  bool IsFront(Index triangle) const { return this->IsBack.empty() || !this->IsBack[triangle]; }
  /// The vertex that stands for a point: in a cover the one with more triangles of the front.
  bool IsFrontVertex(Index vertex) const
  {
    return this->IsBackVertex.empty() || !this->IsBackVertex[vertex];
  }

  const std::vector<Component>& GetComponents() const { return this->Components; }
  /// Calls body(c) once for each component. Small components are shared out among the threads;
  /// large ones come one after the other, for their own loops to be shared out.
  void ForEachComponent(const std::function<void(Index)>& body) const;
  /// Input point of a vertex; vertices of split points share it.
  Index Point(Index vertex) const { return this->VertexPoint[vertex]; }
  /// The position of each vertex.
  /// @param points of the input
  std::vector<Vector3> Positions(const std::vector<Vector3>& points) const;
  /// Input triangle of a triangle.
  Index InputTriangle(Index triangle) const { return this->TriangleInput[triangle]; }

  /// Puts the other diagonal of its two triangles, which must be two, in the place of an interior
  /// edge. After that the vertices may not tell triangles and edges apart: an edge may join a
  /// vertex to itself, two edges the same vertices. InputTriangle loses its meaning for both
  /// triangles.
  ///
  /// The edge keeps its number, and its half-edges h and g theirs: h then runs from the corner
  /// opposite of g to that opposite of h. The data of the other half-edges moves with them: Next(h)
  /// to Previous(g), Previous(g) to Next(g), Next(g) to Previous(h), Previous(h) to Next(h).
  void FlipEdge(Index edge);

  /// DegenerateTriangles is left to the metric.
  const Repairs& GetRepairs() const { return this->Repaired; }

private:
  friend class Internal::MeshBuilder;
  friend class Internal::MeshOrder;

  LargeArray<Index> Corners;
  LargeArray<Index> Twins;
  LargeArray<Index> Edges;
  LargeArray<Index> EdgeHalfEdge;
  /// Whether the edge of each half-edge was split; empty where none has more than two triangles.
  std::vector<char> NonManifold;
  bool Flipped = false;
  LargeArray<Index> VertexHalfEdge;
  LargeArray<Index> VertexPoint;
  LargeArray<Index> TriangleInput;
  /// The copy of each triangle on the other side of a cover, or None, and whether a triangle and a
  /// vertex are on the back. All are empty without covers.
  LargeArray<Index> Mirrors;
  std::vector<char> IsBack;
  std::vector<char> IsBackVertex;
  std::vector<Component> Components;
  Repairs Repaired;
};
}

#endif
