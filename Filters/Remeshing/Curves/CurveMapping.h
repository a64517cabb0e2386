// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CurveMapping_h
#define DirectionFields_CurveMapping_h

#include "Curves/CurveCut.h"

#include <array>
#include <vector>

namespace DirectionFields::Internal
{
/// From a surface to what curves have cut it into, and back.
class CurveMapping
{
public:
  /// Both must outlive this.
  CurveMapping(const Surface& given, const CurveCut& cut);

  /// Values of the triangles given for their parts; empty for none.
  std::vector<Index> RegionsOfParts(const std::vector<Index>& regions) const;
  /// Adds numbers for the points of cuts, interpolated between the corners of the triangles that
  /// they are in, unless there are none at all.
  void ContinueSizes(std::vector<double>& sizes) const;
  /// The same for directions, which are those of the closest corner.
  void ContinueDirections(std::vector<Vector3>& directions) const;

  /// Lets the points and faces of a mesh of the cut surface refer to the one given.
  /// @param triangle, weights where each point is
  /// @param faceSource        the triangle of each face
  void ReferToGiven(std::vector<Index>& triangle, std::vector<std::array<double, 3>>& weights,
    std::vector<Index>& faceSource) const;

private:
  using Weights = std::array<double, 3>;
  Weights WeightsIn(Index triangle, const Vector3& place) const;

  const Surface& Given;
  const CurveCut& Cut;
  /// The triangle given that each point of a cut is in.
  std::vector<Index> TrianglesOfNew;
};
}

#endif
