// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Guidance_h
#define DirectionFields_Guidance_h

#include "Geometry/SurfaceGeometry.h"
#include "Options.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The user's vectors as a section of degree n over the vertices of the mesh: the n-th power of the
/// projected vector's direction times its length times its weight.
std::vector<Complex> GuidanceSection(
  const SurfaceGeometry& geometry, const Guidance& guidance, int degree);

/// The Hopf differential as a section of degree 2, towards the larger curvature or the smaller, or
/// q^2 / |q|, of degree 4.
std::vector<Complex> CurvatureSection(
  const std::vector<Complex>& hopf, int degree, CurvatureDirection direction);

/// Continues a section to vertices of its components where it is zero: each of them has a tenth of the
/// mean of those neighbours that are nearer to where it is not. That is next to nothing for a field that is
/// drawn to it, but gives the section itself directions.
void Continue(const SurfaceGeometry& geometry, int degree, std::vector<Complex>& section);

/// Sets a section to zero on components that cannot be oriented.
void ClearCovers(const TriangleMesh& mesh, std::vector<Complex>& section);

/// A point that has no guidance of its own takes that of the next point at the same place that has.
Guidance Merged(Guidance guidance, const std::vector<Index>& first);
}

#endif
