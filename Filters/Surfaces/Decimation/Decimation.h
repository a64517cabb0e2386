// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Decimation_h
#define DirectionFields_Decimation_h

#include "Mesh/TriangleMesh.h"
#include "Progress.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Fewer triangles for the same surface: edges are collapsed (H. Hoppe et al.: Mesh Optimization,
/// 1993) to one of their ends, so that all vertices that are left stay where they are. The topology
/// stays the same; features and the boundary remain paths of edges, vertices where features end,
/// meet or turn remain. So does every vertex that shares its point with another one, and no two
/// such become neighbours: a mesh of the triangles that are left is connected as this one is.
/// Covers are left alone. Takes time linear in the triangles. Of VTK's, vtkQuadricDecimation moves
/// vertices, and vtkDecimatePro takes neither given features nor a length for each vertex.
class Decimation
{
public:
  struct Limits
  {
    /// The longest edge that may come about at each vertex, in the input's unit.
    std::vector<double> EdgeLength;
    /// The same where edges are longer already and others need not be shorter; empty for none.
    std::vector<double> LongestEdge = {};
    /// How far the surface may move at most, in lengths of EdgeLength.
    double Deviation = 0.1;
    /// Whether all vertices of features and of the boundary stay.
    bool KeepsLines = false;
    /// Not 0 for other vertices that stay; empty for none.
    std::vector<char> IsKept = {};
  };

  /// @param positions of the vertices
  /// @param isFeature not 0 for edges to be kept; the boundary counts anyway
  Decimation(const TriangleMesh& mesh, const std::vector<Vector3>& positions,
    const std::vector<char>& isFeature, const Limits& limits);

  /// Throws Stopped.
  void Run(const Progress& progress = {});

  /// Whether a triangle of the mesh is still there, and its corners then.
  bool IsTriangle(Index t) const { return this->Corners[3 * t] != None; }
  Index Corner(Index h) const { return this->Corners[h]; }
  bool IsVertex(Index v) const { return this->Outgoing[v] != None; }

private:
  /// Vertices of a block that is decimated by itself. The blocks of every other sweep lie half a
  /// block further.
  static constexpr Index BlockSize = 1 << 14;

  struct Star;
  enum class Kind : char
  {
    Free,
    /// Has two edges that are features.
    OnFeature,
    Fixed
  };

  static Index Next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index Previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  void FindKinds(const TriangleMesh& mesh);
  void FindApart(const TriangleMesh& mesh);
  /// Collapses edges between vertices of a range, to lengths up to a part of the limit; returns how
  /// many.
  Index Sweep(Index begin, Index end, double part);
  /// The same for those whose neighbours are in other blocks.
  Index SweepApart(double part);
  /// Whether it collapsed an edge of v, if all vertices around v are of a range.
  bool TryCollapse(Index v, Index begin, Index end, double part, Star& star);
  bool FindStar(Index v, Index begin, Index end, Star& star) const;
  /// How good the worst triangle is after the collapse of edge i of a star; negative where that may
  /// not be.
  double Quality(Index v, const Star& star, std::size_t i, double part) const;
  bool IsOnFeature(const Star& star, std::size_t k) const;
  /// The half-edge between the vertex of a star and one of its ring.
  static Index EdgeTo(const Star& star, std::size_t k);
  /// How far the feature at v may have moved after the collapse of edge i: where the edge is that
  /// takes the place of its two, and all that these took the place of.
  double FeatureMovedTo(Index v, const Star& star, std::size_t i) const;
  /// How far a vertex on a feature is from the edge that is to take the place of its two.
  double FeatureStep(Index v, const Star& star, std::size_t i) const;
  bool KeepsTopology(Index v, const Star& star, std::size_t i) const;
  /// Marks the vertices of a star's ring that are neighbours of w. Returns how many times it met
  /// one.
  std::size_t MarkNeighbours(Index w, const Star& star, char* isNeighbour) const;
  void Collapse(Index v, const Star& star, std::size_t i);

  double Longest(Index v) const
  {
    return this->Limit.LongestEdge.empty() ? this->Limit.EdgeLength[v] : this->Limit.LongestEdge[v];
  }

  const std::vector<Vector3>& Positions;
  const Limits& Limit;
  LargeArray<Index> Corners;
  LargeArray<Index> Twins;
  LargeArray<Index> Outgoing;
  /// Of each half-edge whether it is part of a feature or the boundary.
  std::vector<char> IsFeature;
  std::vector<Kind> Kinds;
  /// Where edges may stay long, the vertices that may vanish and have a neighbour of a number so
  /// far from theirs that no block has both: the hub of a fan, or the other end of a needle.
  std::vector<Index> Apart;
  /// Something around the vertex has changed since a collapse was last tried.
  std::vector<char> IsNew;
  /// How far the surface may have moved at each triangle, and the feature at each half-edge.
  std::vector<float> Moved;
  std::vector<float> FeatureMoved;
  double MeanLength = 0.0;
};
}

#endif
