// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Paths/SurfaceWalk.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// The triangle at a point that a direction in its tangent plane leads into, and the direction
/// there: the angle keeps its share of the triangle's corner as seen in the tangent plane. None
/// where the direction leaves the surface.
Index FirstTriangle(const SurfaceIncidence& surface, const PathStart& start, Vector3& direction)
{
  const Vector3 y = start.Normal.cross(direction);
  const Index* end = surface.EndTriangles(start.Point);
  for (const Index* t = surface.BeginTriangles(start.Point); t != end; ++t)
  {
    const int c = surface.FindCorner(*t, start.Point);
    const Vector3 a = surface.Corner(*t, (c + 1) % 3) - start.Position;
    const Vector3 b = surface.Corner(*t, (c + 2) % 3) - start.Position;
    // Angles of the two edges, seen from the direction.
    const double first = std::atan2(a.dot(y), a.dot(direction));
    const double second = std::atan2(b.dot(y), b.dot(direction));
    const double low = std::min(first, second);
    const double high = std::max(first, second);
    if (low <= 0.0 && high > 0.0 && high - low < Pi)
    {
      const Vector3 normal = surface.Normal(*t);
      const double corner = std::atan2(a.cross(b).dot(normal), a.dot(b));
      const double angle = corner * first / (first - second);
      const Vector3 edge = a.normalized();
      direction = std::cos(angle) * edge + std::sin(angle) * normal.cross(edge);
      return *t;
    }
  }
  return None;
}
}

SurfaceWalk::SurfaceWalk(
  const SurfaceIncidence& surface, const PathStart& start, const Vector3& direction)
  : Surface(surface)
  , Position_(start.Position)
  , Normal_(start.Normal)
  , Heading_(direction)
  , Triangle_(start.Triangle)
{
  if (this->Triangle_ == None)
  {
    this->Triangle_ = FirstTriangle(surface, start, this->Heading_);
    if (this->Triangle_ != None)
    {
      this->Normal_ = surface.Normal(this->Triangle_);
      this->Normal_ *= this->Normal_.dot(start.Normal) < 0.0 ? -1.0 : 1.0;
    }
  }
}

bool SurfaceWalk::Cross(double length)
{
  double part = 0.0;
  const int exit = this->Triangle_ == None ? None : this->FindExit(part);
  if (exit == None)
  {
    return false;
  }
  const Vector3& a = this->Surface.Corner(this->Triangle_, exit);
  const Vector3& b = this->Surface.Corner(this->Triangle_, (exit + 1) % 3);
  const Vector3 place = a + part * (b - a);
  const double ahead = std::max((place - this->Position_).dot(this->Heading_), 0.0);
  if (this->Done_ + ahead >= length)
  {
    return false;
  }
  const Index next = this->Surface.Across(this->Triangle_, exit);
  if (next == None)
  {
    this->AtBoundary_ = true;
    this->ToBoundary_ = ahead;
    return false;
  }
  const auto& corners = this->Surface.GetSurface().Triangles[this->Triangle_];
  this->Done_ += ahead;
  this->Position_ = place;
  this->Unfold(next, corners[exit], corners[(exit + 1) % 3]);
  return true;
}

int SurfaceWalk::FindExit(double& part) const
{
  const bool isFlipped = this->Normal_.dot(this->Surface.Normal(this->Triangle_)) < 0.0;
  const Vector3 left =
    isFlipped ? this->Heading_.cross(this->Normal_) : this->Normal_.cross(this->Heading_);
  std::array<double, 3> side;
  for (int c = 0; c < 3; ++c)
  {
    side[c] = (this->Surface.Corner(this->Triangle_, c) - this->Position_).dot(left);
  }
  for (int c = 0; c < 3; ++c)
  {
    const double from = side[c];
    const double to = side[(c + 1) % 3];
    const bool leaves = from <= 0.0 && to > 0.0;
    if (leaves)
    {
      part = std::clamp(from / (from - to), 1e-6, 1.0 - 1e-6);
      return c;
    }
  }
  return None;
}

void SurfaceWalk::Unfold(Index next, Index from, Index to)
{
  const auto& points = this->Surface.GetSurface().Points;
  const Vector3 edge = (points[to] - points[from]).normalized();
  const int c = this->Surface.FindCorner(next, from);
  const bool alongEdge = this->Surface.GetSurface().Triangles[next][(c + 1) % 3] == to;
  const Vector3 normal = this->Surface.Normal(next);
  // Away from the edge, on both sides of it.
  const Vector3 into = alongEdge ? normal.cross(edge) : edge.cross(normal);
  Vector3 out = this->Normal_.cross(edge);
  const double sign = out.dot(this->Heading_) < 0.0 ? -1.0 : 1.0;
  out *= sign;
  this->Heading_ = this->Heading_.dot(edge) * edge + std::max(this->Heading_.dot(out), 0.0) * into;
  this->Heading_.normalize();
  this->Normal_ = edge.cross(into) * sign;
  this->Triangle_ = next;
}
}
