// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SurfaceFigures_h
#define DirectionFields_SurfaceFigures_h

#include "Surface.h"

#include <limits>
#include <vector>

namespace DirectionFields
{
/// The size of a surface and the number of its singularities, without ghosts. The figures of a
/// surface in pieces are the sums over the pieces.
struct SurfaceFigures
{
  /// The box around the points of the triangles.
  Vector3 Lower = Vector3::Constant(std::numeric_limits<double>::max());
  Vector3 Upper = -Lower;
  /// In units of the square of the diagonal, so that no surface's area overflows or vanishes.
  double Area = 0.0;
  /// Triangles of positive and of negative index.
  Index Positive = 0;
  Index Negative = 0;

  /// The diagonal of the box; 0 for a box around nothing; never infinite.
  double Diagonal() const;
  /// Adds another piece.
  SurfaceFigures& operator+=(const SurfaceFigures& other);
};

/// @param indices the singularity index of each triangle; empty counts as zeros
SurfaceFigures FiguresOf(const Surface& surface, const std::vector<int>& indices);
}

#endif
