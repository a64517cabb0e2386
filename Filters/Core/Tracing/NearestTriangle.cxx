// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Tracing/NearestTriangle.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index MostInLeaf = 4;

/// The weight of the end in the point of a segment that is nearest to a point.
double AlongSegment(const Vector3& start, const Vector3& end, const Vector3& point)
{
  const Vector3 edge = end - start;
  const double square = edge.squaredNorm();
  return square > 0.0 ? std::clamp((point - start).dot(edge) / square, 0.0, 1.0) : 0.0;
}
}

NearestTriangle::NearestTriangle(const Surface& surface)
  : Mesh(surface)
{
  const auto size = static_cast<Index>(surface.Points.size());
  std::vector<Vector3> middles(surface.Triangles.size(), Vector3::Zero());
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Triangle& corners = surface.Triangles[t];
    const bool isSound = std::all_of(corners.begin(), corners.end(),
      [&](Index i) { return i >= 0 && i < size && surface.Points[i].allFinite(); });
    if (isSound)
    {
      for (const Index i : corners)
      {
        middles[t] += surface.Points[i] / 3.0;
      }
      this->Order.push_back(static_cast<Index>(t));
    }
  }
  if (!this->Order.empty())
  {
    this->Build(0, static_cast<Index>(this->Order.size()), middles);
  }
}

Index NearestTriangle::Build(Index begin, Index end, const std::vector<Vector3>& middles)
{
  const auto number = static_cast<Index>(this->Nodes.size());
  Node node{ Box(), begin, end, None, None };
  Box places;
  for (Index k = begin; k < end; ++k)
  {
    for (const Index i : this->Mesh.Triangles[this->Order[k]])
    {
      node.Bounds.extend(this->Mesh.Points[i]);
    }
    places.extend(middles[this->Order[k]]);
  }
  this->Nodes.push_back(node);
  if (end - begin > MostInLeaf)
  {
    int axis = 0;
    places.sizes().maxCoeff(&axis);
    const Index middle = begin + (end - begin) / 2;
    std::nth_element(this->Order.begin() + begin, this->Order.begin() + middle,
      this->Order.begin() + end,
      [&](Index a, Index b)
      { return std::make_pair(middles[a][axis], a) < std::make_pair(middles[b][axis], b); });
    const Index left = this->Build(begin, middle, middles);
    const Index right = this->Build(middle, end, middles);
    this->Nodes[number].Left = left;
    this->Nodes[number].Right = right;
  }
  return number;
}

NearestTriangle::Found NearestTriangle::InTriangle(Index triangle, const Vector3& point) const
{
  const Triangle& ids = this->Mesh.Triangles[triangle];
  const std::array<Vector3, 3> corners = { this->Mesh.Points[ids[0]], this->Mesh.Points[ids[1]],
    this->Mesh.Points[ids[2]] };
  Found found;
  found.Triangle = triangle;
  const auto consider = [&](const std::array<double, 3>& weights)
  {
    const Vector3 place =
      weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
    const double distance = (place - point).stableNorm();
    if (distance < found.Distance)
    {
      found.Weights = weights;
      found.Distance = distance;
    }
  };
  const Vector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double square = normal.squaredNorm();
  if (square > 0.0)
  {
    const double second = (corners[2] - corners[1]).cross(point - corners[1]).dot(normal) / square;
    const double third = (corners[0] - corners[2]).cross(point - corners[2]).dot(normal) / square;
    // The part opposite of edge 1-2 belongs to corner 0, and so on.
    const std::array<double, 3> weights = { second, third, 1.0 - second - third };
    if (weights[0] >= 0.0 && weights[1] >= 0.0 && weights[2] >= 0.0)
    {
      consider(weights);
      return found;
    }
  }
  for (std::size_t c = 0; c < 3; ++c)
  {
    const std::size_t next = (c + 1) % 3;
    std::array<double, 3> weights{};
    weights[next] = AlongSegment(corners[c], corners[next], point);
    weights[c] = 1.0 - weights[next];
    consider(weights);
  }
  return found;
}

NearestTriangle::Found NearestTriangle::Find(const Vector3& point, double most) const
{
  Found best;
  best.Distance = most;
  if (this->Nodes.empty() || !point.allFinite())
  {
    return {};
  }
  // Nodes yet to be looked at, with their distances; the nearer part of a node comes first.
  std::vector<std::pair<double, Index>> open = { { 0.0, 0 } };
  while (!open.empty())
  {
    const auto [distance, number] = open.back();
    open.pop_back();
    const Node& node = this->Nodes[number];
    if (distance > best.Distance)
    {
      continue;
    }
    if (node.Left == None)
    {
      for (Index k = node.Begin; k < node.End; ++k)
      {
        const Found found = this->InTriangle(this->Order[k], point);
        const bool isEarlier = best.Triangle == None || found.Triangle < best.Triangle;
        if (found.Distance < best.Distance || (found.Distance == best.Distance && isEarlier))
        {
          best = found;
        }
      }
      continue;
    }
    const double left = this->Nodes[node.Left].Bounds.exteriorDistance(point);
    const double right = this->Nodes[node.Right].Bounds.exteriorDistance(point);
    open.emplace_back(left < right ? right : left, left < right ? node.Right : node.Left);
    open.emplace_back(left < right ? left : right, left < right ? node.Left : node.Right);
  }
  return best.Triangle == None ? Found() : best;
}
}
