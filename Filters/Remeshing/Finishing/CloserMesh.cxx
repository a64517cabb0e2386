// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/CloserMesh.h"

#include <algorithm>

namespace DirectionFields::Internal
{
namespace
{
/// Faces that are good enough are as good as better ones.
constexpr double GoodEnough = 0.2;
/// By which factor a closer mesh has to be closer.
constexpr double Closer = 0.8;
/// Or its worst face better by this factor or usable for the first time, and by this much, if it is
/// not much farther away.
constexpr double Better = 2.0;
constexpr double LeastGain = 0.05;
}

double LeastQuality(const std::vector<Vector3>& points, const std::vector<Faces::Face>& faces)
{
  double least = 1.0;
  for (const Faces::Face& face : faces)
  {
    least = std::min(least, ScaledJacobian(points, face));
  }
  return least;
}

bool IsCloser(const MeshStanding& mesh, const MeshStanding& other)
{
  const double quality = std::min(mesh.LeastQuality, GoodEnough);
  const double former = std::min(other.LeastQuality, GoodEnough);
  const double farthest = std::max(mesh.Farthest, mesh.LeastDistance);
  const double before = std::max(other.Farthest, other.LeastDistance);
  const bool isBetter = quality > former + LeastGain &&
    (quality > Better * former || (former < LeastUsable && quality >= LeastUsable));
  return mesh.MissedHoles <= other.MissedHoles && mesh.KeptParts >= other.KeptParts &&
    quality >= former &&
    (farthest < Closer * before || (farthest < AboutAsClose * before && isBetter));
}
}
