// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Tracing/SurfacePath.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace DirectionFields
{
namespace
{
/// A path that crosses more triangles than this goes straight on in the last one.
constexpr int MostTriangles = 20000;
/// A path is straight in space where it leaves its chord by no more than this part of it and its
/// normals turn by no more than about 8 degrees.
constexpr double Straightness = 0.004;
constexpr double LeastCosine = 0.99;

/// The triangle at a point that a direction in its tangent plane leads into, and the direction
/// there: the angle keeps its share of the triangle's corner as seen in the tangent plane. None
/// where the direction leaves the surface.
Index FirstTriangle(
  const SurfaceIncidence& surface, const PathStart& start, Vector3& direction)
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

/// Goes straight on through one triangle after the other.
class Walk
{
public:
  Walk(const SurfaceIncidence& surface, const PathStart& start, const Vector3& direction)
    : Position(start.Position)
    , Normal(start.Normal)
    , Heading(direction)
    , Triangle(start.Triangle)
    , Surface(surface)
  {
    if (this->Triangle == None)
    {
      this->Triangle = FirstTriangle(surface, start, this->Heading);
      if (this->Triangle != None)
      {
        this->Normal = surface.Normal(this->Triangle);
        this->Normal *= this->Normal.dot(start.Normal) < 0.0 ? -1.0 : 1.0;
      }
    }
  }

  Vector3 Position;
  /// Of the triangle, on the side that the start says.
  Vector3 Normal;
  Vector3 Heading;
  Index Triangle;
  double Done = 0.0;
  /// The boundary is ahead.
  bool AtBoundary = false;

  /// Goes to the next edge, if that is ahead within the length, and into the triangle beyond it.
  bool Cross(double length)
  {
    double part = 0.0;
    const int exit = this->Triangle == None ? None : this->FindExit(part);
    if (exit == None)
    {
      return false;
    }
    const Vector3& a = this->Surface.Corner(this->Triangle, exit);
    const Vector3& b = this->Surface.Corner(this->Triangle, (exit + 1) % 3);
    const Vector3 place = a + part * (b - a);
    const double ahead = std::max((place - this->Position).dot(this->Heading), 0.0);
    if (this->Done + ahead >= length)
    {
      return false;
    }
    const Index next = this->Surface.Across(this->Triangle, exit);
    if (next == None)
    {
      this->AtBoundary = true;
      this->ToBoundary = ahead;
      return false;
    }
    const Corners& corners = this->Surface.GetSurface().Triangles[this->Triangle];
    this->Done += ahead;
    this->Position = place;
    this->Unfold(next, corners[exit], corners[(exit + 1) % 3]);
    return true;
  }

  /// How far the boundary is.
  double ToBoundary = 0.0;

private:
  using Corners = DirectionFields::Triangle;

  /// The corner from which the edge starts that the path leaves through: the one that runs from its
  /// right to its left. part: where on it. Paths keep a little off the points, where rounding could
  /// lead them into a triangle that they only touch.
  int FindExit(double& part) const
  {
    const bool isFlipped = this->Normal.dot(this->Surface.Normal(this->Triangle)) < 0.0;
    const Vector3 left =
      isFlipped ? this->Heading.cross(this->Normal) : this->Normal.cross(this->Heading);
    std::array<double, 3> side;
    for (int c = 0; c < 3; ++c)
    {
      side[c] = (this->Surface.Corner(this->Triangle, c) - this->Position).dot(left);
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

  /// Turns heading and normal about the edge between two points, into the next triangle's plane.
  void Unfold(Index next, Index from, Index to)
  {
    const auto& points = this->Surface.GetSurface().Points;
    const Vector3 edge = (points[to] - points[from]).normalized();
    const int c = this->Surface.FindCorner(next, from);
    const bool alongEdge = this->Surface.GetSurface().Triangles[next][(c + 1) % 3] == to;
    const Vector3 normal = this->Surface.Normal(next);
    // Away from the edge, on both sides of it.
    const Vector3 into = alongEdge ? normal.cross(edge) : edge.cross(normal);
    Vector3 out = this->Normal.cross(edge);
    const double sign = out.dot(this->Heading) < 0.0 ? -1.0 : 1.0;
    out *= sign;
    this->Heading =
      this->Heading.dot(edge) * edge + std::max(this->Heading.dot(out), 0.0) * into;
    this->Heading.normalize();
    this->Normal = edge.cross(into) * sign;
    this->Triangle = next;
  }

  const SurfaceIncidence& Surface;
};
}

SurfacePath::Station SurfacePath::At(double distance) const
{
  std::size_t i = 1;
  while (i + 1 < this->Stations.size() && this->Stations[i].Distance < distance)
  {
    ++i;
  }
  const Station& a = this->Stations[i - 1];
  const Station& b = this->Stations[i];
  const double length = b.Distance - a.Distance;
  const double part = length > 0.0 ? (distance - a.Distance) / length : 0.0;
  Vector3 normal = (1.0 - part) * a.Normal + part * b.Normal;
  const double size = normal.norm();
  normal = size > 1e-6 ? Vector3(normal / size) : a.Normal;
  return { distance, a.Position + part * (b.Position - a.Position), normal };
}

Vector3 SurfacePath::Heading(double distance) const
{
  const double end = this->Stations.back().Distance;
  const double step = 1e-4 * (end - this->Stations.front().Distance);
  const Vector3 before =
    this->At(std::max(distance - step, this->Stations.front().Distance)).Position;
  const Vector3 chord = this->At(std::min(distance + step, end)).Position - before;
  const double length = chord.norm();
  return length > 0.0 ? Vector3(chord / length) : Vector3::Zero();
}

Vector3 SurfacePath::Left(double distance) const
{
  const Vector3 left = this->At(distance).Normal.cross(this->Heading(distance));
  const double length = left.norm();
  return length > 1e-6 ? Vector3(left / length) : Vector3::Zero();
}

SurfacePath TracePath(const SurfaceIncidence& surface, const PathStart& start,
  const Vector3& direction, double length)
{
  SurfacePath path;
  path.Stations.push_back({ 0.0, start.Position, start.Normal });
  Walk walk(surface, start, direction);
  Vector3 before = walk.Normal;
  for (int crossed = 0; crossed < MostTriangles && walk.Cross(length); ++crossed)
  {
    const Vector3 mean = before + walk.Normal;
    const double size = mean.norm();
    path.Stations.push_back(
      { walk.Done, walk.Position, size > 1e-6 ? Vector3(mean / size) : before });
    before = walk.Normal;
  }
  path.Stations.push_back(
    { length, walk.Position + (length - walk.Done) * walk.Heading, walk.Normal });
  return path;
}

SurfacePoint Moved(
  const SurfaceIncidence& surface, const SurfacePoint& point, const Vector3& vector)
{
  PathStart start;
  start.Position = point.Position(surface);
  start.Normal = surface.Normal(point.Triangle);
  start.Triangle = point.Triangle;
  const Vector3 tangent = vector - vector.dot(start.Normal) * start.Normal;
  const double length = tangent.norm();
  if (!(length > 0.0))
  {
    return point;
  }
  Walk walk(surface, start, tangent / length);
  int crossed = 0;
  while (crossed < MostTriangles && walk.Cross(length))
  {
    ++crossed;
  }
  const double rest = walk.AtBoundary ? walk.ToBoundary : length - walk.Done;
  const Vector3 end = walk.Position + rest * walk.Heading;

  SurfacePoint moved;
  moved.Triangle = walk.Triangle;
  const double area = 2.0 * surface.Area(walk.Triangle);
  double sum = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const Vector3& a = surface.Corner(walk.Triangle, (c + 1) % 3);
    const Vector3& b = surface.Corner(walk.Triangle, (c + 2) % 3);
    const double weight =
      (a - end).cross(b - end).dot(surface.Normal(walk.Triangle)) / area;
    if (!(weight > -1e-6))
    {
      // From a corner of the triangle the way led out of it at once.
      return point;
    }
    moved.Weights[c] = std::max(weight, 0.0);
    sum += moved.Weights[c];
  }
  for (double& weight : moved.Weights)
  {
    weight /= sum;
  }
  return moved;
}

SurfacePath Joined(const SurfacePath& backward, const SurfacePath& forward)
{
  SurfacePath path;
  for (auto station = backward.Stations.rbegin(); station != backward.Stations.rend(); ++station)
  {
    path.Stations.push_back({ -station->Distance, station->Position, station->Normal });
  }
  path.Stations.insert(
    path.Stations.end(), forward.Stations.begin() + 1, forward.Stations.end());
  return path;
}

SurfacePath SimplifiedPath(const SurfacePath& path, int stations)
{
  const auto& all = path.Stations;
  const SurfacePath::Station& first = all.front();
  const SurfacePath::Station& last = all.back();
  const Vector3 chord = last.Position - first.Position;
  const double squaredLength = chord.squaredNorm();
  bool straight = true;
  for (const auto& station : all)
  {
    const Vector3 to = station.Position - first.Position;
    const double part = squaredLength > 0.0 ? to.dot(chord) / squaredLength : 0.0;
    straight = straight &&
      (to - part * chord).squaredNorm() <= Straightness * Straightness * squaredLength &&
      station.Normal.dot(first.Normal) > LeastCosine;
  }
  SurfacePath simple;
  if (straight)
  {
    simple.Stations = { first, last };
  }
  else if (all.size() <= static_cast<std::size_t>(stations))
  {
    simple = path;
  }
  else
  {
    for (int i = 0; i < stations; ++i)
    {
      simple.Stations.push_back(
        path.At(first.Distance + (last.Distance - first.Distance) * i / (stations - 1)));
    }
  }
  return simple;
}

double HeightAbove(const SurfacePath& path, const Vector3& origin, const Vector3& normal)
{
  double height = 0.0;
  for (const auto& station : path.Stations)
  {
    height = std::max(height, (station.Position - origin).dot(normal));
  }
  return height;
}
}
