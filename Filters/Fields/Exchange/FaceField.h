// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FaceField_h
#define DirectionFields_FaceField_h

#include "Geometry/SurfaceGeometry.h"
#include "Interpolation/GivenField.h"

#include <array>
#include <vector>

namespace DirectionFields
{
/// A direction field that is constant on each triangle, as many programs know them.
struct FaceField
{
  /// n.
  int Degree = 0;
  /// The n-th power of the directions of each triangle of the mesh, of modulus 1, or 0 for none:
  /// they stand at the angles (arg + 2 pi k) / n from the edge from corner 0 to corner 1,
  /// counter-clockwise.
  std::vector<Complex> Power;
};

/// The directions of a field at the triangles' centroids, of the section that the energy integrates
/// (KCPS13, section 6.1). Where it vanishes at a centroid they are along the triangle's first edge.
FaceField AtCentroids(const GivenField& field);

/// The same at other places.
/// @param weights barycentric coordinates for the corners of each triangle of the surface
FaceField AtPlaces(const GivenField& field, const std::vector<std::array<double, 3>>& weights);

/// The face field that rows of vectors give, one row for each triangle of the surface: the mean of
/// the n-th powers of the directions of its vectors in the triangle's plane. Power is 0 where that
/// vanishes.
/// @param geometry of GivenField or FieldSurface
/// @param degree   n, at least 1
/// @param vectors  perRow vectors for each triangle of the surface that the mesh is of, in space,
///                 of any length; their directions count only
FaceField FromVectors(const SurfaceGeometry& geometry, int degree,
  const std::vector<Vector3>& vectors, std::size_t perRow);

/// The k-th direction in space of each triangle of the surface, k = 0 ... n-1: unit vectors in the
/// triangles' planes, counter-clockwise about the mesh's normals. Direction 0 is the one closest to
/// the x axis of space (the y axis where the normal is x), as for fields over points. Zero for
/// triangles that the mesh does not have.
std::vector<Vector3> DirectionsInSpace(const GivenField& field, const FaceField& faces, int k);

/// Index of each vertex of the mesh in units of 1/n, as programs find it that know the directions
/// on the faces only: each face's directions match those of the next one by the least rotation, and
/// the angles that these add up to around a vertex, and its curvature, make a multiple of 2 pi. On
/// a closed surface the sum is n times the Euler characteristic. 0 on the boundary. Where a power
/// is 0 it counts as 1.
std::vector<int> FaceSingularityIndices(const IntrinsicGeometry& geometry, const FaceField& faces);

/// The section over the vertices that is closest to a face field: the mean of the triangles'
/// powers, each carried from the centroid to the vertex along the straight line between them,
/// weighted by the triangles' angles there. Its modulus says how much these agree, from 0 to 1.
std::vector<Complex> ToVertices(const SurfaceGeometry& geometry, const FaceField& faces);
}

#endif
