// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FeatureLines_h
#define DirectionFields_FeatureLines_h

#include "Charts/FieldMatching.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Vertices where features end, meet or turn so that no single frame fits all of them, as at the
/// corners of a cube: the interior vertices at which features are not exactly two in opposite
/// directions, to the nearest multiple of 2 pi / n. Boundary vertices are never such corners: their
/// angles are not rescaled.
/// @param isFeature not 0 for edges that are features; boundary edges always count
std::vector<char> FramelessVertices(
  const IntrinsicGeometry& geometry, int degree, const std::vector<char>& isFeature);

/// The same for the vertices of one component, the features having changed.
/// @param isFeature also not 0 for the edges of the boundary
void UpdateFrameless(const IntrinsicGeometry& geometry, int degree,
  const TriangleMesh::Component& component, const std::vector<char>& isFeature,
  std::vector<char>& isFrameless);

/// Which isoline of a map each feature is to be.
struct FeatureLines
{
  /// No two neighbours may be frameless.
  /// @param isFeature   not 0 for edges that are features; boundary edges always count
  /// @param isFrameless of each vertex
  /// @param isCorner    not 0 for vertices of the boundary where lines end; empty for none
  /// @param window      length over which the direction of a curve is averaged before it is rounded
  ///                    to one of the field, in the input's unit; of each component
  FeatureLines(const IntrinsicGeometry& geometry, const FieldMatching& matching,
    const std::vector<char>& isFeature, const std::vector<char>& isFrameless,
    const std::vector<double>& window, const std::vector<char>& isCorner = {});

  /// A feature edge of a chain, traversed along its half-edge or against it.
  struct Step
  {
    Index HalfEdge;
    bool IsReversed;
  };
  struct Chain
  {
    std::vector<Step> Steps;
    bool IsClosed = false;
  };

  /// Whether an edge is a feature.
  std::vector<char> IsFeature;
  /// The number of the chain that an edge belongs to, from 1 on; 0 elsewhere.
  std::vector<Index> Line;
  /// k of each feature edge: it runs along zeta^k in the chart of Base, to the nearest axis. Its
  /// sign refers to the direction of the edge.
  std::vector<int> Axis;
  /// That end of a feature edge whose chart the axis is of: its tail unless that is frameless.
  std::vector<Index> Base;
  /// Not 0 for vertices of features that have to be grid points regardless of the features there;
  /// empty for none.
  std::vector<char> IsEnd;
  /// They end where features end, meet, or have no frame.
  std::vector<Chain> Chains;

  static Index Start(const TriangleMesh& mesh, const Step& step)
  {
    return step.IsReversed ? mesh.Head(step.HalfEdge) : mesh.Tail(step.HalfEdge);
  }
  static Index End(const TriangleMesh& mesh, const Step& step)
  {
    return step.IsReversed ? mesh.Tail(step.HalfEdge) : mesh.Head(step.HalfEdge);
  }

private:
  void FindChains(const TriangleMesh& mesh, const std::vector<char>& isFrameless,
    const std::vector<char>& isCorner);
  void FindAxes(const IntrinsicGeometry& geometry, const FieldMatching& matching,
    const std::vector<char>& isFrameless, const std::vector<double>& window);
};
}

#endif
