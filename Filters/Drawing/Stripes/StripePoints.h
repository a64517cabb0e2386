// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_StripePoints_h
#define DirectionFields_StripePoints_h

#include "Stripes.h"
#include "Stripes/StripePieces.h"

#include <array>
#include <cstdint>
#include <vector>

namespace DirectionFields::Internal
{
/// Where the points that StripePieces number are.
class StripePoints
{
public:
  explicit StripePoints(const StripePieces& pieces);

  /// @param point as in StripePiece
  StripePoint At(std::int64_t point) const;
  /// The position, and the unit normal of the surface, interpolated between its vertices.
  Vector3 Position(std::int64_t point) const;
  Vector3 Normal(std::int64_t point) const;

private:
  struct MeshPlace
  {
    std::array<Index, 3> Vertices;
    std::array<double, 3> Weights;
  };
  MeshPlace Locate(std::int64_t point) const;

  const StripePieces& Pieces;
  /// Of each crossing.
  LargeArray<StripeLevels::Place> Crossings;
};
}

#endif
