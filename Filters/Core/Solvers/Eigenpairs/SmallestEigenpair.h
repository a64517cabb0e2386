// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SmallestEigenpair_h
#define DirectionFields_SmallestEigenpair_h

#include "Types.h"

#include <functional>

namespace DirectionFields
{
/// Smallest eigenpair of A u = lambda M u, A Hermitian positive semi-definite, M Hermitian positive
/// definite.
struct Eigenpair
{
  double Value = 0.0;
  /// u^* M u = 1.
  ComplexVector Vector;
  /// RelativeResidual of the pair.
  double Residual = 0.0;
  /// Solves with the factor; 0 where the dense solver was used.
  int Iterations = 0;
  bool Aborted = false;
};

struct EigenpairSettings
{
  /// Largest residual of a converged pair.
  double Tolerance = 1e-6;
  /// Most solves.
  int MaximumIterations = 200;
  /// The order of magnitude of the smallest eigenvalue of a typical surface. A shift by a small
  /// part of it makes the matrix definite where the smallest eigenvalue is 0.
  double Scale = 1.0;
};

/// ‖A u - lambda M u‖ / max(‖A u‖, 1e-7 ‖|A| |u|‖). The second norm takes over where lambda = 0 up to
/// rounding; there the residual is 0 if it is no more than rounding, 1e-14 ‖|A| |u|‖, itself.
/// @param residual, energy, terms the three norms
double RelativeResidual(double residual, double energy, double terms);
double RelativeResidual(
  const SparseMatrix& energy, const SparseMatrix& mass, const ComplexVector& u, double lambda);

/// Shift-and-invert Lanczos iteration in the inner product of M, fully orthogonalized and thickly
/// restarted (K. Wu and H. Simon, SIAM J. Matrix Anal. Appl. 22, 2000); a dense solver for small
/// matrices. Where the eigenspace has several dimensions the result is the start's projection on it.
/// Not converged after MaximumIterations: the best pair so far, its Residual above Tolerance.
/// Throws std::runtime_error if no factor is found.
/// @param start    must not be orthogonal to the eigenspace
/// @param progress called before each solve with the number of solves done; false stops
Eigenpair SmallestEigenpair(const SparseMatrix& energy, const SparseMatrix& mass,
  const ComplexVector& start, const EigenpairSettings& settings,
  const std::function<bool(int)>& progress = {});
}

#endif
