// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ThinParts_h
#define DirectionFields_ThinParts_h

#include "Distance/ClosestPoints.h"
#include "FaceMesh/Faces.h"
#include "Surface.h"

#include <string>
#include <utility>
#include <vector>

namespace DirectionFields::Internal
{
/// The distance of each point of a surface from its mesh, or from it of the middle of a face that
/// is closest to a triangle of the point, whichever is larger.
/// @param faceSource the triangle that each face's middle is closest to
std::vector<double> DistancesBothWays(const Surface& surface, const std::vector<Vector3>& points,
  const std::vector<Faces::Face>& faces, const std::vector<Index>& faceSource);

/// The distances of points of a surface from the closest triangle that faces the other way: on a
/// plate its thickness, around a limb of radius r about 1.4 r. Each one is found when it is asked
/// for.
class Thicknesses
{
public:
  /// The surface has to outlive this.
  explicit Thicknesses(const Surface& surface);
  /// Infinite where there is no such triangle within a distance, and at points without triangles.
  /// @param triangles those of the surface
  /// @param near      a point near p that was asked for before, or None
  double At(Index p, const ClosestPoints& triangles, double most, Index near = None);

private:
  struct Thickness
  {
    double Within = 0.0;
    double Distance = 0.0;
    /// As ClosestPoints::Answer.
    Index Place = None;
  };
  const Surface& Given;
  std::vector<Vector3> Normal;
  std::vector<Thickness> Known;
};

/// Where faces of the wanted size are too large: limbs and tips around which fewer than four fit
/// are not in the mesh, as the distance from there to it tells. The faces are made smaller there,
/// and the mesh once more.
class ThinParts
{
public:
  /// The surface has to outlive this.
  /// @param sizes   wanted at each point relative to elsewhere; empty for the same everywhere
  /// @param longest lengths of edges at each point for another reason, infinite for any; empty for
  ///                any everywhere
  explicit ThinParts(
    const Surface& surface, std::vector<double> sizes = {}, const std::vector<double>& longest = {})
    : Given(surface)
    , Sizes(std::move(sizes))
    , Thickness(surface)
    , Longest(longest)
    , Lengths(longest)
  {
  }

  /// Makes edges shorter, by the thickness, at parts that are thinner than the wanted length and
  /// have a point that is farther from the mesh than half of it; and where there is such a point
  /// anyway. Each time they get shorter by another factor. From there on the length grows by a
  /// quarter of the way. Returns false, and changes nothing, where no point is farther than a
  /// length.
  /// @param triangles  those of the surface
  /// @param distance   of each point of the surface from the mesh
  /// @param edgeLength the wanted length of edges where the size is 1
  bool Shrink(
    const ClosestPoints& triangles, const std::vector<double>& distance, double edgeLength);

  /// The longest length of edges at each point, at least 1/8 of the wanted one; infinite where they
  /// may be as long as they are, and empty if that is everywhere.
  const std::vector<double>& GetLengths() const { return this->Lengths; }

  /// Tells the user where edges are shorter at thin parts. Empty where none are.
  /// @param origin place around which the surface is given here
  /// @param unit of the surface
  std::string Sentence(const Vector3& origin, double unit) const;

private:
  const Surface& Given;
  std::vector<double> Sizes;
  Thicknesses Thickness;
  std::vector<double> Longest;
  std::vector<double> Lengths;
  /// Of lengths at lost parts in their thickness.
  double Share = 1.0;
};
}

#endif
