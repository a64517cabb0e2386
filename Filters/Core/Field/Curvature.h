// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Curvature_h
#define DirectionFields_Curvature_h

#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Discrete curvature of a mesh over its vertices. Lengths are in units of Metric::Unit.
struct Curvature
{
  /// @param dihedralAngles of each edge
  Curvature(const SurfaceGeometry& geometry, const std::vector<double>& dihedralAngles);

  /// Hopf differential, a section of degree 2: (k_max - k_min) / 2 exp(2 i theta) with theta the
  /// direction of the larger signed curvature. From M_2 q = q~, where
  /// q~_i = -1/4 sum over edges at i of exp(2 i theta_i(e)) beta_e |e| (KCPS13, section 6.1.4).
  std::vector<Complex> Hopf;
  /// H: half the length of the cotangent Laplacian of the positions over a third of the incident
  /// area, positive where the surface is convex (Meyer et al. 2003). On the boundary the part along
  /// the normal.
  std::vector<double> Mean;
  /// K: angle defect over a third of the incident area; 0 on the boundary.
  std::vector<double> Gaussian;
};
}

#endif
