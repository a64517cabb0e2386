// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_GivenField_h
#define DirectionFields_GivenField_h

#include "Geometry/SurfaceGeometry.h"
#include "Result.h"
#include "Surface.h"

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace DirectionFields
{
/// n directions at each point of a surface, as they are given: by arrays that a computation or a
/// file left.
struct PointDirections
{
  /// n.
  int Degree = 0;
  /// The k-th unit tangent vector at a point, k = 0 ... n-1, counter-clockwise about the normal.
  std::function<Vector3(Index point, int k)> Direction;
  /// |u|, the weight of a point's directions against those of its neighbours.
  std::function<double(Index point)> Magnitude;
};

/// The directions of a field that was computed, which must outlive them. Magnitude is |u|.
PointDirections DirectionsOf(const Result& field);

/// The directions of an array, which must outlive them. Magnitude is 1; vectors that are zero or
/// not finite are no directions. Throws std::invalid_argument where the number of vectors is no
/// multiple of the degree.
/// @param degree  n, at least 1
/// @param vectors n for each point, one point after the other, in space, of any length;
///                counter-clockwise about the normal, 2 pi / n apart
PointDirections DirectionsOf(int degree, const std::vector<Vector3>& vectors);

/// The position of a triangle in space, for results that are computed on the triangle laid flat.
struct TriangleInSpace
{
  /// Of the mesh's corners 0, 1, 2.
  std::array<Vector3, 3> Corners;
  /// Unit vectors: along the edge from corner 0 to corner 1, to its left, and upright on both. The
  /// normal is that of the mesh's winding. A triangle without area has those of the first corner
  /// that has any.
  Vector3 X, Y, Normal;

  Vector3 Position(const std::array<double, 3>& weights) const
  {
    return weights[0] * this->Corners[0] + weights[1] * this->Corners[1] +
      weights[2] * this->Corners[2];
  }
  /// The vector of a complex number of the flat triangle.
  Vector3 Direction(const Complex& z) const { return z.real() * this->X + z.imag() * this->Y; }
};
TriangleInSpace InSpace(const SurfaceGeometry& geometry, Index meshTriangle);

/// A surface as the computation of a field sees it, whatever the field: the mesh with its geometry,
/// and how it belongs to the surface's own triangles. Points across seams are one, as for Direction
/// Field by default. Triangles with ids of no point or with coordinates that are not finite are
/// left out.
struct FieldSurface
{
  /// Takes linear time, on the threads of the scope. Throws MeshError for coordinates
  /// beyond 1e300, which are too large to compute with.
  /// @param joinsSeams false: points across seams stay apart
  explicit FieldSurface(const Surface& surface, bool joinsSeams = true);

  /// For each point the one that stands for it in the mesh; empty where each stands for itself.
  std::vector<Index> FirstPoint;
  std::unique_ptr<SurfaceGeometry> Geometry;
  /// The mesh's triangle, on the front, of each triangle of the surface; None for those ignored.
  std::vector<Index> MeshTriangle;
};

/// A direction field read back from directions at the points of a surface: the mesh that the field
/// was computed on with its geometry, and the representation vector of each vertex. Every algorithm
/// that follows or compares fields starts from here, and hence sees the same field, be it computed
/// here or read from a file.
///
/// Points across seams become one where the directions at them are the same; else the seams stay,
/// as for a field that was computed with MergePoints off.
class GivenField
{
public:
  /// Takes linear time, on the threads of the scope. Throws MeshError as FieldSurface.
  /// @param surface   must outlive this
  /// @param directions are not asked for points that no triangle uses
  GivenField(const Surface& surface, const PointDirections& directions);
  /// @param made of the surface, for many fields on it
  GivenField(const Surface& surface, std::shared_ptr<const FieldSurface> made,
    const PointDirections& directions);
  GivenField(const GivenField&) = delete;
  GivenField& operator=(const GivenField&) = delete;

  const Surface& GetSurface() const { return this->Input; }
  const SurfaceGeometry& GetGeometry() const { return *this->Made->Geometry; }
  const TriangleMesh& GetMesh() const { return this->Made->Geometry->Mesh; }
  int GetDegree() const { return this->Degree; }
  /// u of each vertex; 0 where no directions are given, or none that are tangent and finite.
  const std::vector<Complex>& GetSection() const { return this->Section; }
  /// Index of each triangle of the mesh, in units of 1/n.
  std::vector<int> Indices() const;

  /// FieldSurface::MeshTriangle.
  const std::vector<Index>& GetMeshTriangles() const { return this->Made->MeshTriangle; }
  /// The corner of a mesh triangle that is corner c of its triangle of the surface.
  int MeshCorner(Index meshTriangle, int c) const;
  /// The surface's point at the corner of a mesh triangle.
  Index PointAt(Index meshTriangle, int meshCorner) const;
  TriangleInSpace InSpace(Index meshTriangle) const
  {
    return DirectionFields::InSpace(this->GetGeometry(), meshTriangle);
  }

private:
  double LargestMagnitude(const PointDirections& directions) const;
  void ReadSection(const PointDirections& directions);
  /// Whether the directions at points that became one are the same.
  static bool SeamsAgree(const PointDirections& directions, const std::vector<Index>& first);

  const Surface& Input;
  int Degree;
  std::shared_ptr<const FieldSurface> Made;
  std::vector<Complex> Section;
};
}

#endif
