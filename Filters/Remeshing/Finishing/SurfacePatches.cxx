// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/SurfacePatches.h"

#include "Regions/FaceRegions.h"
#include "Soup/JoinedSets.h"
#include "Support/SortedEnds.h"
#include "Support/Threads.h"

#include <algorithm>
#include <map>

namespace DirectionFields::Internal
{
namespace
{
/// Points this near to a line, as a part of the wanted length, are on it.
constexpr double OnLine = 1e-6;
/// A triangle this near to a face is below it.
constexpr double Near = 0.25;

/// Whether a face looks to about the same side as the triangle of a patch below it.
bool LiesOn(const SurfacePatch& patch, const FaceMesh& mesh, const Faces::Face& face)
{
  constexpr double least = 0.8;
  const Index t = patch.Places.Find(MiddleOf(mesh.Points, face)).Triangle;
  const Vector3 area = AreaVector(mesh.Points, face);
  return t != None && patch.Normals[t].dot(area) >= least * patch.Normals[t].norm() * area.norm();
}

/// Tells which edges of the triangles are parts of lines.
class Walls
{
public:
  Walls(const PreparedSurface& surface, const FeatureLines& features, double edgeLength)
    : Points(surface.GetSurface()->Points)
    , Segments(SegmentsOf(surface, features))
    , Reach(OnLine * edgeLength)
    , IsNear(this->Points.size(), -1)
  {
  }

  bool Has(const std::array<Index, 2>& ends)
  {
    return this->IsPointNear(ends[0]) && this->IsPointNear(ends[1]) &&
      this->IsNearLine(0.5 * (this->Points[ends[0]] + this->Points[ends[1]]));
  }

private:
  static ClosestPoints SegmentsOf(const PreparedSurface& surface, const FeatureLines& features)
  {
    std::vector<ClosestPoints::Corners> segments;
    for (const FeatureLines::Chain& chain : features.Chains)
    {
      const std::vector<ClosestPoints::Corners> own =
        surface.SegmentsOf(surface.GetGeometry(), chain);
      segments.insert(segments.end(), own.begin(), own.end());
    }
    return ClosestPoints(std::move(segments));
  }

  bool IsNearLine(const Vector3& place) const
  {
    return this->Segments.Find(place, Vector3::Zero(), this->Reach).Triangle != None;
  }

  bool IsPointNear(Index p)
  {
    if (this->IsNear[p] < 0)
    {
      this->IsNear[p] = this->IsNearLine(this->Points[p]) ? 1 : 0;
    }
    return this->IsNear[p] != 0;
  }

  const std::vector<Vector3>& Points;
  ClosestPoints Segments;
  double Reach;
  /// -1 for those not asked for yet.
  std::vector<signed char> IsNear;
};
}

SurfacePatches::SurfacePatches(
  const PreparedSurface& surface, const FeatureLines& features, double edgeLength)
  : Reach(Near * edgeLength)
{
  const std::vector<Triangle> triangles = surface.GetUsedTriangles();
  const auto count = static_cast<Index>(triangles.size());
  std::map<std::array<Index, 2>, std::vector<Index>> at;
  for (Index t = 0; t < count; ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      at[SortedEnds(triangles[t][c], triangles[t][(c + 1) % 3])].push_back(t);
    }
  }
  Walls walls(surface, features, edgeLength);
  JoinedSets sets(count);
  for (const auto& [ends, beside] : at)
  {
    if (beside.size() == 2 && !walls.Has(ends))
    {
      sets.Join(beside[0], beside[1]);
    }
  }
  const std::vector<ClosestPoints::Corners> corners = surface.GetTriangles();
  std::vector<Index> number(count, None);
  std::vector<std::vector<ClosestPoints::Corners>> own;
  for (Index t = 0; t < count; ++t)
  {
    Index& patch = number[sets.Find(t)];
    if (patch == None)
    {
      patch = static_cast<Index>(own.size());
      own.emplace_back();
    }
    this->Patch.push_back(patch);
    own[patch].push_back(corners[t]);
  }
  for (std::vector<ClosestPoints::Corners>& of : own)
  {
    this->All.emplace_back(std::move(of));
  }
}

std::vector<Index> SurfacePatches::OfFaces(const FaceMesh& mesh, const ClosestPoints& surface) const
{
  std::vector<Index> closest;
  Index most = 0;
  for (const Faces::Face& face : mesh.Cells.Corners)
  {
    const Index t = surface.Find(MiddleOf(mesh.Points, face)).Triangle;
    closest.push_back(t == None ? 0 : t);
  }
  for (const FaceMesh::LineEdge& edge : mesh.LineEdges)
  {
    most = std::max(most, edge.Line);
  }
  std::vector<Index> patches =
    RegionsOfFaces(mesh, this->Patch, closest, std::vector<char>(most + 1, 1));
  std::vector<char> hasFaces(this->All.size(), 0);
  for (const Index patch : patches)
  {
    hasFaces[patch] = 1;
  }
  for (std::size_t f = 0; f < patches.size(); ++f)
  {
    const Index below = this->Patch[closest[f]];
    const bool isMissing =
      hasFaces[below] == 0 && LiesOn(this->All[below], mesh, mesh.Cells.Corners[f]);
    patches[f] = isMissing ? below : patches[f];
  }
  return patches;
}

std::vector<Index> SurfacePatches::OfVertices(
  const FaceMesh& mesh, const ClosestPoints& surface) const
{
  constexpr Index unknown = -2;
  const std::vector<Index> ofFaces = this->OfFaces(mesh, surface);
  std::vector<Index> patches(mesh.Points.size(), unknown);
  for (std::size_t f = 0; f < ofFaces.size(); ++f)
  {
    for (int c = 0; c < Faces::Size(mesh.Cells.Corners[f]); ++c)
    {
      Index& patch = patches[mesh.Cells.Corners[f][c]];
      patch = patch == unknown || patch == ofFaces[f] ? ofFaces[f] : None;
    }
  }
  for (std::size_t v = 0; v < patches.size(); ++v)
  {
    patches[v] = mesh.Vertices[v].Line != 0 || patches[v] == unknown ? None : patches[v];
  }
  return patches;
}

std::vector<Index> SurfacePatches::FindTurned(
  const FaceMesh& mesh, const ClosestPoints& surface) const
{
  const std::vector<Index> ofFaces = this->OfFaces(mesh, surface);
  std::vector<Index> turned;
  for (std::size_t f = 0; f < ofFaces.size(); ++f)
  {
    if (this->All[ofFaces[f]].IsTurned(mesh.Points, mesh.Cells.Corners[f], this->Reach))
    {
      turned.push_back(static_cast<Index>(f));
    }
  }
  return turned;
}

Index CountTurned(const FaceMesh& mesh, const PreparedSurface& prepared,
  const ClosestPoints& surface, const FeatureLines& features, double edgeLength,
  const SurfacePatches* patches)
{
  if (patches)
  {
    return static_cast<Index>(patches->FindTurned(mesh, surface).size());
  }
  const std::vector<ClosestPoints::Corners> corners = prepared.GetTriangles();
  std::vector<char> isOpposite(mesh.Cells.Corners.size(), 0);
  constexpr Index pieceSize = 256;
  ParallelFor(static_cast<Index>(isOpposite.size()), pieceSize,
    [&](Index begin, Index end)
    {
      for (Index f = begin; f < end; ++f)
      {
        const Faces::Face& face = mesh.Cells.Corners[f];
        const Index t = surface.Find(MiddleOf(mesh.Points, face)).Triangle;
        isOpposite[f] = t != None &&
            (corners[t][1] - corners[t][0])
                .cross(corners[t][2] - corners[t][0])
                .dot(AreaVector(mesh.Points, face)) < 0.0
          ? 1
          : 0;
      }
    });
  const bool isAny = std::find(isOpposite.begin(), isOpposite.end(), 1) != isOpposite.end();
  return isAny ? static_cast<Index>(
                   SurfacePatches(prepared, features, edgeLength).FindTurned(mesh, surface).size())
               : 0;
}
}
