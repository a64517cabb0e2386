// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Tracing/FieldInterpolation.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields
{
namespace
{
/// Where the n-th powers cancel to this part of what they are, only rounding is left.
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

Vector3 AnyOrthogonal(const Vector3& normal)
{
  Eigen::Index smallest;
  normal.cwiseAbs().minCoeff(&smallest);
  return normal.cross(Vector3::Unit(smallest)).normalized();
}
}

Vector3 DirectionsAt::Turned(int k, int degree) const
{
  const double angle = 2.0 * Pi * k / degree;
  return std::cos(angle) * this->Direction +
    std::sin(angle) * this->Normal.cross(this->Direction);
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

DirectionsAt FieldInterpolation::At(const SurfacePoint& place) const
{
  const Index t = place.Triangle;
  const Triangle& corners = this->Surface.GetSurface().Triangles[t];
  DirectionsAt result;
  result.Position = place.Position(this->Surface);
  result.Normal = this->Surface.Normal(t);

  std::array<Vector3, 3> direction, normal;
  std::array<double, 3> magnitude;
  std::array<bool, 3> valid;
  Vector3 blended = Vector3::Zero();
  for (int c = 0; c < 3; ++c)
  {
    valid[c] = this->Read(corners[c], direction[c], magnitude[c]);
    if (valid[c])
    {
      normal[c] = this->Normal(corners[c], direction[c], result.Normal);
      blended += place.Weights[c] * normal[c];
    }
  }
  // Around a surface that cannot be oriented there are triangles whose corners mean different sides;
  // the directions are the same from both.
  int clearest = 0;
  for (int c = 0; c < 3; ++c)
  {
    if (valid[c] &&
      (!valid[clearest] ||
        std::abs(normal[c].dot(result.Normal)) > std::abs(normal[clearest].dot(result.Normal))))
    {
      clearest = c;
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    if (valid[c] && normal[c].dot(normal[clearest]) < LeastOpposite)
    {
      normal[c] = -normal[c];
      blended += 2.0 * place.Weights[c] * normal[c];
    }
  }
  if (blended.dot(result.Normal) < 0.0)
  {
    result.Normal = -result.Normal;
  }
  const double length = blended.norm();
  const Vector3 between = length > 1e-6 ? Vector3(blended / length) : result.Normal;
  const Vector3 x = AnyOrthogonal(between);
  const Vector3 y = between.cross(x);
  Complex sum = 0.0;
  double total = 0.0;
  std::array<Vector3, 3> carried;
  for (int c = 0; c < 3; ++c)
  {
    if (valid[c])
    {
      carried[c] = Carry(direction[c], normal[c], between);
      const double angle = std::atan2(carried[c].dot(y), carried[c].dot(x));
      sum += std::polar(place.Weights[c] * magnitude[c], this->Field.Degree * angle);
      total += place.Weights[c] * magnitude[c];
    }
  }
  if (!(std::abs(sum) > LeastPart * total))
  {
    return result;
  }

  double least = -1.0;
  int nearest = 0;
  for (int c = 0; c < 3; ++c)
  {
    const double distance =
      (this->Surface.GetSurface().Points[corners[c]] - result.Position).squaredNorm();
    if (least < 0.0 || distance < least)
    {
      least = distance;
      nearest = c;
    }
  }
  result.Point = corners[nearest];
  result.Magnitude = std::abs(sum);
  double angle = std::arg(sum) / this->Field.Degree;
  if (valid[nearest])
  {
    // The n-th root that is nearest to direction 0 there.
    const double wanted = std::atan2(carried[nearest].dot(y), carried[nearest].dot(x));
    const double step = 2.0 * Pi / this->Field.Degree;
    angle += step * std::round((wanted - angle) / step);
  }
  const Vector3 there = std::cos(angle) * x + std::sin(angle) * y;
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
