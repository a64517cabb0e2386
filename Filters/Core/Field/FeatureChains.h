// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FeatureChains_h
#define DirectionFields_FeatureChains_h

#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Which edges are features of the shape: those sharper than an angle, without what is noise among them.
/// A chain is one sharp edge after the other; it ends where three or more meet, where there are no more,
/// and on the boundary. Noise makes edges sharp here and there, and by little. A feature makes a long
/// chain, a very sharp one, a loop, or one that leads from feature to feature or from boundary to boundary.
class FeatureChains
{
public:
  struct Settings
  {
    /// Angle between the normals of an edge's triangles above which it is sharp, radians.
    double Angle;
    /// What is shorter may be noise, in parts of the square root of the component's area; 0 keeps all.
    double MinimumLength;
  };

  /// Chains that are too short, and not very sharp, are dropped where they end freely, which lets others
  /// end freely or grow together, and so on. Then sharp edges that are connected are dropped where all of
  /// them together are too short, and not very sharp, unless they are a rim (FewestRimEdges)
  /// or touch the boundary twice. Takes time linear in the edges.
  /// @param dihedral angle of each edge, radians
  FeatureChains(
    const SurfaceGeometry& geometry, const std::vector<double>& dihedral, const Settings& settings);

  /// Whether an edge is a feature.
  bool IsFeature(Index edge) const { return this->Features[edge] != 0; }

  /// A single loop of so many edges or more counts as the rim of something: the loops that noise makes
  /// around a vertex are shorter.
  static constexpr Index FewestRimEdges = 8;

private:
  /// Of several edges.
  struct Extent
  {
    double Length = 0.0;
    /// The integral of the angle over the length.
    double Bend = 0.0;
  };

  void Add(Index edge, Extent& extent) const;
  bool CountsAsFeature(const Extent& extent, Index component) const;
  bool IsFreeEnd(Index vertex) const
  {
    return this->Valence[vertex] == 1 && !this->Mesh.IsBoundary(vertex);
  }
  /// Another half-edge of a feature that leaves the vertex than the one along an edge; None if there is
  /// none.
  Index NextFeature(Index vertex, Index edge) const;
  /// The edges from a free end to where the chain ends.
  std::vector<Index> ChainFrom(Index vertex) const;
  void Drop(const std::vector<Index>& edges);
  void DropSpurs(Index component);
  void DropSmallGraphs(Index component, std::vector<char>& isSeen);
  /// The features that are connected with a vertex; sets isSeen for their vertices.
  std::vector<Index> GraphAt(Index vertex, std::vector<char>& isSeen, int& onBoundary) const;

  const TriangleMesh& Mesh;
  const Metric& Lengths;
  const std::vector<double>& Dihedral;
  Settings Wanted;
  std::vector<char> Features;
  /// The number of features at each vertex.
  std::vector<Index> Valence;
};
}

#endif
