// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SurfaceWalk_h
#define DirectionFields_SurfaceWalk_h

#include "Paths/SurfaceIncidence.h"

namespace DirectionFields::Internal
{
/// Where a path starts: inside a triangle, or on a point of the surface.
struct PathStart
{
  Vector3 Position;
  /// Unit normal there.
  Vector3 Normal;
  /// None on a point: the triangle is then the one that the path's direction points into.
  Index Triangle = None;
  /// None inside a triangle.
  Index Point = None;
};

/// Goes over a surface from one triangle to the next, straight on as if they were laid flat.
class SurfaceWalk
{
public:
  /// @param surface   must outlive this
  /// @param direction unit tangent vector at the start
  SurfaceWalk(const SurfaceIncidence& surface, const PathStart& start, const Vector3& direction);

  /// Goes to the edge ahead and into the triangle beyond it. Returns false, and stays, where the
  /// whole way would become longer than the given length, and on the boundary.
  bool Cross(double length);

  /// None where the direction leads away from the surface at once.
  Index Triangle() const { return this->Triangle_; }
  /// A place on the edge that was crossed last, or the start.
  const Vector3& Position() const { return this->Position_; }
  /// Unit normal of the triangle, on the side that the start says.
  const Vector3& Normal() const { return this->Normal_; }
  /// Unit tangent vector of the walk.
  const Vector3& Heading() const { return this->Heading_; }
  /// The length of the walk from the start to the position.
  double Done() const { return this->Done_; }
  /// The walk has come to the boundary, which is ToBoundary() ahead of the position.
  bool AtBoundary() const { return this->AtBoundary_; }
  double ToBoundary() const { return this->ToBoundary_; }

private:
  /// The corner from which the edge starts that the walk leaves through: the one that runs from its
  /// right to its left. None if there is none.
  /// @param part is set to where on the edge that is, from 0 to 1. A walk keeps a little off the
  ///             points, where rounding could lead it into a triangle that it only touches.
  int FindExit(double& part) const;
  /// Turns heading and normal about the edge between two points, into the next triangle's plane.
  void Unfold(Index next, Index from, Index to);

  const SurfaceIncidence& Surface;
  Vector3 Position_;
  Vector3 Normal_;
  Vector3 Heading_;
  Index Triangle_;
  double Done_ = 0.0;
  bool AtBoundary_ = false;
  double ToBoundary_ = 0.0;
};
}

#endif
