// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Preparation/PreparedSurface.h"

#include "Charts/FeatureLines.h"
#include "Mesh/MergePoints.h"
#include "OwnField/SharpCorners.h"
#include "Preparation/ChosenSide.h"
#include "Preparation/RegionBorders.h"
#include "Preparation/SurfaceUnit.h"
#include "Refinement/FlatFlips.h"
#include "Refinement/LongEdges.h"
#include "Refinement/SmoothedPoints.h"
#include "Refinement/SplitTriangle.h"
#include "Refinement/Thinning.h"
#include "SoftFeatures/Roughness.h"
#include "SoftFeatures/SoftFeatures.h"
#include "Support/SortedEnds.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace DirectionFields::Internal
{
PreparedSurface::PreparedSurface(const Surface& input, int degree, const KeptEdges& kept,
  const WorkingLengths& lengths, const Progress& progress)
  : AreFeaturesFixed(!lengths.Decimated.empty())
  , HasHard(kept.HasHard())
  , Points(kept.Points)
{
  MergedMesh merged = MergedMesh::AcrossSeams(input);
  progress.Report(0.2);
  this->Repaired = merged.Mesh.GetRepairs();
  for (std::size_t p = 0; p < merged.FirstPoint.size(); ++p)
  {
    this->Repaired.MergedPoints += merged.FirstPoint[p] != static_cast<Index>(p) ? 1 : 0;
  }
  const auto surface = std::make_shared<Surface>(this->CutOpen(input, merged));
  this->Prepared = surface;
  std::vector<Index> own;
  for (std::size_t t = 0; !kept.Regions.empty() && t < this->Used.size(); ++t)
  {
    own.push_back(kept.Regions[this->Used[t].Input]);
  }
  if (this->AreFeaturesFixed)
  {
    const bool isCut = surface->Points.size() > input.Points.size();
    if (isCut)
    {
      merged = MergedMesh{ {}, TriangleMesh(*surface) };
    }
    const SurfaceGeometry geometry(std::move(merged.Mesh), *surface);
    std::vector<char> isHard = EdgesBetween(geometry.Mesh, isCut ? own : kept.Regions);
    this->Stairs = DropStairs(geometry, isHard, lengths.Face);
    AddCurves(geometry.Mesh, kept.Curves, this->GetOriginals(), isHard);
    progress.Report(0.3);
    surface->Triangles =
      this->Decimated(geometry, kept, isHard, lengths, *surface, progress.Part(0.3, 0.9));
    this->Geometry = std::make_unique<const SurfaceGeometry>(*surface);
    this->IsNoisy = Internal::IsRough(*this->Geometry);
  }
  else
  {
    this->Geometry = std::make_unique<const SurfaceGeometry>(*surface);
    this->IsNoisy = Internal::IsRough(*this->Geometry);
    std::vector<char> isHard = EdgesBetween(this->Geometry->Mesh, own);
    this->Stairs = DropStairs(*this->Geometry, isHard, lengths.Face);
    AddCurves(this->Geometry->Mesh, kept.Curves, this->GetOriginals(), isHard);
    // Which of them are too short for a mesh depends on the wanted length.
    KeptEdges ofAnyLength = kept;
    ofAnyLength.Features.ShortestChain = 0.0;
    const AllFeatures features = this->FindAll(*this->Geometry, ofAnyLength, isHard, lengths);
    this->AreFeaturesFixed = this->IsNoisy || this->IsInNoise;
    this->Paths = FeaturePaths(this->Geometry->Mesh,
      this->AreFeaturesFixed ? features.All : std::vector<char>(), isHard, features.Soft.IsRim);
    if (this->IsInNoise)
    {
      this->SmoothLines(this->Geometry->Mesh, features.All, isHard, *surface);
      this->Geometry = std::make_unique<const SurfaceGeometry>(*surface);
    }
  }
  this->Refine(*surface, kept.Features, lengths);
  this->SplitInSharpCorners(*surface, degree, kept.Features, lengths.Face);
  constexpr int mostRounds = 4;
  bool isSplit = true;
  for (int k = 0; k < mostRounds && isSplit; ++k)
  {
    isSplit = this->SplitBetweenFrameless(*surface, degree, kept.Features);
  }
}

void PreparedSurface::Refine(
  Surface& surface, const FeatureSettings& settings, const WorkingLengths& lengths)
{
  // Each halves the longest edges.
  constexpr int mostRounds = 20;
  // Triangles between sharp edges of noise are no facets.
  const bool isOfPlanes = !this->IsNoisy && IsMostlyFlat(*this->Geometry);
  if (lengths.Split.empty() || !(lengths.HasNeedles || isOfPlanes))
  {
    return;
  }
  Index room = lengths.MostMiddles;
  for (int k = 0; k < mostRounds && room > 0; ++k)
  {
    const std::vector<double> longest = this->Continued(lengths.Split);
    const auto findLong = [&] { return FindLongEdges(*this->Geometry, longest, room); };
    const auto none = [](const std::vector<char>& flags)
    { return std::none_of(flags.begin(), flags.end(), [](char flag) { return flag != 0; }); };
    if (none(findLong()))
    {
      return;
    }
    surface.Triangles = FlipFlat(*this->Geometry, this->FindFeatures(settings), longest);
    this->Geometry = std::make_unique<const SurfaceGeometry>(surface);
    const auto before = static_cast<Index>(surface.Points.size());
    if (!this->Split(surface, findLong()))
    {
      return;
    }
    this->HasLongSplit = true;
    room -= static_cast<Index>(surface.Points.size()) - before;
    if (lengths.HasNeedles)
    {
      surface.Triangles = ThinInside(*this->Geometry, this->FindFeatures(settings),
        this->Continued(lengths.Split), this->StayAt(this->Geometry->Mesh));
      this->Geometry = std::make_unique<const SurfaceGeometry>(surface);
    }
  }
}

std::vector<Vector3> PreparedSurface::GetGivenPositions() const
{
  std::vector<Vector3> positions = this->Geometry->Positions;
  for (std::size_t v = 0; !this->GivenPoints.empty() && v < positions.size(); ++v)
  {
    positions[v] = this->GivenPoints[this->Geometry->Mesh.Point(static_cast<Index>(v))];
  }
  return positions;
}

void PreparedSurface::SmoothLines(const TriangleMesh& mesh, const std::vector<char>& isFeature,
  const std::vector<char>& isHard, Surface& surface)
{
  constexpr int steps = 8;
  this->GivenPoints = surface.Points;
  surface.Points = WithSmoothLines(mesh, std::move(surface.Points), isFeature, isHard, steps);
}

void PreparedSurface::Smooth(const std::vector<char>& isFeature, int steps)
{
  if (this->GivenPoints.empty())
  {
    this->GivenPoints = this->Prepared->Points;
  }
  const auto smooth = std::make_shared<Surface>(*this->Prepared);
  smooth->Points = SmoothedPoints(*this->Geometry, std::move(smooth->Points), isFeature, steps);
  this->MoveTo(smooth);
}

Surface PreparedSurface::CutOpen(const Surface& input, const MergedMesh& merged)
{
  const TriangleMesh& mesh = merged.Mesh;
  Surface surface;
  surface.Points = input.Points;
  // The points of a one-sided surface are there twice where triangles from different sides of its
  // double cover meet.
  std::vector<Index> otherSide;
  const auto pointOf = [&](Index v)
  {
    const Index p = mesh.Point(v);
    if (mesh.IsFrontVertex(v))
    {
      return p;
    }
    otherSide.resize(input.Points.size(), None);
    if (otherSide[p] == None)
    {
      otherSide[p] = static_cast<Index>(surface.Points.size());
      surface.Points.push_back(input.Points[p]);
      this->Middles.push_back({ p, p });
    }
    return otherSide[p];
  };
  const std::vector<char> isChosen = ChosenSide(mesh, input.Points);
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    if (isChosen[t] != 0)
    {
      this->Used.push_back(UsedTriangle::Of(t, input, merged));
      surface.Triangles.push_back({ pointOf(mesh.Tail(3 * t)), pointOf(mesh.Tail(3 * t + 1)),
        pointOf(mesh.Tail(3 * t + 2)) });
    }
  }
  return surface;
}

PreparedSurface::UsedTriangle PreparedSurface::UsedTriangle::Of(
  Index t, const Surface& input, const MergedMesh& merged)
{
  const TriangleMesh& mesh = merged.Mesh;
  UsedTriangle used{ {}, mesh.InputTriangle(t), {} };
  for (int c = 0; c < 3; ++c)
  {
    used.Points[c] = mesh.Point(mesh.Tail(3 * t + c));
    for (int k = 0; k < 3; ++k)
    {
      const Index point = input.Triangles[used.Input][k];
      if ((merged.FirstPoint.empty() ? point : merged.FirstPoint[point]) == used.Points[c])
      {
        used.InputCorner[c] = k;
      }
    }
  }
  return used;
}

std::vector<Triangle> PreparedSurface::Decimated(const SurfaceGeometry& geometry,
  const KeptEdges& kept, const std::vector<char>& isHard, const WorkingLengths& lengths,
  Surface& surface, const Progress& progress)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const AllFeatures features = this->FindAll(geometry, kept, isHard, lengths);
  if (this->IsInNoise)
  {
    this->SmoothLines(mesh, features.All, isHard, surface);
  }
  progress.Report(0.15);
  const Decimation::Limits limits = DecimationLimits(
    geometry, this->Continued(lengths.Decimated), lengths.HasNeedles, this->StayAt(mesh));
  Decimation decimation(mesh, geometry.Positions, features.All, limits);
  decimation.Run(progress.Part(0.15, 1.0));
  this->Paths = FeaturePaths(mesh, features.All, decimation, isHard, features.Soft.IsRim);
  return TrianglesLeft(mesh, decimation);
}

AllFeatures PreparedSurface::FindAll(const SurfaceGeometry& geometry, const KeptEdges& kept,
  const std::vector<char>& isHard, const WorkingLengths& lengths)
{
  AllFeatures features =
    FindAllFeatures(geometry, kept.Features, isHard, lengths.Face, kept.SoftRoom);
  this->HasSoftFeatures = !features.Soft.IsRim.empty();
  this->DoRimsNeedRoom = features.Soft.DependsOnRoom;
  this->IsInNoise = features.AreInNoise;
  return features;
}

std::vector<char> PreparedSurface::FindFeatures(const FeatureSettings& settings) const
{
  if (!this->AreFeaturesFixed)
  {
    return Internal::FindFeatures(*this->Geometry, settings, this->FindHardAndSoft());
  }
  const TriangleMesh& mesh = this->Geometry->Mesh;
  std::vector<char> isFeature(mesh.GetNumberOfEdges(), 0);
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = mesh.HalfEdge(e);
    isFeature[e] = mesh.Twin(h) != None &&
        this->Paths.Find(mesh.Point(mesh.Tail(h)), mesh.Point(mesh.Head(h))) != nullptr
      ? 1
      : 0;
  }
  DropShortFeatures(*this->Geometry, settings, isFeature, this->FindHardAndSoft());
  return isFeature;
}

std::vector<char> PreparedSurface::FindHardAndSoft() const
{
  return this->HasHard || this->HasSoftFeatures ? this->Paths.FindHardAndSoft(this->Geometry->Mesh)
                                                : std::vector<char>();
}

std::vector<char> PreparedSurface::FindHard() const
{
  return this->HasHard ? this->Paths.FindHard(this->Geometry->Mesh) : std::vector<char>();
}

std::vector<char> PreparedSurface::StayAt(const TriangleMesh& mesh) const
{
  std::vector<char> stays;
  if (!this->Points.empty())
  {
    const std::vector<Index> original = this->GetOriginals();
    for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      stays.push_back(
        std::binary_search(this->Points.begin(), this->Points.end(), original[mesh.Point(v)]) ? 1
                                                                                              : 0);
    }
  }
  return stays;
}

std::vector<Index> PreparedSurface::FindPointVertices() const
{
  const std::vector<char> stays = this->StayAt(this->Geometry->Mesh);
  std::vector<Index> vertices;
  for (std::size_t v = 0; v < stays.size(); ++v)
  {
    if (stays[v] != 0)
    {
      vertices.push_back(static_cast<Index>(v));
    }
  }
  return vertices;
}

std::vector<Index> PreparedSurface::FindPoints() const
{
  const std::vector<char> stays = this->StayAt(this->Geometry->Mesh);
  const std::vector<Index> original = stays.empty() ? std::vector<Index>() : this->GetOriginals();
  std::vector<Index> points(stays.size(), None);
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    points[v] = stays[v] != 0 ? original[this->Geometry->Mesh.Point(static_cast<Index>(v))] : None;
  }
  return points;
}

std::vector<Index> PreparedSurface::GetOriginals() const
{
  std::vector<Index> original(this->Prepared->Points.size());
  std::iota(original.begin(), original.end(), 0);
  const std::size_t first = original.size() - this->Middles.size();
  // The two sides of a line that was cut open have middles of their own.
  MiddlePoints firstOf;
  for (std::size_t k = 0; k < this->Middles.size(); ++k)
  {
    const Index a = original[this->Middles[k][0]];
    const Index b = original[this->Middles[k][1]];
    const auto point = static_cast<Index>(first + k);
    original[point] = a == b ? a : firstOf.emplace(SortedEnds(a, b), point).first->second;
  }
  return original;
}

std::vector<Index> PreparedSurface::PathAlong(Index p, Index q) const
{
  const FeaturePaths::Path* path = this->Paths.Find(p, q);
  if (path == nullptr)
  {
    return { p, q };
  }
  return path->Points.front() == p ? path->Points
                                   : std::vector<Index>(path->Points.rbegin(), path->Points.rend());
}

std::vector<ClosestPoints::Corners> PreparedSurface::SegmentsOf(
  const SurfaceGeometry& geometry, const FeatureLines::Chain& chain) const
{
  const std::vector<Vector3>& points = this->Prepared->Points;
  std::vector<ClosestPoints::Corners> segments;
  for (const FeatureLines::Step& step : chain.Steps)
  {
    const std::vector<Index> path =
      this->PathAlong(geometry.Mesh.Point(FeatureLines::Start(geometry.Mesh, step)),
        geometry.Mesh.Point(FeatureLines::End(geometry.Mesh, step)));
    for (std::size_t k = 0; k + 1 < path.size(); ++k)
    {
      segments.push_back({ points[path[k]], points[path[k + 1]], points[path[k + 1]] });
    }
  }
  return segments;
}

std::vector<ClosestPoints> PreparedSurface::LinesOf(
  const SurfaceGeometry& geometry, const FeatureLines& features) const
{
  std::vector<ClosestPoints> lines;
  for (const FeatureLines::Chain& chain : features.Chains)
  {
    lines.emplace_back(this->SegmentsOf(geometry, chain));
  }
  return lines;
}

std::vector<ClosestPoints::Corners> PreparedSurface::CornersOn(
  const std::vector<Vector3>& points) const
{
  std::vector<ClosestPoints::Corners> triangles;
  triangles.reserve(this->Used.size());
  for (const UsedTriangle& used : this->Used)
  {
    triangles.push_back({ points[used.Points[0]], points[used.Points[1]], points[used.Points[2]] });
  }
  return triangles;
}

PreparedSurface::MiddlePoints PreparedSurface::AddMiddles(
  Surface& surface, const std::vector<char>& isSplit)
{
  const TriangleMesh& mesh = this->Geometry->Mesh;
  MiddlePoints middles;
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = mesh.HalfEdge(e);
    if (isSplit[e] == 0)
    {
      continue;
    }
    const std::array<Index, 2> ends = EndsOf(mesh, h);
    if (middles.emplace(ends, static_cast<Index>(surface.Points.size())).second)
    {
      const Index onPath = this->Paths.MiddleOf(ends[0], ends[1]);
      surface.Points.push_back(onPath != None
          ? surface.Points[onPath]
          : Vector3(0.5 * surface.Points[ends[0]] + 0.5 * surface.Points[ends[1]]));
      if (!this->GivenPoints.empty())
      {
        this->GivenPoints.push_back(onPath != None
            ? this->GivenPoints[onPath]
            : Vector3(0.5 * this->GivenPoints[ends[0]] + 0.5 * this->GivenPoints[ends[1]]));
      }
      this->Middles.push_back(ends);
    }
  }
  return middles;
}

void PreparedSurface::SplitInSharpCorners(
  Surface& surface, int degree, const FeatureSettings& settings, double face)
{
  if (face > 0.0)
  {
    const SharpCorners corners(*this->Geometry, degree, this->FindFeatures(settings), face);
    this->Split(surface, corners.IsChord);
  }
}

bool PreparedSurface::SplitBetweenFrameless(
  Surface& surface, int degree, const FeatureSettings& settings)
{
  const TriangleMesh& mesh = this->Geometry->Mesh;
  const std::vector<char> isFrameless =
    FramelessVertices(*this->Geometry, degree, this->FindFeatures(settings));
  std::vector<char> isSplit(mesh.GetNumberOfEdges(), 0);
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = mesh.HalfEdge(e);
    isSplit[e] = isFrameless[mesh.Tail(h)] != 0 && isFrameless[mesh.Head(h)] != 0 ? 1 : 0;
  }
  return this->Split(surface, isSplit);
}

bool PreparedSurface::Split(Surface& surface, const std::vector<char>& isSplit)
{
  const TriangleMesh& mesh = this->Geometry->Mesh;
  const MiddlePoints middles = this->AddMiddles(surface, isSplit);
  if (middles.empty())
  {
    return false;
  }
  std::vector<Triangle> triangles;
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    if (mesh.IsFront(t))
    {
      SplitTriangle(mesh, t, middles).Cut(triangles);
    }
  }
  surface.Triangles = std::move(triangles);
  std::vector<FeaturePaths::Split> splits;
  for (const auto& [ends, point] : middles)
  {
    splits.push_back({ ends, point });
  }
  this->Paths.Halve(splits);
  this->Geometry = std::make_unique<const SurfaceGeometry>(surface);
  return true;
}
}
