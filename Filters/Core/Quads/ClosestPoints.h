// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ClosestPoints_h
#define DirectionFields_ClosestPoints_h

#include "Types.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Finds the closest points of triangles, or of segments, which are triangles whose last two corners are the
/// same. A binary tree of boxes over them, in the order in which they are given: best along a Morton curve.
class ClosestPoints
{
public:
  using Corners = std::array<Vector3, 3>;
  explicit ClosestPoints(std::vector<Corners> triangles);

  struct Answer
  {
    Index Triangle = None;
    Vector3 Position = Vector3::Zero();
    double SquaredDistance = 0.0;
    /// Of the triangle's corners.
    std::array<double, 3> Weights{};
  };
  /// The closest point of all, of the triangles whose normals have a positive product with this one unless
  /// it is zero; of equally close triangles the first one. None if none is nearer than the distance.
  Answer Find(const Vector3& place, const Vector3& normal, double distance) const;
  const Corners& GetTriangle(Index t) const { return this->Triangles[t]; }

private:
  struct Box
  {
    Vector3 Low;
    Vector3 High;
    double SquaredDistance(const Vector3& p) const
    {
      return (this->Low - p).cwiseMax(p - this->High).cwiseMax(0.0).squaredNorm();
    }
  };
  /// Triangles of a leaf.
  static constexpr Index Leaf = 4;

  std::vector<Corners> Triangles;
  /// Levels from the leaves up; box k of one has boxes 2 k and 2 k + 1 of the one below.
  std::vector<std::vector<Box>> Levels;
};
}

#endif
