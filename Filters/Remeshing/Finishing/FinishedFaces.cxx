// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/FinishedFaces.h"

#include "Boundary/BoundaryEdits.h"
#include "Boundary/BoundaryLine.h"
#include "Finishing/FaceShaping.h"
#include "Finishing/FaceSources.h"
#include "Improvement/CloserLines.h"
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
/// How often edges of lines are split that stray from them.
constexpr int LineCutRounds = 3;
/// How close they come. An edge of the wanted length does at circles with a radius of about three
/// lengths. Triangles that come of it are joined where quads alone are wanted, which takes room.
constexpr CloseLines Close = { 0.035, 0.2 };
constexpr CloseLines CloseOfQuads = { 0.04, 0.25 };

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

/// Brings the edges of lines closer to them by moves and, this number of times, by cuts.
void BringLinesCloser(FaceMesh& mesh, int cuts, const CloseLines& close, double edgeLength,
  const SurfaceContext& context, const Progress& progress)
{
  for (int k = 0; k <= cuts; ++k)
  {
    const std::vector<double> wanted = WantedLengths(context, mesh.Points, edgeLength);
    const VertexStars stars(mesh.Cells, static_cast<Index>(mesh.Points.size()), mesh.LineEdges);
    SmoothingDomain domain{ context.Triangles, context.Lines, {}, wanted, close.MostStraying,
      true };
    for (const FaceMesh::Vertex& vertex : mesh.Vertices)
    {
      domain.Line.push_back(vertex.Line);
    }
    MovableFaces places(stars, domain, mesh.Points);
    SpaceLines(stars, places, domain, progress.Part(k / (cuts + 1.0), (k + 1.0) / (cuts + 1.0)));
    if (k == cuts || !SplitLines(mesh, context.Lines, wanted, close))
    {
      break;
    }
  }
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
  settings.MostStraying = context.HasCloseLines && !wanted.IsPure ? Close.MostStraying : 0.0;
  settings.RepairsFaces = false;
  settings.MayMakeTriangles = true;
  shape(settings, progress.Part(0.0, 0.4));
  const bool hasCloseLines = wanted.Steps > 0 && context.HasCloseLines;
  const auto bringLinesCloser = [&](int cuts, const Progress& part)
  {
    if (hasCloseLines)
    {
      BringLinesCloser(
        mesh, cuts, wanted.IsPure ? CloseOfQuads : Close, wanted.EdgeLength, context, part);
    }
  };
  if (!wanted.AreQuads)
  {
    bringLinesCloser(LineCutRounds, progress.Part(0.4, 1.0));
    return;
  }
  settings.RepairsFaces = true;
  if (!wanted.IsPure)
  {
    const double beforeLines = hasCloseLines ? 0.7 : 1.0;
    settings.Joins = JoinPolicy::Free;
    shape(settings, progress.Part(0.4, beforeLines));
    bringLinesCloser(LineCutRounds, progress.Part(beforeLines, 1.0));
    CutFoldedQuads(mesh.Cells, mesh.Points);
    return;
  }
  const double first = hasCloseLines ? 0.5 : 0.4;
  const double last = hasCloseLines ? 0.95 : 1.0;
  bringLinesCloser(LineCutRounds, progress.Part(0.4, first));
  const Progress trials = progress.Part(first, last);
  settings.MayMakeTriangles = false;
  settings.Joins = JoinPolicy::AtAnyPrice;
  ShapingSettings joining;
  joining.Joins = JoinPolicy::Cheap;
  FaceMesh best;
  double most = -2.0;
  for (int k = 0; k < Trials && most < Good; ++k)
  {
    const Progress part =
      trials.Part(static_cast<double>(k) / Trials, static_cast<double>(k + 1) / Trials);
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
  bringLinesCloser(0, progress.Part(last, 1.0));
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
