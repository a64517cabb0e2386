// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Interpolation/FieldInterpolation.h"

#include "Interpolation/FieldInterpolant.h"
#include "Support/VectorMath.h"

#include <array>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Where the sum of the n-th powers is less than this part of their sizes, only rounding is left.
constexpr double LeastPart = 1e-9;
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

Vector3 DirectionsAt::Turned(int k, int degree) const
{
  const double angle = 2.0 * Pi * k / degree;
  return std::cos(angle) * this->Direction + std::sin(angle) * this->Normal.cross(this->Direction);
}

FieldInterpolation::FieldInterpolation(
  const SurfaceIncidence& surface, const GivenField& given, const PointDirections& field)
  : Surface(surface)
  , Given(given)
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

bool FieldInterpolation::CountsClockwise(Index point, Index vertex) const
{
  return this->Field.Degree > 2 &&
    this->Field.Direction(point, 0)
      .cross(this->Field.Direction(point, 1))
      .dot(this->Given.GetGeometry().Frames.Normal[vertex]) < 0.0;
}

DirectionsAt FieldInterpolation::At(const SurfacePoint& place) const
{
  DirectionsAt result;
  result.Position = place.Position(this->Surface);
  result.Normal = this->Surface.Normal(place.Triangle);
  const Index triangle = this->Given.GetMeshTriangles()[place.Triangle];
  if (triangle == None)
  {
    return result;
  }
  const TriangleInSpace space = this->Given.InSpace(triangle);
  const FieldInterpolant interpolant(
    this->Given.GetGeometry(), this->Field.Degree, this->Given.GetSection().data(), triangle);
  std::array<double, 3> weights;
  std::array<int, 3> corners;
  double total = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    corners[c] = this->Given.MeshCorner(triangle, c);
    weights[corners[c]] = place.Weights[c];
    const Index vertex = this->Given.GetMesh().Tail(3 * triangle + corners[c]);
    total += std::abs(this->Given.GetSection()[vertex]);
  }
  const Complex flat = interpolant.Flat().Place(weights);
  const Complex value = interpolant.At(flat);
  result.Normal = space.Normal;
  if (!(std::abs(value) > LeastPart * total))
  {
    return result;
  }
  const int nearest = NearestCorner(this->Surface, place.Triangle, result.Position);
  result.Point = this->Surface.GetSurface().Triangles[place.Triangle][nearest];
  result.Magnitude = std::abs(value);
  double root = std::arg(value) / this->Field.Degree;
  const Index vertex = this->Given.GetMesh().Tail(3 * triangle + corners[nearest]);
  if (this->Given.GetSection()[vertex] != 0.0)
  {
    // The n-th root that is nearest to direction 0 there.
    const Complex first =
      this->Given.GetGeometry().Frames.Tangential(vertex, this->Field.Direction(result.Point, 0));
    const double wanted = interpolant.AngleInFlat(corners[nearest], std::arg(first), flat);
    const double step = 2.0 * Pi / this->Field.Degree;
    root += step * std::round((wanted - root) / step);
    if (this->CountsClockwise(result.Point, vertex))
    {
      result.Normal = -result.Normal;
    }
  }
  result.Direction = space.Direction(std::polar(1.0, root));
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
