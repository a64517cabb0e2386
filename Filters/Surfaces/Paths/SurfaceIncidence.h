// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SurfaceIncidence_h
#define DirectionFields_SurfaceIncidence_h

#include "Surface.h"
#include "Types.h"

#include <array>
#include <unordered_map>
#include <vector>

namespace DirectionFields::Internal
{
/// Which triangles of a surface meet at a point and along an edge, and their normals. For looking
/// at surfaces, not for computing on them: anything may be wrong with the surface, and triangles
/// that are unsound (ids of no point, coordinates that are not finite, no area) are as if they were
/// not there.
class SurfaceIncidence
{
public:
  /// The surface must outlive this.
  explicit SurfaceIncidence(const Surface& surface);

  const Surface& GetSurface() const { return *this->Mesh; }
  Index GetNumberOfPoints() const { return static_cast<Index>(this->Mesh->Points.size()); }
  Index GetNumberOfTriangles() const { return static_cast<Index>(this->Areas.size()); }

  /// Whether lengths are far enough from the largest and the least numbers for squares of areas. If
  /// not, sound triangles may pass for unsound: another unit of length is needed.
  bool HasUsualSize() const { return this->UsualSize; }

  /// 0 for unsound triangles.
  double Area(Index triangle) const { return this->Areas[triangle]; }
  /// Position of a corner of a triangle, 0 ... 2.
  const Vector3& Corner(Index triangle, int corner) const
  {
    return this->Mesh->Points[this->Mesh->Triangles[triangle][corner]];
  }
  /// Unit normal of a sound triangle, as it is wound.
  Vector3 Normal(Index triangle) const;

  /// Sound triangles at a point.
  const Index* BeginTriangles(Index point) const { return &this->Incident[this->First[point]]; }
  const Index* EndTriangles(Index point) const { return &this->Incident[this->First[point + 1]]; }
  bool IsUsed(Index point) const { return this->First[point] != this->First[point + 1]; }
  /// The corner of a triangle that is a point; None if none is.
  int FindCorner(Index triangle, Index point) const;
  /// Unit normal of a point: mean of the triangles' normals, weighted by corner angle. Zero where
  /// that vanishes, and at points that no sound triangle uses.
  Vector3 PointNormal(Index point) const;
  /// Length of the shortest edge of the sound triangles at a point, but at least a quarter of the
  /// mean of these edges.
  double ShortestEdge(Index point) const;

  /// The sound triangle beyond the edge from a corner to the next one; None on the boundary and
  /// where more than two triangles share the edge.
  Index Across(Index triangle, int corner) const;

private:
  Vector3 MeanNormal(Index point) const;

  const Surface* Mesh;
  bool UsualSize;
  std::vector<double> Areas;
  /// The sound triangles of point i: Incident[First[i]] ... Incident[First[i + 1] - 1].
  std::vector<std::size_t> First;
  std::vector<Index> Incident;
  /// Normals of points with many triangles: they would be summed up again for each path through one
  /// of these.
  std::unordered_map<Index, Vector3> NormalsOfLargeFans;
};

/// A point of a surface: the mean of a triangle's corners with these weights, which sum up to 1.
struct SurfacePoint
{
  Index Triangle = None;
  std::array<double, 3> Weights{};

  Vector3 Position(const SurfaceIncidence& surface) const
  {
    return this->Weights[0] * surface.Corner(this->Triangle, 0) +
      this->Weights[1] * surface.Corner(this->Triangle, 1) +
      this->Weights[2] * surface.Corner(this->Triangle, 2);
  }
};
}

#endif
