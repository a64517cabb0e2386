// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/FinishedFaces.h"

#include "Finishing/FaceShaping.h"
#include "Finishing/FaceSources.h"
#include "Improvement/FoldedQuads.h"
#include "PureQuads/QuadSplit.h"
#include "PureQuads/TriangleParity.h"

#include <algorithm>

namespace DirectionFields::Internal
{
namespace
{
/// The wanted length of edges at each point of a mesh.
std::vector<double> WantedLengths(
  const SurfaceContext& context, const std::vector<Vector3>& points, double edgeLength)
{
  std::vector<double> wanted(points.size(), edgeLength);
  if (!context.Sizes.empty())
  {
    const PointSources sources = SourcesOf(context.Prepared, context.Triangles, points);
    for (std::size_t v = 0; v < wanted.size(); ++v)
    {
      double size = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        size +=
          sources.Weights[v][c] * context.Sizes[context.Input.Triangles[sources.Triangle[v]][c]];
      }
      wanted[v] *= size;
    }
  }
  return wanted;
}
}

bool FinishFaces(FaceMesh& mesh, QuadPolicy policy, bool areQuads, int steps, double edgeLength,
  const SurfaceContext& context, const Progress& progress)
{
  const auto shape = [&](double length, ShapingSettings settings, const Progress& part)
  {
    ShapeFaces(mesh, settings, context.Triangles, context.Lines,
      WantedLengths(context, mesh.Points, length), part);
  };
  const bool isSplit = policy == QuadPolicy::Split;
  ShapingSettings settings{ steps, areQuads };
  settings.RepairsFaces = isSplit;
  settings.MayMakeTriangles = true;
  settings.IsDraft = isSplit;
  shape(isSplit ? 2.0 * edgeLength : edgeLength, settings, progress.Part(0.0, 0.4));
  if (!areQuads)
  {
    return true;
  }
  if (isSplit)
  {
    CutFoldedQuads(mesh.Cells, mesh.Points);
    SplitIntoQuads(mesh);
  }
  if (policy == QuadPolicy::Joined && !EvenOutTriangles(mesh))
  {
    return false;
  }
  settings.MayMakeTriangles = policy == QuadPolicy::Mixed;
  settings.JoinsTriangles = !isSplit;
  settings.IsDraft = false;
  settings.RepairsFaces = true;
  shape(edgeLength, settings, progress.Part(0.4, 1.0));
  if (policy == QuadPolicy::Mixed)
  {
    CutFoldedQuads(mesh.Cells, mesh.Points);
  }
  return policy == QuadPolicy::Mixed ||
    std::all_of(mesh.Cells.Corners.begin(), mesh.Cells.Corners.end(),
      [](const Faces::Face& face) { return Faces::Size(face) == 4; });
}
}
