// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/FinishedFaces.h"

#include "Finishing/FaceShaping.h"
#include "Finishing/FaceSources.h"
#include "Improvement/FoldedQuads.h"
#include "PureQuads/TriangleParity.h"

#include <algorithm>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// With quads only, those whose scaled Jacobian is below this are cut into triangles, which are
/// joined anew, this number of times at most.
constexpr double Good = 0.2;
constexpr int Trials = 3;

/// The least scaled Jacobian; of triangles, which are to go, -1.
double LeastQuality(const FaceMesh& mesh)
{
  double least = 1.0;
  for (const Faces::Face& face : mesh.Cells.Corners)
  {
    const bool isQuad = Faces::Size(face) == 4;
    least = std::min(least, isQuad ? ScaledJacobian(mesh.Points, face) : -1.0);
  }
  return least;
}

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

void FinishFaces(FaceMesh& mesh, bool areQuads, bool isPure, int steps, double edgeLength,
  const SurfaceContext& context, const Progress& progress)
{
  const auto shape = [&](const ShapingSettings& settings, const Progress& part)
  {
    ShapeFaces(mesh, settings, context.Triangles, context.Lines,
      WantedLengths(context, mesh.Points, edgeLength), part);
  };
  ShapingSettings settings;
  settings.Steps = steps;
  settings.AreQuads = areQuads;
  settings.RepairsFaces = false;
  settings.MayMakeTriangles = true;
  shape(settings, progress.Part(0.0, 0.4));
  if (!areQuads)
  {
    return;
  }
  settings.RepairsFaces = true;
  if (!isPure)
  {
    settings.Joins = JoinPolicy::Free;
    shape(settings, progress.Part(0.4, 1.0));
    CutFoldedQuads(mesh.Cells, mesh.Points);
    return;
  }
  settings.MayMakeTriangles = false;
  settings.Joins = JoinPolicy::AtAnyPrice;
  ShapingSettings joining;
  joining.Joins = JoinPolicy::Cheap;
  FaceMesh best;
  double most = -2.0;
  for (int k = 0; k < Trials && most < Good; ++k)
  {
    const Progress part = progress.Part(0.4 + 0.6 * k / Trials, 0.4 + 0.6 * (k + 1) / Trials);
    shape(joining, part.Part(0.0, 0.2));
    EvenOutTriangles(mesh);
    shape(settings, part.Part(0.2, 1.0));
    const double quality = LeastQuality(mesh);
    if (quality > most)
    {
      most = quality;
      best = mesh;
    }
    CutFoldedQuads(mesh.Cells, mesh.Points, Good);
  }
  mesh = std::move(best);
}
}
