// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "OwnField/CrossedFeatures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace DirectionFields::Internal
{
CrossedFeatures::CrossedFeatures(const SurfaceGeometry& geometry, int degree,
  const std::vector<char>& isFeature, const std::vector<Complex>& section)
  : Geometry(geometry)
  , Along(geometry.Mesh.GetNumberOfVertices(), Vector3::Zero())
  , IsCrossed(geometry.Mesh.GetNumberOfVertices(), 0)
{
  constexpr double mostOff = 15.0 / 180.0 * Pi;
  // Edges at a vertex that agree less than this have no common direction.
  constexpr double leastAgreement = 0.5;
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<Complex> sum(mesh.GetNumberOfVertices(), 0.0);
  std::vector<int> count(mesh.GetNumberOfVertices(), 0);
  std::vector<double> length(mesh.GetNumberOfVertices(), 0.0);
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = mesh.HalfEdge(e);
    if (isFeature[e] == 0 && mesh.Twin(h) != None)
    {
      continue;
    }
    const Vector3 edge = geometry.Positions[mesh.Head(h)] - geometry.Positions[mesh.Tail(h)];
    for (const Index v : { mesh.Tail(h), mesh.Head(h) })
    {
      const Complex tangential = geometry.Frames.Tangential(v, edge);
      if (std::abs(tangential) > 0.0)
      {
        sum[v] += std::polar(1.0, degree * std::arg(tangential));
        ++count[v];
        length[v] += edge.norm();
      }
    }
  }
  double all = 0.0;
  double crossed = 0.0;
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (count[v] == 0 || std::abs(sum[v]) < leastAgreement * count[v])
    {
      continue;
    }
    const double angle = std::arg(sum[v]) / degree;
    this->Along[v] =
      std::cos(angle) * geometry.Frames.X[v] + std::sin(angle) * geometry.Frames.Y(v);
    if (section[v] != 0.0)
    {
      all += length[v];
      const double off = std::abs(std::arg(section[v] * std::conj(sum[v])));
      this->IsCrossed[v] = off > degree * mostOff ? 1 : 0;
      crossed += this->IsCrossed[v] != 0 ? length[v] : 0.0;
    }
  }
  this->Part = all > 0.0 ? crossed / all : 0.0;
}

std::vector<char> CrossedFeatures::FindNear(double distance, const std::vector<Index>& others) const
{
  const TriangleMesh& mesh = this->Geometry.Mesh;
  std::vector<double> reached(mesh.GetNumberOfVertices(), distance);
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto begin = [&](Index v)
  {
    reached[v] = 0.0;
    queue.emplace(0.0, v);
  };
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (this->IsCrossed[v] != 0)
    {
      begin(v);
    }
  }
  std::for_each(others.begin(), others.end(), begin);
  std::vector<Index> fan;
  while (!queue.empty())
  {
    const auto [length, v] = queue.top();
    queue.pop();
    if (length > reached[v])
    {
      continue;
    }
    mesh.GetFan(v, fan);
    for (const Index h : fan)
    {
      for (const Index next : { mesh.Head(h), mesh.Tail(TriangleMesh::Previous(h)) })
      {
        const double further =
          length + (this->Geometry.Positions[next] - this->Geometry.Positions[v]).norm();
        if (further < reached[next])
        {
          reached[next] = further;
          queue.emplace(further, next);
        }
      }
    }
  }
  std::vector<char> isNear(mesh.GetNumberOfVertices());
  std::transform(reached.begin(), reached.end(), isNear.begin(),
    [&](double length) { return length < distance ? 1 : 0; });
  return isNear;
}
}
