// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Preparation/RegionBorders.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace DirectionFields::Internal
{
std::vector<char> EdgesBetween(const TriangleMesh& mesh, const std::vector<Index>& regions)
{
  if (regions.empty())
  {
    return {};
  }
  std::vector<char> isBetween(mesh.GetNumberOfEdges(), 0);
  const auto regionOf = [&](Index h) { return regions[mesh.InputTriangle(h / 3)]; };
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = mesh.HalfEdge(e);
    const Index twin = mesh.Twin(h);
    isBetween[e] = twin != None && regionOf(h) != regionOf(twin) ? 1 : 0;
  }
  return isBetween;
}

namespace
{
/// A turn by less is no stair.
constexpr double LeastTurn = Pi / 9.0;
/// The part of a chain's vertices that may be stairs.
constexpr double MostStairs = 0.05;

class Chains
{
public:
  Chains(const SurfaceGeometry& geometry, std::vector<char>& isHard)
    : Mesh(geometry.Mesh)
    , Places(geometry.Positions)
    , IsHard(isHard)
    , Edges(geometry.Mesh.GetNumberOfVertices(), { None, None })
    , IsNode(geometry.Mesh.GetNumberOfVertices(), 0)
    , IsSeen(geometry.Mesh.GetNumberOfEdges(), 0)
  {
    for (Index e = 0; e < this->Mesh.GetNumberOfEdges(); ++e)
    {
      for (const Index v : this->EndsOf(e))
      {
        if (isHard[e] != 0)
        {
          std::array<Index, 2>& own = this->Edges[v];
          this->IsNode[v] = own[1] != None || this->Mesh.IsBoundary(v) ? 1 : this->IsNode[v];
          own[own[0] == None ? 0 : 1] = e;
        }
      }
    }
  }

  double DropStairs(double shortest)
  {
    double all = 0.0;
    double dropped = 0.0;
    // From their ends first; what is left then is closed.
    for (const bool areClosed : { false, true })
    {
      for (Index e = 0; e < this->Mesh.GetNumberOfEdges(); ++e)
      {
        for (const Index start : this->EndsOf(e))
        {
          if (this->IsHard[e] == 0 || this->IsSeen[e] != 0 ||
            (!areClosed && this->IsNode[start] == 0))
          {
            continue;
          }
          const std::vector<Index> chain = this->Follow(start, e);
          const double length = this->LengthOf(chain);
          all += length;
          if (this->IsOfStairs(chain, shortest))
          {
            dropped += length;
            this->Dropped.insert(this->Dropped.end(), chain.begin(), chain.end());
          }
        }
      }
    }
    for (const Index e : this->Dropped)
    {
      this->IsHard[e] = 0;
    }
    return all > 0.0 ? dropped / all : 0.0;
  }

private:
  std::array<Index, 2> EndsOf(Index e) const
  {
    const Index h = this->Mesh.HalfEdge(e);
    return { this->Mesh.Tail(h), this->Mesh.Head(h) };
  }
  Index Other(Index e, Index v) const
  {
    const std::array<Index, 2> ends = this->EndsOf(e);
    return ends[0] == v ? ends[1] : ends[0];
  }
  double LengthOf(const std::vector<Index>& chain) const
  {
    double length = 0.0;
    for (const Index e : chain)
    {
      const std::array<Index, 2> ends = this->EndsOf(e);
      length += (this->Places[ends[1]] - this->Places[ends[0]]).norm();
    }
    return length;
  }

  std::vector<Index> Follow(Index v, Index e)
  {
    std::vector<Index> chain;
    while (e != None && this->IsSeen[e] == 0)
    {
      this->IsSeen[e] = 1;
      chain.push_back(e);
      v = this->Other(e, v);
      const std::array<Index, 2>& own = this->Edges[v];
      e = this->IsNode[v] != 0 ? None : own[own[0] == e ? 1 : 0];
    }
    return chain;
  }

  /// The change of the border's direction at a vertex; zero at ends.
  Vector3 TurnAt(Index v) const
  {
    const std::array<Index, 2>& own = this->Edges[v];
    if (this->IsNode[v] != 0 || own[1] == None)
    {
      return Vector3::Zero();
    }
    const Vector3& at = this->Places[v];
    return (this->Places[this->Other(own[0], v)] - at).stableNormalized() +
      (this->Places[this->Other(own[1], v)] - at).stableNormalized();
  }

  bool IsOfStairs(const std::vector<Index>& chain, double shortest) const
  {
    const double least = 2.0 * std::sin(0.5 * LeastTurn);
    std::size_t steps = 0;
    for (const Index e : chain)
    {
      const std::array<Index, 2> ends = this->EndsOf(e);
      const Vector3 a = this->TurnAt(ends[0]);
      const Vector3 b = this->TurnAt(ends[1]);
      const bool isStep = a.norm() > least && b.norm() > least &&
        a.dot(b) < -0.5 * a.norm() * b.norm() &&
        (this->Places[ends[1]] - this->Places[ends[0]]).norm() < shortest;
      steps += isStep ? 1 : 0;
    }
    return static_cast<double>(steps) > MostStairs * static_cast<double>(chain.size());
  }

  const TriangleMesh& Mesh;
  const std::vector<Vector3>& Places;
  std::vector<char>& IsHard;
  /// Two edges of the borders at each vertex.
  std::vector<std::array<Index, 2>> Edges;
  /// Not 0 where borders end or meet.
  std::vector<char> IsNode;
  std::vector<char> IsSeen;
  std::vector<Index> Dropped;
};
}

double DropStairs(const SurfaceGeometry& geometry, std::vector<char>& isHard, double shortest)
{
  if (isHard.empty())
  {
    return 0.0;
  }
  const TriangleMesh& mesh = geometry.Mesh;
  double length = 0.0;
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = mesh.HalfEdge(e);
    length += isHard[e] == 0
      ? 0.0
      : (geometry.Positions[mesh.Head(h)] - geometry.Positions[mesh.Tail(h)]).norm();
  }
  double area = 0.0;
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    const Vector3& p = geometry.Positions[mesh.Tail(3 * t)];
    area += 0.5 *
      (geometry.Positions[mesh.Tail(3 * t + 1)] - p)
        .cross(geometry.Positions[mesh.Tail(3 * t + 2)] - p)
        .norm();
  }
  if (area < shortest * length)
  {
    std::fill(isHard.begin(), isHard.end(), 0);
    return 1.0;
  }
  return Chains(geometry, isHard).DropStairs(shortest);
}
}
