// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Paths/SurfaceIncidence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// A triangle whose area is a smaller part of its longest edge's square has no reliable normal.
constexpr double LeastFlatness = 1e-10;
/// Longest edges, squared, between which areas can be squared with a wide margin.
constexpr double LeastUsual = 1e-100;
constexpr double MostUsual = 1e130;
/// Points of more triangles have their normals kept.
constexpr std::ptrdiff_t LargeFan = 64;

/// The squares of the longest edges of sound triangles and of all.
struct LongestEdges
{
  double OfSound = 0.0;
  double OfAll = 0.0;

  /// Whether areas can be squared. Spikes have no part in that: where triangles are sound beside
  /// them, these decide.
  bool AreUsual() const
  {
    const double longest = this->OfSound > 0.0 ? this->OfSound : this->OfAll;
    return longest >= LeastUsual && longest <= MostUsual;
  }
};

/// @param edges gets those of the triangle, too
double SoundArea(const Surface& surface, const Triangle& triangle, LongestEdges& edges)
{
  const auto size = static_cast<Index>(surface.Points.size());
  for (const Index i : triangle)
  {
    if (i < 0 || i >= size || !surface.Points[i].allFinite())
    {
      return 0.0;
    }
  }
  const Vector3 a = surface.Points[triangle[1]] - surface.Points[triangle[0]];
  const Vector3 b = surface.Points[triangle[2]] - surface.Points[triangle[0]];
  const double area = 0.5 * a.cross(b).norm();
  const double longest = std::max({ a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm() });
  const bool isSound = std::isfinite(area) && area > LeastFlatness * longest;
  edges.OfAll = std::max(edges.OfAll, longest);
  edges.OfSound = std::max(edges.OfSound, isSound ? longest : 0.0);
  return isSound ? area : 0.0;
}
}

SurfaceIncidence::SurfaceIncidence(const Surface& surface)
  : Mesh(&surface)
  , Areas(surface.Triangles.size())
  , First(surface.Points.size() + 1, 0)
{
  LongestEdges longest;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    this->Areas[t] = SoundArea(surface, surface.Triangles[t], longest);
    if (this->Areas[t] > 0.0)
    {
      for (const Index i : surface.Triangles[t])
      {
        ++this->First[i + 1];
      }
    }
  }
  this->UsualSize = longest.AreUsual();
  for (std::size_t i = 0; i + 1 < this->First.size(); ++i)
  {
    this->First[i + 1] += this->First[i];
  }
  // One element more gives the end of the last list an address.
  this->Incident.resize(this->First.back() + 1, None);
  std::vector<std::size_t> next(this->First.begin(), this->First.end() - 1);
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    if (this->Areas[t] > 0.0)
    {
      for (const Index i : surface.Triangles[t])
      {
        this->Incident[next[i]++] = static_cast<Index>(t);
      }
    }
  }
  for (Index i = 0; i < this->GetNumberOfPoints(); ++i)
  {
    if (this->EndTriangles(i) - this->BeginTriangles(i) > LargeFan)
    {
      this->NormalsOfLargeFans[i] = this->MeanNormal(i);
    }
  }
}

Vector3 SurfaceIncidence::Normal(Index triangle) const
{
  const Vector3& a = this->Corner(triangle, 0);
  return (this->Corner(triangle, 1) - a).cross(this->Corner(triangle, 2) - a) /
    (2.0 * this->Areas[triangle]);
}

int SurfaceIncidence::FindCorner(Index triangle, Index point) const
{
  const Triangle& corners = this->Mesh->Triangles[triangle];
  for (int c = 0; c < 3; ++c)
  {
    if (corners[c] == point)
    {
      return c;
    }
  }
  return None;
}

Vector3 SurfaceIncidence::PointNormal(Index point) const
{
  if (this->EndTriangles(point) - this->BeginTriangles(point) > LargeFan)
  {
    return this->NormalsOfLargeFans.at(point);
  }
  return this->MeanNormal(point);
}

Vector3 SurfaceIncidence::MeanNormal(Index point) const
{
  Vector3 sum = Vector3::Zero();
  for (const Index* t = this->BeginTriangles(point); t != this->EndTriangles(point); ++t)
  {
    const int c = this->FindCorner(*t, point);
    const Vector3 a = this->Corner(*t, (c + 1) % 3) - this->Corner(*t, c);
    const Vector3 b = this->Corner(*t, (c + 2) % 3) - this->Corner(*t, c);
    sum += std::atan2(2.0 * this->Areas[*t], a.dot(b)) * this->Normal(*t);
  }
  const double length = sum.norm();
  return length > 1e-9 ? Vector3(sum / length) : Vector3::Zero();
}

double SurfaceIncidence::ShortestEdge(Index point) const
{
  double shortest = std::numeric_limits<double>::infinity();
  double sum = 0.0;
  int count = 0;
  for (const Index* t = this->BeginTriangles(point); t != this->EndTriangles(point); ++t)
  {
    const int c = this->FindCorner(*t, point);
    for (const int other : { (c + 1) % 3, (c + 2) % 3 })
    {
      const double length = (this->Corner(*t, other) - this->Corner(*t, c)).norm();
      shortest = std::min(shortest, length);
      sum += length;
      ++count;
    }
  }
  return count > 0 ? std::max(shortest, 0.25 * sum / count) : 0.0;
}

Index SurfaceIncidence::Across(Index triangle, int corner) const
{
  const Triangle& corners = this->Mesh->Triangles[triangle];
  Index from = corners[corner];
  Index to = corners[(corner + 1) % 3];
  // A way around a point of many triangles crosses all of them: it must not look at all each time.
  if (this->First[to + 1] - this->First[to] < this->First[from + 1] - this->First[from])
  {
    std::swap(from, to);
  }
  Index found = None;
  for (const Index* t = this->BeginTriangles(from); t != this->EndTriangles(from); ++t)
  {
    if (*t != triangle && this->FindCorner(*t, to) != None)
    {
      if (found != None)
      {
        return None;
      }
      found = *t;
    }
  }
  return found;
}
}
