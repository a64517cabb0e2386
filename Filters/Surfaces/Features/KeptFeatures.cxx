// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/KeptFeatures.h"

#include "Features/FeatureChains.h"
#include "Geometry/DihedralAngles.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Dropped chains let others grow together, which are looked at again.
constexpr int MostRounds = 4;

class ShortChains
{
public:
  ShortChains(
    const SurfaceGeometry& geometry, std::vector<char>& isFeature, const std::vector<char>& isHard)
    : Geometry(geometry)
    , Mesh(geometry.Mesh)
    , IsFeature(isFeature)
    , IsHard(isHard)
  {
  }

  /// Returns whether any was dropped.
  bool Drop(double shortest)
  {
    this->EdgesAt.assign(this->Mesh.GetNumberOfVertices(), {});
    for (Index e = 0; e < this->Mesh.GetNumberOfEdges(); ++e)
    {
      if (this->IsFeature[e] != 0)
      {
        const Index h = this->Mesh.HalfEdge(e);
        this->EdgesAt[this->Mesh.Tail(h)].push_back(e);
        this->EdgesAt[this->Mesh.Head(h)].push_back(e);
      }
    }
    this->IsSeen.assign(this->Mesh.GetNumberOfEdges(), 0);
    bool hasDropped = false;
    std::vector<Index> dropped;
    for (const bool fromNodes : { true, false })
    {
      for (Index v = 0; v < this->Mesh.GetNumberOfVertices(); ++v)
      {
        if (this->IsNode(v) != fromNodes)
        {
          continue;
        }
        for (const Index e : this->EdgesAt[v])
        {
          if (this->IsSeen[e] == 0)
          {
            this->Follow(v, e, shortest, dropped);
          }
        }
      }
    }
    for (const Index e : dropped)
    {
      if (this->IsHard.empty() || this->IsHard[e] == 0)
      {
        this->IsFeature[e] = 0;
        hasDropped = true;
      }
    }
    return hasDropped;
  }

private:
  bool IsNode(Index v) const { return this->EdgesAt[v].size() != 2 || this->Mesh.IsBoundary(v); }
  bool IsFreeEnd(Index v) const
  {
    return this->EdgesAt[v].size() == 1 && !this->Mesh.IsBoundary(v);
  }

  void Follow(Index start, Index first, double shortest, std::vector<Index>& dropped)
  {
    std::vector<Index> chain;
    double length = 0.0;
    Index v = start;
    Index e = first;
    while (e != None)
    {
      this->IsSeen[e] = 1;
      chain.push_back(e);
      const Index h = this->Mesh.HalfEdge(e);
      length += (this->Geometry.Positions[this->Mesh.Head(h)] -
        this->Geometry.Positions[this->Mesh.Tail(h)])
                  .norm();
      v = this->Mesh.Tail(h) == v ? this->Mesh.Head(h) : this->Mesh.Tail(h);
      e = None;
      if (!this->IsNode(v))
      {
        for (const Index next : this->EdgesAt[v])
        {
          e = this->IsSeen[next] == 0 ? next : e;
        }
      }
    }
    const bool isClosed = v == start && !this->IsNode(v);
    const bool endsFreely = this->IsFreeEnd(start) || this->IsFreeEnd(v);
    if ((isClosed || endsFreely) && length < shortest)
    {
      dropped.insert(dropped.end(), chain.begin(), chain.end());
    }
  }

  const SurfaceGeometry& Geometry;
  const TriangleMesh& Mesh;
  std::vector<char>& IsFeature;
  const std::vector<char>& IsHard;
  std::vector<std::vector<Index>> EdgesAt;
  std::vector<char> IsSeen;
};
}

std::vector<char> FindFeatures(
  const SurfaceGeometry& geometry, const FeatureSettings& settings, const std::vector<char>& isHard)
{
  std::vector<char> isFeature(geometry.Mesh.GetNumberOfEdges(), 0);
  if (settings.AreKept)
  {
    const std::vector<double> dihedral = DihedralAngles(geometry);
    const FeatureChains chains(
      geometry, dihedral, { settings.Angle * Pi / 180.0, settings.MinimumLength });
    for (Index e = 0; e < geometry.Mesh.GetNumberOfEdges(); ++e)
    {
      isFeature[e] = chains.IsFeature(e) ? 1 : 0;
    }
  }
  for (std::size_t e = 0; e < isHard.size(); ++e)
  {
    isFeature[e] = isFeature[e] != 0 || isHard[e] != 0 ? 1 : 0;
  }
  if (settings.AreKept)
  {
    DropShortFeatures(geometry, settings, isFeature, isHard);
  }
  return isFeature;
}

void DropShortFeatures(const SurfaceGeometry& geometry, const FeatureSettings& settings,
  std::vector<char>& isFeature, const std::vector<char>& isHard)
{
  ShortChains shortChains(geometry, isFeature, isHard);
  for (int k = 0; k < MostRounds && shortChains.Drop(settings.ShortestChain); ++k)
  {
  }
}

std::vector<Vector3> FeatureDirections(
  const SurfaceGeometry& geometry, const std::vector<char>& isFeature)
{
  // Flat features count for less than all sharp ones.
  constexpr double least = 1e-3;
  const TriangleMesh& mesh = geometry.Mesh;
  const std::vector<double> dihedral = DihedralAngles(geometry);
  std::vector<Vector3> direction(mesh.GetNumberOfVertices(), Vector3::Zero());
  std::vector<double> sharpest(mesh.GetNumberOfVertices(), 0.0);
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    if (isFeature[e] == 0)
    {
      continue;
    }
    const Index h = mesh.HalfEdge(e);
    const Vector3 along =
      (geometry.Positions[mesh.Head(h)] - geometry.Positions[mesh.Tail(h)]).normalized();
    for (const Index v : { mesh.Tail(h), mesh.Head(h) })
    {
      const double angle = std::max(std::abs(dihedral[e]), least);
      if (angle > sharpest[v] && !mesh.IsBoundary(v) && along.allFinite())
      {
        sharpest[v] = angle;
        direction[v] = along;
      }
    }
  }
  return direction;
}
}
