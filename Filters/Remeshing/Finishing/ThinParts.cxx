// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/ThinParts.h"

#include "Finishing/FaceSources.h"
#include "Soup/JoinedSets.h"
#include "Support/Sentences.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

namespace DirectionFields::Internal
{
namespace
{
/// A part is lost if a point of it is farther from the mesh than this, in lengths of edges; all its
/// points that are farther than the second one belong to it.
constexpr double Lost = 1.0;
constexpr double Belongs = 0.5;
/// Edges get shorter by this factor each time. At first they are half as long at least, as the
/// thickness is none near sharp edges, then a quarter and an eighth.
constexpr double Shorter = 0.7;
constexpr double Halved = 0.5;
constexpr double Shortest = 0.125;
/// By which part of the way lengths grow.
constexpr double Growth = 0.25;
constexpr double Any = std::numeric_limits<double>::infinity();

/// Calls visit(p, q) for the two ends of each edge of each triangle.
template <typename Visit>
void ForEachEdge(const Surface& surface, const Visit& visit)
{
  for (const Triangle& t : surface.Triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      visit(t[c], t[(c + 1) % 3]);
    }
  }
}

/// The neighbours of each point along edges; those of point p start at First[p].
struct Neighbours
{
  std::vector<Index> First;
  std::vector<Index> All;

  explicit Neighbours(const Surface& surface)
    : First(surface.Points.size() + 1, 0)
  {
    ForEachEdge(surface,
      [&](Index p, Index q)
      {
        ++this->First[p + 1];
        ++this->First[q + 1];
      });
    for (std::size_t p = 1; p < this->First.size(); ++p)
    {
      this->First[p] += this->First[p - 1];
    }
    this->All.resize(this->First.back());
    std::vector<Index> next(this->First.begin(), this->First.end() - 1);
    ForEachEdge(surface,
      [&](Index p, Index q)
      {
        this->All[next[p]++] = q;
        this->All[next[q]++] = p;
      });
  }
};

/// Makes lengths grow by no more than a part of the way along edges.
void LimitGrowth(const Surface& surface, const Neighbours& neighbours, std::vector<double>& lengths)
{
  std::priority_queue<std::pair<double, Index>, std::vector<std::pair<double, Index>>,
    std::greater<>>
    queue;
  for (std::size_t p = 0; p < lengths.size(); ++p)
  {
    if (lengths[p] < Any)
    {
      queue.emplace(lengths[p], static_cast<Index>(p));
    }
  }
  while (!queue.empty())
  {
    const auto [length, p] = queue.top();
    queue.pop();
    for (Index k = neighbours.First[p]; length == lengths[p] && k < neighbours.First[p + 1]; ++k)
    {
      const Index q = neighbours.All[k];
      const double grown = length + Growth * (surface.Points[q] - surface.Points[p]).norm();
      if (grown < lengths[q])
      {
        lengths[q] = grown;
        queue.emplace(grown, q);
      }
    }
  }
}
}

std::vector<double> DistancesBothWays(const Surface& surface, const std::vector<Vector3>& points,
  const std::vector<Faces::Face>& faces, const std::vector<Index>& faceSource)
{
  std::vector<double> distance = DistancesTo(points, faces, surface.Points);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const Vector3 middle = MiddleOf(points, faces[f]);
    const Triangle& t = surface.Triangles[faceSource[f]];
    const ClosestPoints::Corners corners = { surface.Points[t[0]], surface.Points[t[1]],
      surface.Points[t[2]] };
    const std::array<double, 3> w = ClosestPoints::ClosestWeights(middle, corners);
    const double here = (w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2] - middle).norm();
    for (const Index p : t)
    {
      distance[p] = std::max(distance[p], here);
    }
  }
  return distance;
}

Thicknesses::Thicknesses(const Surface& surface)
  : Given(surface)
  , Normal(surface.Points.size(), Vector3::Zero())
  , Known(surface.Points.size())
{
  for (const Triangle& t : surface.Triangles)
  {
    const Vector3 here = (surface.Points[t[1]] - surface.Points[t[0]])
                           .cross(surface.Points[t[2]] - surface.Points[t[0]]);
    for (const Index p : t)
    {
      this->Normal[p] += here;
    }
  }
}

double Thicknesses::At(Index p, const ClosestPoints& triangles, double most, Index near)
{
  if (this->Normal[p].isZero(0.0))
  {
    return Any;
  }
  Thickness& here = this->Known[p];
  if (here.Within < most)
  {
    const ClosestPoints::Answer at = triangles.Find(
      this->Given.Points[p], -this->Normal[p], most, near == None ? None : this->Known[near].Place);
    here = { most, at.Triangle == None ? Any : std::sqrt(at.SquaredDistance), at.Place };
  }
  return here.Distance;
}

bool ThinParts::Shrink(
  const ClosestPoints& triangles, const std::vector<double>& distance, double edgeLength)
{
  const Surface& surface = this->Given;
  const Neighbours neighbours(surface);
  const auto lengthAt = [&](Index p)
  { return this->Sizes.empty() ? edgeLength : this->Sizes[p] * edgeLength; };
  const auto isFartherThan = [&](Index p, double lengths)
  { return neighbours.First[p] < neighbours.First[p + 1] && distance[p] > lengths * lengthAt(p); };
  const auto points = static_cast<Index>(surface.Points.size());
  bool isLost = false;
  std::vector<Index> part;
  std::vector<char> isOfPart(points, 0);
  for (Index p = 0; p < points; ++p)
  {
    isLost = isLost || isFartherThan(p, Lost);
    if (isFartherThan(p, Belongs))
    {
      part.push_back(p);
      isOfPart[p] = 1;
    }
  }
  if (!isLost)
  {
    return false;
  }
  this->Lengths.resize(points, Any);
  const std::size_t far = part.size();
  for (std::size_t k = 0; k < part.size(); ++k)
  {
    const Index p = part[k];
    for (Index n = neighbours.First[p]; n < neighbours.First[p + 1]; ++n)
    {
      const Index q = neighbours.All[n];
      if (isOfPart[q] == 0 && this->Thickness.At(q, triangles, lengthAt(q), p) < lengthAt(q))
      {
        isOfPart[q] = 1;
        part.push_back(q);
      }
    }
  }
  for (std::size_t k = 0; k < part.size(); ++k)
  {
    const double wanted = lengthAt(part[k]);
    double length = this->Share * this->Thickness.At(part[k], triangles, wanted);
    if (k < far)
    {
      length = std::min(length, Shorter * this->Share * wanted);
    }
    const double least = std::max(Shortest, Halved * this->Share * this->Share) * wanted;
    this->Lengths[part[k]] = std::min(this->Lengths[part[k]], std::max(least, length));
  }
  this->Share *= Shorter;
  LimitGrowth(surface, neighbours, this->Lengths);
  for (Index p = 0; p < points; ++p)
  {
    this->Lengths[p] = this->Lengths[p] < lengthAt(p) ? this->Lengths[p] : Any;
  }
  return true;
}

std::string ThinParts::Sentence(const Vector3& origin, double unit) const
{
  const Surface& surface = this->Given;
  const auto isShorter = [&](Index p)
  { return this->Lengths[p] < (this->Longest.empty() ? Any : this->Longest[p]); };
  Index shortest = None;
  for (Index p = 0; p < static_cast<Index>(this->Lengths.size()); ++p)
  {
    shortest = isShorter(p) && (shortest == None || this->Lengths[p] < this->Lengths[shortest])
      ? p
      : shortest;
  }
  if (shortest == None)
  {
    return {};
  }
  // Each place counts at its point of the lowest number.
  JoinedSets parts(static_cast<Index>(this->Lengths.size()));
  ForEachEdge(surface,
    [&](Index p, Index q)
    {
      if (isShorter(p) && isShorter(q))
      {
        parts.Join(p, q);
      }
    });
  Index count = 0;
  for (Index p = 0; p < static_cast<Index>(this->Lengths.size()); ++p)
  {
    count += isShorter(p) && parts.Find(p) == p ? 1 : 0;
  }
  const Vector3 place = unit * surface.Points[shortest] + origin;
  return "Edges are shorter, down to " + Figure(unit * this->Lengths[shortest]) + ", at " +
    std::to_string(count) + (count == 1 ? " place" : " places") +
    " where limbs or tips would be lost, as at (" + Figure(place[0]) + ", " + Figure(place[1]) +
    ", " + Figure(place[2]) + "). Keep Thin Parts off makes them as long as elsewhere.";
}
}
