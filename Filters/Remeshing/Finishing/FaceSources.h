// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FaceSources_h
#define DirectionFields_FaceSources_h

#include "FaceMesh/Faces.h"
#include "Preparation/PreparedSurface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Where points are on a surface: a triangle of it each, and weights of its corners.
struct PointSources
{
  std::vector<Index> Triangle;
  std::vector<std::array<double, 3>> Weights;
};
/// @param surface the triangles that the surface uses
PointSources SourcesOf(const PreparedSurface& prepared, const ClosestPoints& surface,
  const std::vector<Vector3>& points);

/// The triangle of the surface closest to the center of each face, and the largest distance of the
/// center of a face or the middle of an edge from the surface.
struct FaceSources
{
  std::vector<Index> Triangle;
  double LargestDistance = 0.0;
};
FaceSources SourcesOf(const PreparedSurface& prepared, const ClosestPoints& surface,
  const std::vector<Vector3>& points, const std::vector<Faces::Face>& faces);
/// The distance of each of some places from faces; quads are four triangles around their middle. 0
/// without faces.
std::vector<double> DistancesTo(const std::vector<Vector3>& points,
  const std::vector<Faces::Face>& faces, const std::vector<Vector3>& places);
/// The largest one of these.
double LargestDistance(const std::vector<Vector3>& places, const std::vector<Vector3>& points,
  const std::vector<Faces::Face>& faces);
}

#endif
