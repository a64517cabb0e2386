// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_NearestTriangle_h
#define DirectionFields_NearestTriangle_h

#include "Surface.h"
#include "Types.h"

#include <array>
#include <limits>
#include <vector>

namespace DirectionFields::Internal
{
/// Finds the point of a surface that is nearest to a point in space, in about the logarithm of the triangles: a tree
/// of boxes around them. Triangles with ids of no point or coordinates that are not finite are not found.
class NearestTriangle
{
public:
  /// Takes n log n time.
  /// @param surface must outlive this
  explicit NearestTriangle(const Surface& surface);

  struct Found
  {
    /// None where nothing is within the distance asked for.
    Index Triangle = None;
    /// Of its corners, at least 0; they sum up to 1.
    std::array<double, 3> Weights{};
    double Distance = std::numeric_limits<double>::infinity();
  };
  /// Of equally near triangles the first.
  Found Find(const Vector3& point, double most = std::numeric_limits<double>::infinity()) const;

private:
  using Box = Eigen::AlignedBox3d;
  /// A range of Order, and its two parts if it has more than a few.
  struct Node
  {
    Box Bounds;
    Index Begin, End;
    Index Left, Right;
  };
  Index Build(Index begin, Index end, const std::vector<Vector3>& middles);
  Found InTriangle(Index triangle, const Vector3& point) const;

  const Surface& Mesh;
  std::vector<Index> Order;
  std::vector<Node> Nodes;
};
}

#endif
