// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Improvement/FaceSmoothing.h"

#include "Improvement/ParallelSweep.h"
#include "Improvement/WorstFaces.h"
#include "Support/Threads.h"

namespace DirectionFields::Internal
{
namespace
{
constexpr Index PieceSize = 256;
constexpr int CarefulSweeps = 4;
/// Faces better than this may become worse.
constexpr double GoodEnough = 0.5;
/// Vertices with worse faces may jump.
constexpr double Bad = 0.3;

void Step(MovableFaces& faces, std::vector<MovableFaces::Regular>& regular)
{
  const std::vector<Vector3> old = faces.GetPoints();
  // Each face once, not at each of its corners.
  ParallelFor(faces.GetNumberOfFaces(), PieceSize,
    [&](Index begin, Index end)
    {
      for (Index f = begin; f < end; ++f)
      {
        if (faces.IsFace(f))
        {
          regular[f] = faces.RegularFace(f, old);
        }
      }
    });
  ParallelFor(faces.GetNumberOfVertices(), PieceSize,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        if (faces.IsFree(v))
        {
          faces.GetPoints()[v] = faces.Relaxed(v, old, regular);
        }
      }
    });
}

/// Moves a vertex if no face becomes worse that is not good.
void MoveCarefully(MovableFaces& faces, Index v)
{
  std::vector<Vector3>& points = faces.GetPoints();
  const double before = faces.LeastQuality(v);
  const Vector3 start = points[v];
  points[v] = faces.Projected(v, 0.5 * (start + faces.Ideal(v, points)), points);
  double now = faces.LeastQuality(v);
  if (now < before && now < GoodEnough)
  {
    points[v] = start;
    now = before;
  }
  if (now < Bad)
  {
    MoveToBetterPlace(faces, v, 1.0);
  }
}
}

void RelaxFaces(MovableFaces& faces, int steps, const Progress& progress)
{
  std::vector<MovableFaces::Regular> regular(faces.GetNumberOfFaces());
  for (int k = 0; k < steps; ++k)
  {
    Step(faces, regular);
    progress.Report((k + 1.0) / steps);
  }
}

void ImproveFaces(MovableFaces& faces, const Progress& progress)
{
  std::vector<Index> free;
  for (Index v = 0; v < faces.GetNumberOfVertices(); ++v)
  {
    if (faces.IsFree(v))
    {
      free.push_back(v);
    }
  }
  const ParallelSweep sweep(faces, free);
  for (int k = 0; k < CarefulSweeps; ++k)
  {
    sweep.Run([&](Index v) { MoveCarefully(faces, v); });
    progress.Report(0.5 * (k + 1) / CarefulSweeps);
  }
  ImproveWorstFaces(faces, progress.Part(0.5, 1.0));
}
}
