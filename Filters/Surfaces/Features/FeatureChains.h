// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FeatureChains_h
#define DirectionFields_FeatureChains_h

#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The edges that are features of the shape: all sharper than an angle, except noise. A chain is
/// one sharp edge after the other; it ends where three or more meet, where there are no more, and
/// on the boundary. Chains of noise are short and stand out little from the edges around them.
class FeatureChains
{
public:
  struct Settings
  {
    /// Angle between the normals of an edge's triangles above which it is sharp, radians.
    double Angle;
    /// Shorter chains may be noise, in parts of the square root of the component's area; 0 keeps
    /// all.
    double MinimumLength;
  };

  /// The mean angle of a chain over that of the other edges at its vertices, from which on even a
  /// short one is a feature; where it ends freely and is less than very sharp, as noise is, it
  /// needs the larger contrast.
  static constexpr double ClearContrast = 4.0;
  static constexpr double FreeContrast = 8.0;
  static constexpr double VerySharp = Pi / 3.0;

  /// Drops the chains that are shorter and have less contrast, unless they lead from boundary to
  /// boundary: first those that end where there are no more sharp edges, which lets others grow
  /// together, then those that lead from chain to chain. The remaining chains are checked again,
  /// for a few rounds. Takes time linear in the edges.
  /// @param dihedral angle of each edge, radians
  FeatureChains(
    const SurfaceGeometry& geometry, const std::vector<double>& dihedral, const Settings& settings);

  /// Whether an edge is a feature.
  bool IsFeature(Index edge) const { return this->Features[edge] != 0; }

private:
  struct Chain
  {
    std::vector<Index> Edges;
    Index From, To;
  };

  /// A chain that may be noise.
  struct Doubt
  {
    /// Chains shorter than this.
    double Length;
    bool FreeEndsOnly;
  };

  /// Whether chains end at a vertex.
  bool IsNode(Index vertex) const
  {
    return this->Valence[vertex] != 2 || this->Mesh.IsBoundary(vertex);
  }
  bool IsFreeEnd(Index vertex) const
  {
    return this->Valence[vertex] == 1 && !this->Mesh.IsBoundary(vertex);
  }
  /// The chain that goes on along a half-edge.
  Chain Follow(Index h) const;
  double LengthOf(const Chain& chain) const;
  /// Whether no other sharp edge is at one of its ends, which is not on the boundary.
  bool EndsFreely(const Chain& chain) const
  {
    return this->IsFreeEnd(chain.From) || this->IsFreeEnd(chain.To);
  }
  bool StandsOut(const Chain& chain) const;
  bool IsNoise(const Chain& chain, const Doubt& doubt) const;
  /// Appends the edges of chains that begin at a vertex, were not seen before, and are noise.
  void CollectNoise(Index vertex, const Doubt& doubt, std::vector<Index>& noise);
  void Drop(const std::vector<Index>& edges);
  void DropNoise(Index component);
  /// Returns whether anything was dropped.
  bool DropRound(Index component, const Doubt& doubt);

  const TriangleMesh& Mesh;
  const Metric& Lengths;
  const std::vector<double>& Dihedral;
  Settings Wanted;
  std::vector<char> Features;
  /// The number of features at each vertex.
  std::vector<Index> Valence;
  /// Whether the chain of an edge has been looked at in this round.
  std::vector<char> IsSeen;
};
}

#endif
