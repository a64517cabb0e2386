// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Preparation/RegionBorders.h"

#include "Features/EdgeChains.h"

#include <algorithm>
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

void AddCurves(const TriangleMesh& mesh, const std::vector<std::array<Index, 2>>& curves,
  const std::vector<Index>& original, std::vector<char>& isHard)
{
  if (curves.empty())
  {
    return;
  }
  isHard.resize(static_cast<std::size_t>(mesh.GetNumberOfEdges()), 0);
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = mesh.HalfEdge(e);
    const auto ends =
      std::minmax(original[mesh.Point(mesh.Tail(h))], original[mesh.Point(mesh.Head(h))]);
    const std::array<Index, 2> edge = { ends.first, ends.second };
    if (mesh.Twin(h) != None && std::binary_search(curves.begin(), curves.end(), edge))
    {
      isHard[e] = 1;
    }
  }
}

namespace
{
/// A turn by less is no stair.
constexpr double LeastTurn = Pi / 9.0;
/// The part of a chain's edges that may be stairs.
constexpr double MostStairs = 0.05;

double LengthOf(const std::vector<EdgeChain>& chains, const SurfaceGeometry& geometry)
{
  double length = 0.0;
  for (const EdgeChain& chain : chains)
  {
    length += chain.Length(geometry);
  }
  return length;
}

double AreaOf(const SurfaceGeometry& geometry)
{
  const std::vector<Vector3>& places = geometry.Positions;
  double area = 0.0;
  for (Index t = 0; t < geometry.Mesh.GetNumberOfTriangles(); ++t)
  {
    const Vector3& p = places[geometry.Mesh.Tail(3 * t)];
    area += 0.5 *
      (places[geometry.Mesh.Tail(3 * t + 1)] - p)
        .cross(places[geometry.Mesh.Tail(3 * t + 2)] - p)
        .norm();
  }
  return area;
}

/// The change of a chain's direction at each of its vertices; zero at its ends.
std::vector<Vector3> TurnsOf(const EdgeChain& chain, const std::vector<Vector3>& places)
{
  const std::size_t edges = chain.Edges.size();
  std::vector<Vector3> turns(edges + 1, Vector3::Zero());
  for (std::size_t i = chain.IsClosed ? 0 : 1; i < edges; ++i)
  {
    const Vector3& at = places[chain.Vertices[i]];
    const Vector3& before = places[chain.Vertices[(i + edges - 1) % edges]];
    turns[i] =
      (before - at).stableNormalized() + (places[chain.Vertices[i + 1]] - at).stableNormalized();
  }
  turns[edges] = turns[0];
  return turns;
}

bool RunsInStairs(const EdgeChain& chain, const std::vector<Vector3>& places, double shortest)
{
  const double least = 2.0 * std::sin(0.5 * LeastTurn);
  const std::vector<Vector3> turns = TurnsOf(chain, places);
  std::size_t steps = 0;
  for (std::size_t i = 0; i < chain.Edges.size(); ++i)
  {
    const double a = turns[i].norm();
    const double b = turns[i + 1].norm();
    const bool isStep = a > least && b > least && turns[i].dot(turns[i + 1]) < -0.5 * a * b &&
      (places[chain.Vertices[i + 1]] - places[chain.Vertices[i]]).norm() < shortest;
    steps += isStep ? 1 : 0;
  }
  return static_cast<double>(steps) > MostStairs * static_cast<double>(chain.Edges.size());
}
}

double DropStairs(const SurfaceGeometry& geometry, std::vector<char>& isHard, double shortest)
{
  if (isHard.empty())
  {
    return 0.0;
  }
  const std::vector<EdgeChain> chains = ChainsOf(geometry.Mesh, isHard);
  const double length = LengthOf(chains, geometry);
  if (AreaOf(geometry) < shortest * length)
  {
    std::fill(isHard.begin(), isHard.end(), 0);
    return 1.0;
  }
  double dropped = 0.0;
  for (const EdgeChain& chain : chains)
  {
    if (RunsInStairs(chain, geometry.Positions, shortest))
    {
      dropped += chain.Length(geometry);
      for (const Index e : chain.Edges)
      {
        isHard[e] = 0;
      }
    }
  }
  return length > 0.0 ? dropped / length : 0.0;
}
}
