// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/FaceSources.h"

#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index PieceSize = 256;
constexpr double Anywhere = std::numeric_limits<double>::infinity();
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
        const int size = Faces::Size(faces[f]);
        Vector3 middle = Vector3::Zero();
        for (int c = 0; c < size; ++c)
        {
          middle += points[faces[f][c]] / size;
        }
        const ClosestPoints::Answer at = surface.Find(middle, Vector3::Zero(), Anywhere, last);
        last = at.Place;
        sources.Triangle[f] = prepared.InputTriangle(at.Triangle);
        squaredDistance[f] = at.SquaredDistance;
      }
    });
  for (const double d : squaredDistance)
  {
    sources.LargestDistance = std::max(sources.LargestDistance, std::sqrt(d));
  }
  return sources;
}
}
