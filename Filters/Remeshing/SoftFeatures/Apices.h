// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Apices_h
#define DirectionFields_Apices_h

#include "Surface.h"

#include <memory>
#include <vector>

namespace DirectionFields::Internal
{
/// The tips of cones: points of a surface that a mesh loses unless one of its vertices is there.
class Apices
{
public:
  /// @param surface with any indices and coordinates
  explicit Apices(std::shared_ptr<const Surface> surface);

  /// Those that stand by themselves between faces of a size: up to the length of an edge away the
  /// surface has no boundary, and is bent by less than half as much, counting both ways, as the
  /// tips of noise and of bumps smaller than a face are not. Points of the surface, ascending.
  /// @param sizes      at the points of the surface
  /// @param edgeLength of size 1, in the unit of the surface
  std::vector<Index> For(const std::vector<double>& sizes, double edgeLength) const;

private:
  std::shared_ptr<const Surface> Given;
  /// 2 pi less the sum of the angles at each point; empty where no point may be a tip.
  std::vector<double> Defects;
  std::vector<Index> Candidates;
};
}

#endif
