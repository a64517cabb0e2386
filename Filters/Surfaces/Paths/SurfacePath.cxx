// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Paths/SurfacePath.h"

#include "Paths/SurfaceWalk.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// A path that crosses more triangles than this goes straight on in the last one.
constexpr int MostTriangles = 20000;
/// A path is straight in space where it leaves its chord by no more than this part of it and its
/// normals turn by no more than about 8 degrees.
constexpr double Straightness = 0.004;
constexpr double LeastCosine = 0.99;
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

SurfacePath TracePath(
  const SurfaceIncidence& surface, const PathStart& start, const Vector3& direction, double length)
{
  SurfacePath path;
  path.Stations.push_back({ 0.0, start.Position, start.Normal });
  SurfaceWalk walk(surface, start, direction);
  Vector3 before = walk.Normal();
  for (int crossed = 0; crossed < MostTriangles && walk.Cross(length); ++crossed)
  {
    const Vector3 mean = before + walk.Normal();
    const double size = mean.norm();
    path.Stations.push_back(
      { walk.Done(), walk.Position(), size > 1e-6 ? Vector3(mean / size) : before });
    before = walk.Normal();
  }
  path.Stations.push_back(
    { length, walk.Position() + (length - walk.Done()) * walk.Heading(), walk.Normal() });
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
  SurfaceWalk walk(surface, start, tangent / length);
  int crossed = 0;
  while (crossed < MostTriangles && walk.Cross(length))
  {
    ++crossed;
  }
  const double rest = walk.AtBoundary() ? walk.ToBoundary() : length - walk.Done();
  const Vector3 end = walk.Position() + rest * walk.Heading();

  SurfacePoint moved;
  moved.Triangle = walk.Triangle();
  const double area = 2.0 * surface.Area(walk.Triangle());
  double sum = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const Vector3& a = surface.Corner(walk.Triangle(), (c + 1) % 3);
    const Vector3& b = surface.Corner(walk.Triangle(), (c + 2) % 3);
    const double weight = (a - end).cross(b - end).dot(surface.Normal(walk.Triangle())) / area;
    if (!(weight > -1e-6))
    {
      // The way led out of the triangle at once, from one of its corners.
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
  path.Stations.insert(path.Stations.end(), forward.Stations.begin() + 1, forward.Stations.end());
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
