// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/FinishedFaces.h"

#include "Boundary/BoundaryEdits.h"
#include "Boundary/BoundaryLine.h"
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

void ImproveAll(FaceMesh& mesh, const FinishedFaces& wanted, const SurfaceContext& context,
  const Progress& progress)
{
  const auto shape = [&](const ShapingSettings& settings, const Progress& part)
  {
    ShapeFaces(mesh, settings, context.Triangles, context.Lines,
      WantedLengths(context, mesh.Points, wanted.EdgeLength), part);
  };
  ShapingSettings settings;
  settings.Steps = wanted.Steps;
  settings.AreQuads = wanted.AreQuads;
  settings.RepairsFaces = false;
  settings.MayMakeTriangles = true;
  shape(settings, progress.Part(0.0, 0.4));
  if (!wanted.AreQuads)
  {
    return;
  }
  settings.RepairsFaces = true;
  if (!wanted.IsPure)
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
    EvenOutTriangles(mesh, wanted.Spacing != BoundarySpacing::Keep);
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

BoundaryFigures FinishFaces(FaceMesh& mesh, const FinishedFaces& wanted,
  const SurfaceContext& context, const Progress& progress)
{
  if (wanted.Spacing == BoundarySpacing::Free)
  {
    ImproveAll(mesh, wanted, context, progress);
    return {};
  }
  const std::vector<BoundaryLine> lines =
    BoundaryLinesOf(context.Input, context.Prepared.FindUsed(context.Input.Triangles.size()));
  BoundaryFigures figures;
  if (wanted.Spacing == BoundarySpacing::Keep)
  {
    TakeBoundary(mesh, context.Input, lines);
    ImproveAll(mesh, wanted, context, progress);
    Release(mesh);
    const BoundaryCount count(mesh, context.Input, lines);
    figures.Points = count.Points;
    figures.Kept = count.Kept;
    figures.Others = count.Others;
    return figures;
  }
  // The faces come near to what they will be first, and then go with the boundary.
  SpaceBoundary(mesh, context.Input, lines, context.Sizes, false);
  ImproveAll(mesh, wanted, context, progress.Part(0.0, 0.8));
  SpaceBoundary(mesh, context.Input, lines, context.Sizes, true);
  ShapingSettings following;
  following.Steps = wanted.Steps;
  following.AreQuads = false;
  ShapeFaces(mesh, following, context.Triangles, context.Lines,
    WantedLengths(context, mesh.Points, wanted.EdgeLength), progress.Part(0.8, 1.0));
  Release(mesh);
  figures.Points = BoundaryCount(mesh, context.Input, lines).Points;
  figures.Unevenness = UnevennessOf(mesh, context.Input, lines, context.Sizes);
  return figures;
}
}
