// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MovableFaces_h
#define DirectionFields_MovableFaces_h

#include "Distance/ClosestPoints.h"
#include "FaceMesh/VertexStars.h"

#include <vector>

namespace DirectionFields::Internal
{
/// A part of a surface between lines.
struct SurfacePatch
{
  /// @param triangles of the part
  explicit SurfacePatch(std::vector<ClosestPoints::Corners> triangles);

  ClosestPoints Places;
  /// The area vectors of the triangles, and their sum; zero where they do not all look to one side.
  std::vector<Vector3> Normals;
  Vector3 Side = Vector3::Zero();

  /// Whether a face looks to the other side than the part below it.
  /// @param reach not so if a triangle looks to the face's side within this distance of its middle;
  ///              0 for any
  bool IsTurned(
    const std::vector<Vector3>& points, const Faces::Face& face, double reach = 0.0) const;
};

/// The parts of a surface that vertices keep to.
struct VertexPatches
{
  /// Null where there are none.
  const std::vector<SurfacePatch>* All = nullptr;
  /// The part of each vertex, or None for the whole surface; empty where there are no parts.
  std::vector<Index> Of = {};
};

/// The surface and the features on which vertices move.
struct SmoothingDomain
{
  /// The triangles of the surface, and the segments of each feature.
  const ClosestPoints& Surface;
  const std::vector<ClosestPoints>& Lines;
  /// The feature of each vertex, from 1 on; 0 for vertices that are free on the surface, -1 for
  /// vertices that do not move.
  std::vector<Index> Line;
  /// The wanted length of the edges at each vertex.
  std::vector<double> EdgeLength;
  /// How far edges of lines may stray from them, in wanted lengths: vertices of lines are spaced
  /// evenly, and none is taken out that they need for that. 0 for as far as it comes.
  double MostStraying = 0.0;
  /// Vertices do not move over lines: their way to the surface is along their normals.
  bool KeepsSides = false;
  /// Vertices that are free on the surface do not get over its lines.
  VertexPatches Patches = {};
  /// The surface is rougher than its faces can show: their middles are not near it anywhere.
  bool IsRough = false;
};

/// How far the edge between two places is from a line.
double Straying(const ClosestPoints& line, const Vector3& a, const Vector3& b);

/// Faces whose vertices move on a surface. All are shared.
class MovableFaces
{
public:
  MovableFaces(
    const VertexStars& faces, const SmoothingDomain& domain, std::vector<Vector3>& points)
    : Cells(faces)
    , Domain(domain)
    , Points(points)
    , Nearest(points.size(), None)
  {
  }

  Index GetNumberOfVertices() const { return static_cast<Index>(this->Points.size()); }
  Index GetNumberOfFaces() const { return this->Cells.GetNumberOfFaces(); }
  bool IsFree(Index v) const { return this->Domain.Line[v] >= 0 && !this->Cells.At(v).empty(); }
  /// It moves on the surface, not on a feature.
  bool IsOnSurface(Index v) const { return this->Domain.Line[v] == 0; }
  /// A vertex of more than 64 faces: repeated trials at it would take as long as all other faces.
  bool IsHub(Index v) const { return this->Cells.At(v).size() > 64; }
  bool IsFace(Index f) const { return this->Cells.IsFace(f); }
  const std::vector<Index>& FacesAt(Index v) const { return this->Cells.At(v); }
  const Faces::Face& Face(Index f) const { return this->Cells.Face(f); }
  double EdgeLength(Index v) const { return this->Domain.EdgeLength[v]; }
  std::vector<Vector3>& GetPoints() { return this->Points; }
  const std::vector<Vector3>& GetPoints() const { return this->Points; }

  /// The sum of the area vectors of the faces at a vertex.
  Vector3 NormalAt(Index v, const std::vector<Vector3>& points) const;
  /// The regular face of nearly the wanted size that is nearest to a face, and its area vector.
  struct Regular
  {
    std::array<Vector3, 4> Corners;
    Vector3 Area;
  };
  Regular RegularFace(Index f, const std::vector<Vector3>& points) const;
  /// The mean place that the faces at a vertex would give it if they were regular and nearly of the
  /// wanted size.
  Vector3 Ideal(Index v, const std::vector<Vector3>& points) const;
  /// The point of the surface, or of the vertex' feature, that is closest to a place; the vertex'
  /// own place if none is near.
  Vector3 Projected(Index v, const Vector3& place, const std::vector<Vector3>& points) const;
  /// Half the way to Ideal, projected, from the regular faces that are already known.
  Vector3 Relaxed(
    Index v, const std::vector<Vector3>& points, const std::vector<Regular>& regular) const;
  /// Moves each of these vertices, as far as it may move, half the way to Ideal, projected, one
  /// after the other, in this number of sweeps.
  void Relax(const std::vector<Index>& vertices, int times);
  /// The scaled Jacobian of a face, below 0 if it is turned over. Where lines are to stay close, a
  /// face in which a line turns little counts as flat: it would lie beside the surface, in the hole
  /// that the line goes around.
  double Quality(const Faces::Face& face) const;
  /// The least one of the faces at a vertex. Triangles whose normals oppose the others'
  /// count as negative.
  double LeastQuality(Index v) const;
  /// The distance of the middle of a face from the surface, in wanted lengths of edges; at most 1.
  /// 0 where the surface is rough.
  double Distance(Index f) const { return this->Distance(this->Cells.Face(f)); }
  double Distance(const Faces::Face& face) const;
  /// Whether a vertex of a line may be taken out between two others of it.
  bool MayLeaveLine(Index v, Index before, Index after) const;
  /// The largest one of the faces at a vertex.
  double LargestDistance(Index v) const;
  /// How far a place is from the faces at vertices, in lengths of edges at a vertex.
  double DistanceFrom(const std::vector<Index>& vertices, Index v, const Vector3& place) const;

private:
  const ClosestPoints& SurfaceAt(Index v) const
  {
    const VertexPatches& patches = this->Domain.Patches;
    const Index patch = patches.All ? patches.Of[v] : None;
    return patch == None ? this->Domain.Surface : (*patches.All)[patch].Places;
  }
  bool HasCloseLines() const { return this->Domain.MostStraying > 0.0; }
  /// Where lines are to stay close: a place on a line that is also drawn to the middle between its
  /// neighbours there, as an edge strays by the square of its length.
  Vector3 Spaced(Index v, const Vector3& ideal, const std::vector<Vector3>& points) const;
  Vector3 Projected(
    Index v, const Vector3& place, const Vector3& normal, const Vector3& otherwise) const;
  /// The patch of a face with a corner on a line; None where its vertices do not tell it.
  Index PatchOf(const Faces::Face& face) const;
  bool IsTurned(const Faces::Face& face) const;
  int CornerAt(Index f, Index v) const;

  const VertexStars& Cells;
  const SmoothingDomain& Domain;
  std::vector<Vector3>& Points;
  /// The triangle that each vertex was last on: the next one is near. Only the time depends on it.
  mutable std::vector<Index> Nearest;
};
}

#endif
