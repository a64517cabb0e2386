// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/FinishedFaces.h"

#include "Boundary/BoundaryEdits.h"
#include "Boundary/BoundaryLine.h"
#include "Dislocations/SizedRows.h"
#include "Finishing/FaceShaping.h"
#include "Finishing/FaceSources.h"
#include "Improvement/CloserLines.h"
#include "Improvement/FoldedQuads.h"
#include "PureQuads/InsertedRows.h"
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
/// What a mesh counts as at most that has faces turned over.
constexpr double OfTurned = -0.5;
/// How many times as many steps faces take that follow vertices moved along the boundary.
constexpr int FollowingSteps = 2;
/// How often edges of lines are split that stray from them.
constexpr int LineCutRounds = 3;
/// How close they come by moves. An edge of the wanted length does at circles with a radius of
/// about three lengths. Around smaller ones a vertex more gains little, and costs a triangle or two
/// and a good part of the least scaled Jacobian: edges are split only where a line has lost
/// vertices. Triangles that come of it are joined where quads alone are wanted, which takes room.
constexpr CloseLines Close = { 0.035, 0.08, 0.2 };
constexpr CloseLines CloseOfQuads = { 0.04, 0.08, 0.25 };

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

/// The patches that the vertices of a mesh keep to.
VertexPatches PatchesFor(const FaceMesh& mesh, const SurfaceContext& context)
{
  return context.Patches ? VertexPatches{ &context.Patches->GetAll(),
    context.Patches->OfVertices(mesh, context.Triangles) }
                         : VertexPatches();
}

/// Brings the edges of lines closer to them by moves and, this number of times, by cuts.
void BringLinesCloser(FaceMesh& mesh, int cuts, const CloseLines& close, double edgeLength,
  const SurfaceContext& context, const Progress& progress)
{
  for (int k = 0; k <= cuts; ++k)
  {
    const std::vector<double> wanted = WantedLengths(context, mesh.Points, edgeLength);
    const VertexStars stars(mesh.Cells, static_cast<Index>(mesh.Points.size()), mesh.LineEdges);
    SmoothingDomain domain{ context.Triangles, context.Lines, {}, wanted, close.MostStraying, true,
      PatchesFor(mesh, context) };
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

/// The ways in which the faces of one mesh are improved.
class Improvement
{
public:
  Improvement(FaceMesh& mesh, const FinishedFaces& wanted, const SurfaceContext& context)
    : Mesh(mesh)
    , Wanted(wanted)
    , Context(context)
    , HasCloseLines(wanted.Steps > 0 && context.HasCloseLines)
  {
    this->Settings.Steps = wanted.Steps;
    this->Settings.Degree = wanted.AreQuads ? 4 : 6;
    this->Settings.IsRough = context.IsRough;
    this->Settings.MostStraying =
      context.HasCloseLines && !wanted.IsPure ? Close.MostStraying : 0.0;
  }

  void Run(const Progress& progress)
  {
    const bool hasRows = this->Wanted.HasSizedRows && this->Wanted.AreQuads &&
      this->Wanted.Steps > 0 && this->Wanted.Spacing == BoundarySpacing::Free;
    const double beforeRows = hasRows ? 0.3 : 1.0;
    this->MakeRegular(progress.Part(0.0, beforeRows));
    if (hasRows)
    {
      this->AddRows(progress.Part(beforeRows, 1.0));
    }
  }

private:
  void MakeRegular(const Progress& progress)
  {
    // Quads are repaired once their triangles are joined.
    this->Settings.RepairsFaces = !this->Wanted.AreQuads;
    this->Settings.MayMakeTriangles = true;
    this->Shape(this->Settings, progress.Part(0.0, 0.4));
    this->Settings.RepairsFaces = true;
    if (!this->Wanted.AreQuads)
    {
      this->BringLinesCloser(LineCutRounds, progress.Part(0.4, 1.0));
      return;
    }
    if (this->Wanted.IsPure)
    {
      const double first = this->HasCloseLines ? 0.5 : 0.4;
      const double last = this->HasCloseLines ? 0.95 : 1.0;
      this->BringLinesCloser(LineCutRounds, progress.Part(0.4, first));
      this->JoinAll(progress.Part(first, last));
      this->BringLinesCloser(0, progress.Part(last, 1.0));
      return;
    }
    const double beforeLines = this->HasCloseLines ? 0.7 : 1.0;
    this->Settings.Joins = JoinPolicy::Free;
    this->Shape(this->Settings, progress.Part(0.4, beforeLines));
    this->BringLinesCloser(LineCutRounds, progress.Part(beforeLines, 1.0));
    CutFoldedQuads(this->Mesh.Cells, this->Mesh.Points);
  }

  /// Rows of quads begin and end where sizes need it.
  void AddRows(const Progress& progress)
  {
    const RowsDomain domain{ this->Context.Triangles, this->Context.Lines,
      [this](const std::vector<Vector3>& points)
      { return WantedLengths(this->Context, points, this->Wanted.EdgeLength); },
      [this](const FaceMesh& mesh) { return PatchesFor(mesh, this->Context); } };
    if (!AddSizedRows(this->Mesh, domain, progress.Part(0.0, 0.8)))
    {
      return;
    }
    ShapingSettings following = this->Settings;
    following.EditsFaces = false;
    following.Joins.reset();
    this->Shape(following, progress.Part(0.8, 0.9));
    this->BringLinesCloser(this->Wanted.IsPure ? 0 : LineCutRounds, progress.Part(0.9, 1.0));
    if (!this->Wanted.IsPure)
    {
      CutFoldedQuads(this->Mesh.Cells, this->Mesh.Points);
    }
  }

  void Shape(const ShapingSettings& settings, const Progress& part)
  {
    ShapeFaces(this->Mesh, settings, this->Context.Triangles, this->Context.Lines,
      WantedLengths(this->Context, this->Mesh.Points, this->Wanted.EdgeLength),
      PatchesFor(this->Mesh, this->Context), part);
  }

  void BringLinesCloser(int cuts, const Progress& part)
  {
    if (this->HasCloseLines)
    {
      Internal::BringLinesCloser(this->Mesh, cuts, this->Wanted.IsPure ? CloseOfQuads : Close,
        this->Wanted.EdgeLength, this->Context, part);
    }
  }

  /// The least scaled Jacobian, less where faces are turned over; of triangles, which are to go,
  /// -1.
  double Quality() const
  {
    const double least = LeastQuality(this->Mesh);
    const bool isTurned = this->Context.Patches &&
      !this->Context.Patches->FindTurned(this->Mesh, this->Context.Triangles).empty();
    return isTurned ? std::min(least, OfTurned) : least;
  }

  /// Keeps the mesh if it is the best one so far.
  void Consider(FaceMesh& best, double& most) const
  {
    const double quality = this->Quality();
    if (quality > most)
    {
      most = quality;
      best = this->Mesh;
    }
  }

  /// Makes quads of all triangles, as many as find another one.
  void JoinAll(const Progress& progress)
  {
    this->Settings.MayMakeTriangles = false;
    this->Settings.Joins = JoinPolicy::AtAnyPrice;
    ShapingSettings joining;
    joining.Joins = JoinPolicy::Cheap;
    FaceMesh best;
    double most = -2.0;
    for (int k = 0; k < Trials && most < Good; ++k)
    {
      const Progress part =
        progress.Part(static_cast<double>(k) / Trials, static_cast<double>(k + 1) / Trials);
      this->Shape(joining, part.Part(0.0, 0.2));
      EvenOutTriangles(this->Mesh, this->Wanted.Spacing != BoundarySpacing::Keep);
      FaceMesh even = k == 0 ? this->Mesh : FaceMesh();
      this->Shape(this->Settings, part.Part(0.2, 0.6));
      this->Consider(best, most);
      if (k == 0 && most<Good&& this->Wanted.Steps> 0)
      {
        std::swap(this->Mesh, even);
        this->JoinByRows(part.Part(0.6, 1.0));
        this->Consider(best, most);
        std::swap(this->Mesh, even);
      }
      CutFoldedQuads(this->Mesh.Cells, this->Mesh.Points, Good);
    }
    this->Mesh = std::move(best);
  }

  /// Joins triangles where faces are good then, and the others by rows of faces, which take no
  /// room along lines.
  void JoinByRows(const Progress& progress)
  {
    ShapingSettings joining;
    joining.Joins = JoinPolicy::Good;
    this->Shape(joining, progress.Part(0.0, 0.5));
    InsertRows(this->Mesh);
    ShapingSettings after = this->Settings;
    after.Joins.reset();
    this->Shape(after, progress.Part(0.5, 1.0));
  }

  FaceMesh& Mesh;
  const FinishedFaces& Wanted;
  const SurfaceContext& Context;
  bool HasCloseLines;
  ShapingSettings Settings;
};

void ImproveAll(FaceMesh& mesh, const FinishedFaces& wanted, const SurfaceContext& context,
  const Progress& progress)
{
  Improvement(mesh, wanted, context).Run(progress);
}

/// Makes faces with even edges along the boundary.
void SpaceAndImprove(FaceMesh& mesh, const std::vector<BoundaryLine>& lines,
  const FinishedFaces& wanted, const SurfaceContext& context, const Progress& progress)
{
  // The faces are made for these edges: those that are made for others have no room when the
  // vertices move there.
  SpaceBoundary(mesh, context.Input, lines, context.Sizes, true);
  ImproveAll(mesh, wanted, context, progress.Part(0.0, 0.8));
  Release(mesh);
  // Where lines were brought closer there are other numbers of edges now.
  SpaceBoundary(mesh, context.Input, lines, context.Sizes, true);
  ShapingSettings following;
  following.Steps = FollowingSteps * wanted.Steps;
  following.Degree = wanted.AreQuads ? 4 : 6;
  following.IsRough = context.IsRough;
  following.MayMakeTriangles = !wanted.IsPure;
  ShapeFaces(mesh, following, context.Triangles, context.Lines,
    WantedLengths(context, mesh.Points, wanted.EdgeLength), PatchesFor(mesh, context),
    progress.Part(0.8, 1.0));
  Release(mesh);
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
  SpaceAndImprove(mesh, lines, wanted, context, progress);
  figures.Points = BoundaryCount(mesh, context.Input, lines).Points;
  figures.Unevenness = UnevennessOf(mesh, context.Input, lines, context.Sizes);
  return figures;
}
}
