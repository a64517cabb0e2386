// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/FaceSources.h"

#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index PieceSize = 256;
constexpr double Anywhere = std::numeric_limits<double>::infinity();

double LargestRoot(const std::vector<double>& squares)
{
  const auto largest = std::max_element(squares.begin(), squares.end());
  return largest == squares.end() ? 0.0 : std::sqrt(*largest);
}
}

PointSources SourcesOf(
  const PreparedSurface& prepared, const ClosestPoints& surface, const std::vector<Vector3>& points)
{
  PointSources sources;
  sources.Triangle.resize(points.size());
  sources.Weights.resize(points.size());
  ParallelFor(static_cast<Index>(points.size()), PieceSize,
    [&](Index begin, Index end)
    {
      Index last = None;
      for (Index v = begin; v < end; ++v)
      {
        const ClosestPoints::Answer at = surface.Find(points[v], Vector3::Zero(), Anywhere, last);
        last = at.Place;
        sources.Triangle[v] = prepared.InputTriangle(at.Triangle);
        sources.Weights[v] = prepared.InputWeights(at.Triangle, at.Weights);
      }
    });
  return sources;
}

FaceSources SourcesOf(const PreparedSurface& prepared, const ClosestPoints& surface,
  const std::vector<Vector3>& points, const std::vector<Faces::Face>& faces)
{
  FaceSources sources;
  sources.Triangle.resize(faces.size());
  std::vector<double> squaredDistance(faces.size());
  ParallelFor(static_cast<Index>(faces.size()), PieceSize,
    [&](Index begin, Index end)
    {
      Index last = None;
      for (Index f = begin; f < end; ++f)
      {
        const ClosestPoints::Answer at =
          surface.Find(MiddleOf(points, faces[f]), Vector3::Zero(), Anywhere, last);
        last = at.Place;
        sources.Triangle[f] = prepared.InputTriangle(at.Triangle);
        squaredDistance[f] = at.SquaredDistance;
      }
    });
  const std::vector<std::array<Index, 2>> edges = EdgesOf({ faces, {} });
  std::vector<double> ofEdges(edges.size());
  ParallelFor(static_cast<Index>(edges.size()), PieceSize,
    [&](Index begin, Index end)
    {
      Index last = None;
      for (Index e = begin; e < end; ++e)
      {
        const Vector3 middle = 0.5 * (points[edges[e][0]] + points[edges[e][1]]);
        const ClosestPoints::Answer at = surface.Find(middle, Vector3::Zero(), Anywhere, last);
        last = at.Place;
        ofEdges[e] = at.SquaredDistance;
      }
    });
  sources.LargestDistance = std::max(LargestRoot(squaredDistance), LargestRoot(ofEdges));
  return sources;
}

std::vector<double> DistancesTo(const std::vector<Vector3>& points,
  const std::vector<Faces::Face>& faces, const std::vector<Vector3>& places)
{
  if (faces.empty())
  {
    return std::vector<double>(places.size(), 0.0);
  }
  std::vector<ClosestPoints::Corners> triangles;
  triangles.reserve(4 * faces.size());
  for (const Faces::Face& face : faces)
  {
    const int size = Faces::Size(face);
    if (size == 3)
    {
      triangles.push_back({ points[face[0]], points[face[1]], points[face[2]] });
      continue;
    }
    const Vector3 middle = MiddleOf(points, face);
    for (int c = 0; c < size; ++c)
    {
      triangles.push_back({ points[face[c]], points[face[(c + 1) % size]], middle });
    }
  }
  const ClosestPoints mesh(std::move(triangles));
  std::vector<double> distance(places.size());
  ParallelFor(static_cast<Index>(places.size()), PieceSize,
    [&](Index begin, Index end)
    {
      Index last = None;
      for (Index p = begin; p < end; ++p)
      {
        const ClosestPoints::Answer at = mesh.Find(places[p], Vector3::Zero(), Anywhere, last);
        last = at.Place;
        distance[p] = std::sqrt(at.SquaredDistance);
      }
    });
  return distance;
}

double LargestDistance(const std::vector<Vector3>& places, const std::vector<Vector3>& points,
  const std::vector<Faces::Face>& faces)
{
  const std::vector<double> distance = DistancesTo(points, faces, places);
  return distance.empty() ? 0.0 : *std::max_element(distance.begin(), distance.end());
}
}
