// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Curvature_h
#define DirectionFields_Curvature_h

#include "Geometry/SurfaceGeometry.h"
#include "Mesh/PieceOfSurface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// What is to be known of the whole of a component of which a mesh may have a piece only.
struct WholeComponent
{
  /// It is closed and wound inside out.
  bool IsInsideOut = false;
  /// The largest rounding error of its coordinates, in units of the input.
  double RoundingError = 0.0;
};

/// Curvature of a mesh over its vertices. Lengths are in units of Metric::Unit. That of a closed
/// component whose triangles are wound inside out, so that its signed volume is negative, is taken
/// as seen from outside.
///
/// At most vertices it is that of quadrics that are fitted to their surroundings and averaged over
/// as much more of the surface as noise makes necessary (Curvature/ShapeFit.h, ShapeSmoothing.h),
/// together with the edges where that is much.
/// On creases, where the surface is bent and not curved, and where there are too few points for a
/// quadric, it is that of the edges, over a third of the incident area.
struct Curvature
{
  /// @param dihedralAngles of each edge
  /// @param rings          radius of the surroundings that curvature is averaged over, in edges; 0
  ///                       to find it
  Curvature(
    const SurfaceGeometry& geometry, const std::vector<double>& dihedralAngles, double rings = 0.0);
  /// That of a piece, right at its own vertices and at those that are next to them.
  /// @param wholes for each component of the mesh
  Curvature(const SurfaceGeometry& geometry, const std::vector<double>& dihedralAngles,
    double rings, const PieceOfSurface& piece, const std::vector<WholeComponent>& wholes);

  /// Hopf differential, a section of degree 2: (k_max - k_min) / 2 exp(2 i theta) with theta the
  /// direction of the larger signed curvature. On creases -1/4 sum over edges at i of exp(2 i
  /// theta_i(e)) beta_e |e| over the area (KCPS13, section 6.1.4). Zero where the rounding of the
  /// coordinates explains it.
  std::vector<Complex> Hopf;
  /// H, positive where the surface is convex. On creases half the length of the cotangent Laplacian
  /// of the positions over the area (Meyer et al. 2003); on the boundary the part along the normal.
  std::vector<double> Mean;
  /// K = H^2 - |q|^2; on creases the angle defect over the area, 0 on their boundary.
  std::vector<double> Gaussian;
  /// Some component is wound inside out.
  bool IsInsideOut = false;
};
}

#endif
