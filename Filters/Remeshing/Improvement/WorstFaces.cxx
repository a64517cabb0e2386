// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Improvement/WorstFaces.h"

#include "Improvement/ParallelSweep.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index PieceSize = 256;
constexpr int Rounds = 16;
/// The places that are tried shrink towards the vertex by this factor from round to round.
constexpr double Shrinking = 0.8;
/// Faces with at least this scaled Jacobian, and with centers this near to the surface in lengths
/// of edges, do not change.
constexpr double GoodQuality = 0.5;
constexpr double GoodDistance = 0.33;

/// Below 1 if a face at a vertex is not regular enough; else between 1 and 2, where all are good,
/// and higher the nearer their centers are to the surface.
constexpr double Best = 2.0;
double Score(const MovableFaces& faces, Index v)
{
  const double quality = faces.LeastQuality(v) / GoodQuality;
  if (quality < 1.0)
  {
    return quality;
  }
  const double distance = faces.LargestDistance(v);
  return 1.0 + (distance > GoodDistance ? GoodDistance / distance : 1.0);
}
}

void MoveToBetterPlace(MovableFaces& faces, Index v, double size)
{
  constexpr int directions = 12;
  std::vector<Vector3>& points = faces.GetPoints();
  const double before = faces.IsHub(v) ? Best : Score(faces, v);
  if (before >= Best)
  {
    return;
  }
  const Vector3 start = points[v];
  const Vector3 normal = faces.NormalAt(v, points).normalized();
  const Vector3 x = normal.unitOrthogonal();
  const Vector3 y = normal.cross(x);
  Vector3 best = start;
  double score = before;
  for (const double radius : { 0.1, 0.25 })
  {
    for (int k = 0; k < directions; ++k)
    {
      const double angle = 2.0 * Pi * k / directions;
      points[v] = start;
      points[v] = faces.Projected(v,
        start + size * radius * faces.EdgeLength(v) * (std::cos(angle) * x + std::sin(angle) * y),
        points);
      const double now = Score(faces, v);
      if (now > score)
      {
        score = now;
        best = points[v];
      }
    }
  }
  points[v] = best;
}

namespace
{
/// The vertices that may move of faces that are not good, ascending.
std::vector<Index> VerticesOfWorst(const MovableFaces& faces)
{
  std::vector<char> isBad(faces.GetNumberOfFaces(), 0);
  ParallelFor(faces.GetNumberOfFaces(), PieceSize,
    [&](Index begin, Index end)
    {
      for (Index f = begin; f < end; ++f)
      {
        isBad[f] = faces.IsFace(f) &&
            (ScaledJacobian(faces.GetPoints(), faces.Face(f)) < GoodQuality ||
              faces.Distance(f) > GoodDistance)
          ? 1
          : 0;
      }
    });
  std::vector<Index> vertices;
  for (Index f = 0; f < faces.GetNumberOfFaces(); ++f)
  {
    for (int c = 0; isBad[f] != 0 && c < Faces::Size(faces.Face(f)); ++c)
    {
      if (faces.IsFree(faces.Face(f)[c]))
      {
        vertices.push_back(faces.Face(f)[c]);
      }
    }
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}
}

void ImproveWorstFaces(MovableFaces& faces, const Progress& progress)
{
  const std::vector<Index> vertices = VerticesOfWorst(faces);
  const ParallelSweep sweep(faces, vertices);
  double size = 1.0;
  for (int k = 0; k < Rounds; ++k, size *= Shrinking)
  {
    sweep.Run([&](Index v) { MoveToBetterPlace(faces, v, size); });
    progress.Report((k + 1.0) / Rounds);
  }
}
}
