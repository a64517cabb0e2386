// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef ThesisAlgorithm_h
#define ThesisAlgorithm_h

#include "Surface.h"

/// The baseline that the solver is measured against: the smoothest field as C. Clemenz' thesis computes it, by a
/// sparse LDL^T factorization of A (Eigen's, columns ordered by AMD) and thirty inverse iterations
/// from a random start, whatever has been reached by then. Setup, matrices and indices are this
/// library's own.
struct ThesisAlgorithm
{
  explicit ThesisAlgorithm(const DirectionFields::Surface& surface, int degree);

  static constexpr int Iterations = 30;

  /// From the surface's arrays to the matrices.
  double SetupSeconds = 0.0;
  /// All, to the singularity indices.
  double Seconds = 0.0;
  /// The worst of the components.
  double Residual = 0.0;
  /// Of the first component, in 1 / length^2.
  double Eigenvalue = 0.0;
  int Singularities = 0;
};

#endif
