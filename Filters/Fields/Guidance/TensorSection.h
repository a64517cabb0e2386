// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TensorSection_h
#define DirectionFields_TensorSection_h

#include "Curvature/ShapeFit.h"
#include "Geometry/SurfaceGeometry.h"
#include "Guidance/SurfaceTensors.h"
#include "Progress.h"
#include "Surface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The averaged tangential parts of tensors at the vertices of a mesh.
struct VertexTensors
{
  /// Throws std::invalid_argument for tensors that are not finite, with the place of the first, and
  /// Stopped.
  /// @param tensors have passed Check
  /// @param scale   as TensorGuidanceOptions::Scale
  VertexTensors(const SurfaceGeometry& geometry, const SurfaceTensors& tensors, double scale,
    const Progress& progress);

  /// q and H of each vertex in units of Unit, and the variance of the noise that is left in q.
  std::vector<Shape> Parts;
  /// The weight of each vertex, 0 where it is isotropic within noise and rounding.
  std::vector<double> Weights;
  double Unit = 1.0;
  /// As those of TensorGuidance.
  double IsotropicShare = 0.0;
  double AsymmetricPart = 0.0;
  double AcrossPart = 0.0;

private:
  void ReadPoints(const SurfaceGeometry& geometry, const SurfaceTensors& tensors);
  void ReadTriangles(const SurfaceGeometry& geometry, const SurfaceTensors& tensors);
  void Weigh(const SurfaceGeometry& geometry);
  /// Which vertices of a component are not isotropic within noise and rounding.
  std::vector<char> CountingOf(
    const TriangleMesh& mesh, const TriangleMesh::Component& component) const;

  /// The largest component at each vertex, and the size of the shear across the surface over that
  /// of the tensor.
  std::vector<double> Largest;
  std::vector<double> Across;
};

/// Throws std::invalid_argument for options out of their ranges, and for the wrong number of values
/// or components.
void Check(
  const Surface& surface, const SurfaceTensors& tensors, const TensorGuidanceOptions& options);

/// The line that a field of degree 2 follows at a vertex: a complex number whose angle is twice the
/// direction's, of modulus 0 to 1.
Complex LineOf(const Shape& part, TensorDirection direction);

/// The guidance of a field of degree 2 or 4: the power of the direction times the weight of each
/// vertex, the same on both sides of components that cannot be oriented.
std::vector<Complex> TensorSection(const SurfaceGeometry& geometry, const VertexTensors& tensors,
  int degree, TensorDirection direction);

/// The guidance and the principal values at points.
/// @param vertices of the points; None gives zeros
TensorGuidance AtPoints(const SurfaceGeometry& geometry, const VertexTensors& tensors,
  TensorDirection direction, const std::vector<Index>& vertices);
}

#endif
