// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SurfaceDistance_h
#define DirectionFields_SurfaceDistance_h

#include "Geometry/IntrinsicGeometry.h"

#include <array>
#include <limits>
#include <vector>

namespace DirectionFields::Internal
{
/// A place on a mesh: the mean of a triangle's corners with these weights, which sum up to 1.
struct MeshPlace
{
  Index Triangle = None;
  std::array<double, 3> Weights{};
};

/// The distances of the vertices of a mesh from the nearest of some sources, along the surface.
/// Fronts run from the sources over the triangles laid flat, from near to far (fast marching,
/// Kimmel and Sethian 1998); across an edge that a front has passed it goes on as a circle around
/// the place that has its distances from both ends, if there is one and sources are points, else as
/// a straight line. So distances are exact on surfaces that can be laid flat and seen from the
/// source, and too long by one or two percent where the surface is curved or triangles have no
/// acute angles. Takes time n log n in the vertices reached.
class SurfaceDistance
{
public:
  /// A vertex that is a given distance from a source, in the unit of its component.
  struct Seed
  {
    Index Vertex;
    double Distance;
    /// The source that it belongs to.
    Index Source;
  };

  /// The kind of the sources: Points, whose fronts are circles, or the points of Curves, whose
  /// fronts are straight.
  enum class Sources
  {
    Points,
    Curves
  };

  /// @param most    fronts end at this distance
  /// @param targets fronts end where all of these vertices are reached, if there are any; others
  ///                may not have been then
  SurfaceDistance(const IntrinsicGeometry& geometry, const std::vector<Seed>& seeds,
    double most = std::numeric_limits<double>::infinity(), Sources sources = Sources::Points,
    const std::vector<Index>& targets = {});

  /// The distance of each vertex in the unit of its component; infinite where no front came.
  std::vector<double> Distance;
  /// The source that is nearest; None where no front came.
  std::vector<Index> Source;
  /// The vertices reached, from near to far.
  std::vector<Index> Order;

  /// The distance to a place within a triangle, from its corners.
  double At(const IntrinsicGeometry& geometry, const MeshPlace& place, Index& source) const;

  /// The corners of a place's triangle as seeds of a source there.
  static void AddSeeds(const IntrinsicGeometry& geometry, const MeshPlace& place, Index source,
    std::vector<Seed>& seeds);
  /// How far a place is from a corner of its triangle.
  static double ToCorner(const IntrinsicGeometry& geometry, const MeshPlace& place, int corner);

private:
  Sources Kind;
};
}

#endif
