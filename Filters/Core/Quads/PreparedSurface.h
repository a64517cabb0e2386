// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_PreparedSurface_h
#define DirectionFields_PreparedSurface_h

#include "Geometry/SurfaceGeometry.h"
#include "Quads/ClosestPoints.h"
#include "Quads/KeptFeatures.h"
#include "Surface.h"

#include <memory>
#include <vector>

namespace DirectionFields::Internal
{
/// A surface as it can be mapped: connected across seams, wound consistently, and with a point in the middle
/// of each edge both ends of which have no frame (FramelessVertices).
class PreparedSurface
{
public:
  /// Throws MeshError.
  PreparedSurface(const Surface& input, int degree, const FeatureSettings& settings);

  /// Its points are the input's, then the middles.
  const std::shared_ptr<const Surface>& GetSurface() const { return this->Prepared; }
  const Repairs& GetRepairs() const { return this->Repaired; }

  /// Values at the input's points continued to the middles.
  template <typename T>
  std::vector<T> Continued(std::vector<T> values) const
  {
    for (const std::array<Index, 2>& ends : this->Middles)
    {
      values.push_back(values[ends[0]]);
    }
    return values;
  }

  /// The triangles of the input, as far as they are used, wound consistently.
  std::vector<ClosestPoints::Corners> GetTriangles() const;
  /// Where a point of these is on the input.
  Index InputTriangle(Index triangle) const { return this->Used[triangle].Input; }
  std::array<double, 3> InputWeights(Index triangle, const std::array<double, 3>& weights) const
  {
    const UsedTriangle& used = this->Used[triangle];
    std::array<double, 3> own{};
    for (int c = 0; c < 3; ++c)
    {
      own[used.InputCorner[c]] = weights[c];
    }
    return own;
  }

private:
  struct UsedTriangle
  {
    Triangle Points;
    Index Input;
    std::array<int, 3> InputCorner;
  };
  /// Returns whether any edge was split.
  bool SplitBetweenFrameless(Surface& surface, int degree, const FeatureSettings& settings);

  std::vector<UsedTriangle> Used;
  std::vector<std::array<Index, 2>> Middles;
  std::shared_ptr<const Surface> Prepared;
  Repairs Repaired;
};
}

#endif
