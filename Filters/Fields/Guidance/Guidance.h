// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Guidance_h
#define DirectionFields_Guidance_h

#include "Curvature/Curvature.h"
#include "Geometry/SurfaceGeometry.h"
#include "Mesh/PieceOfSurface.h"
#include "Options.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The user's vectors as a section of degree n over the vertices of the mesh: the n-th power of the
/// projected vector's direction times its length times its weight.
std::vector<Complex> GuidanceSection(
  const SurfaceGeometry& geometry, const Guidance& guidance, int degree);

/// The largest component of the finite vectors, and the largest finite weight: only ratios to them
/// count, so that squares and products neither overflow nor underflow.
struct GuidanceScale
{
  double Longest = 0.0;
  double Heaviest = 0.0;
};
GuidanceScale ScaleOf(const Guidance& guidance);
/// The same for a piece of a surface, in the scale of the whole.
std::vector<Complex> GuidanceSection(const SurfaceGeometry& geometry, const Guidance& guidance,
  int degree, const GuidanceScale& scale);

/// Guidance::Strengths at the vertices of the mesh, from 0 to 1; empty where all are 1.
std::vector<double> GuidanceStrengths(const TriangleMesh& mesh, const Guidance& guidance);

/// The guidance of a field of degree 2 or 4 at a vertex: q for the larger curvature, -q for the
/// smaller; e^(2 i theta) (|k_max| - |k_min|) / 2 for the one of larger modulus, which does not
/// depend on the side that the surface is seen from, and its negative for the other. For degree 4
/// it is q^2 / |q|.
Complex CurvatureValue(
  const Curvature& curvature, Index vertex, int degree, CurvatureDirection direction);

/// Whether the guidance depends on the side that the surface is seen from.
bool DependsOnSide(int degree, CurvatureDirection direction);

/// These values of all vertices.
std::vector<Complex> CurvatureSection(
  const Curvature& curvature, int degree, CurvatureDirection direction);

/// Continues a section to vertices of its components where it is zero: each of them has a tenth of
/// the mean of those neighbours that are nearer to where it is not. That is next to nothing for a
/// field that is drawn to it, but gives the section itself directions.
/// @param piece of which the mesh is a part; its own vertices get values, and those next to them
void Continue(const SurfaceGeometry& geometry, int degree, std::vector<Complex>& section,
  const PieceOfSurface& piece = PieceOfSurface());

/// Sets a section to zero on components that cannot be oriented.
void ClearCovers(const TriangleMesh& mesh, std::vector<Complex>& section);

/// A point that has no guidance of its own takes that of the next point at the same place that has.
Guidance Merged(Guidance guidance, const std::vector<Index>& first);
}

#endif
