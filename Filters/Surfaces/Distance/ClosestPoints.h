// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ClosestPoints_h
#define DirectionFields_ClosestPoints_h

#include "Surface.h"
#include "Types.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <vector>

namespace DirectionFields
{
namespace Internal
{
class NormalRanges;
}

/// Finds the closest points of triangles, or of segments (triangles whose last two corners are the
/// same), in a time of about the logarithm of their number. It is a tree of boxes, four to a node,
/// each with a quarter of the node's triangles: halves of halves, cut along the axis on which the
/// middles spread farthest. Where the triangles are needles that lie askew in their boxes, as in
/// fans of cones, a node also has boxes that lie as its parts do. The tree is
/// built in parallel on the threads of the calling thread's Threads::Scope, and takes a sixth of
/// the time of a smoothest field on the surface.
class ClosestPoints
{
public:
  using Corners = std::array<Vector3, 3>;
  explicit ClosestPoints(std::vector<Corners> triangles);
  /// Triangles with ids of no point or coordinates that are not finite are not found.
  explicit ClosestPoints(const Surface& surface);

  struct Answer
  {
    /// None where nothing is within the distance asked for.
    Index Triangle = None;
    Vector3 Position = Vector3::Zero();
    double SquaredDistance = 0.0;
    /// Of the triangle's corners, at least 0; they sum up to 1.
    std::array<double, 3> Weights{};
    /// Where the triangle is in the tree, for the next search near it.
    Index Place = None;
  };
  /// The closest point of all triangles; of equally close triangles the first one. Coordinates are
  /// in the unit of the triangles. Nothing is found for a place that is not finite.
  /// @param normal   triangles whose normals have a negative product with it are not found; zero
  ///                 finds all
  /// @param distance nothing farther is found
  /// @param guess    Answer::Place of a triangle that may be near, which saves looking at farther
  ///                 ones, or None
  Answer Find(const Vector3& place, const Vector3& normal = Vector3::Zero(),
    double distance = std::numeric_limits<double>::infinity(), Index guess = None) const;

  /// Weights of the point of a triangle that is closest to a place (C. Ericson: Real-Time Collision
  /// Detection, 2005, section 5.1.5). Squares of the coordinates must neither overflow nor vanish.
  static std::array<double, 3> ClosestWeights(const Vector3& p, const Corners& t);

private:
  static constexpr Index Width = 4;
  static constexpr double Infinity = std::numeric_limits<double>::infinity();
  /// The boxes of Width nodes of the level below, or triangles.
  struct Node
  {
    using Numbers = Eigen::Array<double, Width, 1>;
    std::array<Numbers, 3> Low;
    std::array<Numbers, 3> High;
    Numbers SquaredDistances(const Vector3& p) const
    {
      Numbers sum = Numbers::Zero();
      for (int axis = 0; axis < 3; ++axis)
      {
        sum += (this->Low[axis] - p[axis]).max(p[axis] - this->High[axis]).max(0.0).square();
      }
      return sum;
    }
  };
  /// The slabs, each between two planes, that the parts of a node lie in: one across the needles
  /// and one along their normals. The directions are at right angles, and no longer than 1.
  struct Slabs
  {
    std::array<std::array<Node::Numbers, 3>, 2> Direction;
    std::array<Node::Numbers, 2> Low;
    std::array<Node::Numbers, 2> High;
    Node::Numbers SquaredDistances(const Vector3& p, double error) const
    {
      Node::Numbers sum = Node::Numbers::Zero();
      for (std::size_t k = 0; k < 2; ++k)
      {
        const std::array<Node::Numbers, 3>& d = this->Direction[k];
        const Node::Numbers height = d[0] * p[0] + d[1] * p[1] + d[2] * p[2];
        sum += ((this->Low[k] - height).max(height - this->High[k]) - error).max(0.0).square();
      }
      return sum;
    }
  };
  using Directions = std::array<Vector3, 2>;
  void Build(std::vector<Corners>&& triangles);
  void BuildLevels();
  bool HasOverlappingBoxes() const;
  void BuildSlabs();
  void AddLevelOfSlabs(std::vector<Directions>& directions, Index covered);
  /// Takes the closest point of a triangle if it is closer than the best one.
  void Consider(Index at, const Vector3& place, const Vector3& normal, Answer& best) const;

  /// A power of two, so that squares neither overflow nor vanish.
  double Scale = 1.0;
  /// In their order along the curve, scaled; and their numbers.
  std::vector<Corners> Triangles;
  std::vector<Index> Number;
  /// From the triangles up.
  std::vector<std::vector<Node>> Levels;
  /// Of the same nodes, but for those of the lowest level, which triangles tell themselves.
  std::shared_ptr<const Internal::NormalRanges> Normals;
  /// For the same nodes; empty unless boxes overlap much.
  std::vector<std::vector<Slabs>> LevelsOfSlabs;
};
}

#endif
