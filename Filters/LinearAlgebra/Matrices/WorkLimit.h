// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_WorkLimit_h
#define DirectionFields_WorkLimit_h

#include "Types.h"

#include <limits>

// Work is counted, never measured, so that decisions that depend on it are the same on any machine
// and any number of threads. Its unit is the work of one thread of a common processor in a
// nanosecond.
namespace DirectionFields::Internal
{
/// The cost of a sparse Cholesky factor, from its pattern after the fill-reducing ordering.
struct FactorWork
{
  /// The number of rows, and of the factor's entries.
  double Rows = 0.0;
  double Entries = 0.0;
  /// Multiplications of complex numbers.
  double Operations = 0.0;

  /// Counts them. That takes about a twentieth of the time of the factorization.
  explicit FactorWork(const SparseMatrix& matrix);
  /// The work of the factorization.
  double OfFactor() const;
  /// The work of a solve with the factor.
  double OfSolve() const;
};

/// How much work an iteration may take before the direct solver is the better choice: as much as
/// that one takes, so that trying first at most doubles the time. Where it becomes plain that the
/// iteration will take more, it ends earlier.
class WorkLimit
{
public:
  /// @param matrix must outlive the object; that with the pattern to be factored
  /// @param solves how many solves with the factor the direct solver makes, and how much work it
  ///               has by each row and solve besides
  WorkLimit(const SparseMatrix& matrix, int solves, double perRow);

  /// Whether to go on.
  /// @param spent     the work so far
  /// @param remaining about the work to come; may be infinite
  bool Allows(double spent, double remaining = 0.0) const;
  /// The direct solver's work.
  double Get() const;

private:
  const SparseMatrix& Matrix;
  int Solves;
  double PerRow;
  /// 0 before it is known.
  mutable double Limit = 0.0;
};

/// The work that is left until a residual has fallen to the one that is wanted, if it goes on
/// falling as it has. Infinite where it does not fall.
/// @param spent the work that has made the residual fall from before to now
double RemainingWork(double spent, double before, double now, double wanted);
}

#endif
