// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Tracing/FieldInterpolation.h"

#include "Support/VectorMath.h"

#include <array>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Where the sum of the n-th powers is less than this part of their sizes, only rounding is left.
constexpr double LeastPart = 1e-9;
/// Normals at two corners of a triangle with a cosine below this mean different sides of the surface;
/// above it they may stand at a sharp feature.
constexpr double LeastOpposite = -0.5;

/// A vector orthogonal to the unit vector `from` after the least rotation that takes `from` to the
/// unit vector `to`.
Vector3 Carry(const Vector3& v, const Vector3& from, const Vector3& to)
{
  const double denominator = 1.0 + from.dot(to);
  if (denominator < 1e-9)
  {
    // Half a turn, about whatever axis: that of v, which then stays.
    return v;
  }
  return v - to.dot(v) / denominator * (from + to);
}

/// The corner of a triangle that is nearest to a place, the first of several.
int NearestCorner(const SurfaceIncidence& surface, Index triangle, const Vector3& place)
{
  double least = -1.0;
  int nearest = 0;
  for (int c = 0; c < 3; ++c)
  {
    const double distance = (surface.Corner(triangle, c) - place).squaredNorm();
    if (least < 0.0 || distance < least)
    {
      least = distance;
      nearest = c;
    }
  }
  return nearest;
}
}

/// What is given at the corners of a triangle.
struct FieldInterpolation::Corners
{
  std::array<Vector3, 3> Direction, Normal;
  std::array<double, 3> Magnitude;
  /// Whether a corner has directions; what else there is of it is undefined if not.
  std::array<bool, 3> Valid;

  /// The interpolated normal, not normalized.
  /// @param weights        of the corners
  /// @param triangleNormal the unit normal of the triangle
  Vector3 Blend(const std::array<double, 3>& weights, const Vector3& triangleNormal)
  {
    Vector3 blended = Vector3::Zero();
    for (int c = 0; c < 3; ++c)
    {
      if (this->Valid[c])
      {
        blended += weights[c] * this->Normal[c];
      }
    }
    // Around a surface that cannot be oriented there are triangles whose corners mean different
    // sides; the directions are the same from both.
    int clearest = 0;
    for (int c = 0; c < 3; ++c)
    {
      if (this->Valid[c] &&
        (!this->Valid[clearest] ||
          std::abs(this->Normal[c].dot(triangleNormal)) >
            std::abs(this->Normal[clearest].dot(triangleNormal))))
      {
        clearest = c;
      }
    }
    for (int c = 0; c < 3; ++c)
    {
      if (this->Valid[c] && this->Normal[c].dot(this->Normal[clearest]) < LeastOpposite)
      {
        this->Normal[c] = -this->Normal[c];
        blended += 2.0 * weights[c] * this->Normal[c];
      }
    }
    return blended;
  }
};

Vector3 DirectionsAt::Turned(int k, int degree) const
{
  const double angle = 2.0 * Pi * k / degree;
  return std::cos(angle) * this->Direction + std::sin(angle) * this->Normal.cross(this->Direction);
}

FieldInterpolation::FieldInterpolation(
  const SurfaceIncidence& surface, const PointDirections& field)
  : Surface(surface)
  , Field(field)
{
}

bool FieldInterpolation::Read(Index point, Vector3& direction, double& magnitude) const
{
  direction = this->Field.Direction(point, 0);
  magnitude = this->Field.Magnitude(point);
  const double length = direction.norm();
  if (!std::isfinite(length) || !(length > 0.0) || !std::isfinite(magnitude) || !(magnitude > 0.0))
  {
    return false;
  }
  direction /= length;
  return true;
}

Vector3 FieldInterpolation::Normal(
  Index point, const Vector3& direction, const Vector3& triangleNormal) const
{
  Vector3 normal = Vector3::Zero();
  if (this->Field.Degree > 2)
  {
    // The directions say which side they mean, even where the triangles are not wound alike.
    normal = direction.cross(this->Field.Direction(point, 1));
  }
  else
  {
    const Vector3 mean = this->Surface.PointNormal(point);
    normal = mean - mean.dot(direction) * direction;
    if (normal.dot(triangleNormal) < -0.5)
    {
      normal = -normal;
    }
  }
  double length = normal.norm();
  if (!(length > 1e-3) || !std::isfinite(length))
  {
    normal = triangleNormal - triangleNormal.dot(direction) * direction;
    length = normal.norm();
  }
  return length > 1e-6 ? Vector3(normal / length) : AnyOrthogonal(direction);
}

FieldInterpolation::Corners FieldInterpolation::ReadCorners(Index triangle) const
{
  const Triangle& points = this->Surface.GetSurface().Triangles[triangle];
  const Vector3 triangleNormal = this->Surface.Normal(triangle);
  Corners corners;
  for (int c = 0; c < 3; ++c)
  {
    corners.Valid[c] = this->Read(points[c], corners.Direction[c], corners.Magnitude[c]);
    if (corners.Valid[c])
    {
      corners.Normal[c] = this->Normal(points[c], corners.Direction[c], triangleNormal);
    }
  }
  return corners;
}

DirectionsAt FieldInterpolation::At(const SurfacePoint& place) const
{
  DirectionsAt result;
  result.Position = place.Position(this->Surface);
  result.Normal = this->Surface.Normal(place.Triangle);
  Corners corners = this->ReadCorners(place.Triangle);
  const Vector3 blended = corners.Blend(place.Weights, result.Normal);
  if (blended.dot(result.Normal) < 0.0)
  {
    result.Normal = -result.Normal;
  }
  const double length = blended.norm();
  const Vector3 between = length > 1e-6 ? Vector3(blended / length) : result.Normal;
  const Vector3 x = AnyOrthogonal(between);
  const Vector3 y = between.cross(x);
  // u, of which each corner's is carried to the plane between.
  Complex sum = 0.0;
  double total = 0.0;
  std::array<double, 3> angle;
  for (int c = 0; c < 3; ++c)
  {
    if (corners.Valid[c])
    {
      const Vector3 carried = Carry(corners.Direction[c], corners.Normal[c], between);
      angle[c] = std::atan2(carried.dot(y), carried.dot(x));
      const double weight = place.Weights[c] * corners.Magnitude[c];
      sum += std::polar(weight, this->Field.Degree * angle[c]);
      total += weight;
    }
  }
  if (!(std::abs(sum) > LeastPart * total))
  {
    return result;
  }

  const int nearest = NearestCorner(this->Surface, place.Triangle, result.Position);
  result.Point = this->Surface.GetSurface().Triangles[place.Triangle][nearest];
  result.Magnitude = std::abs(sum);
  double root = std::arg(sum) / this->Field.Degree;
  if (corners.Valid[nearest])
  {
    // The n-th root that is nearest to direction 0 there.
    const double step = 2.0 * Pi / this->Field.Degree;
    root += step * std::round((angle[nearest] - root) / step);
  }
  const Vector3 there = std::cos(root) * x + std::sin(root) * y;
  result.Direction = Carry(there, between, result.Normal).normalized();
  return result;
}

DirectionsAt FieldInterpolation::AtPoint(Index point) const
{
  DirectionsAt result;
  result.Position = this->Surface.GetSurface().Points[point];
  result.Point = point;
  double magnitude = 0.0;
  if (this->Surface.IsUsed(point) && this->Read(point, result.Direction, magnitude))
  {
    result.Normal = this->Normal(
      point, result.Direction, this->Surface.Normal(*this->Surface.BeginTriangles(point)));
    result.Magnitude = magnitude;
  }
  return result;
}
}
