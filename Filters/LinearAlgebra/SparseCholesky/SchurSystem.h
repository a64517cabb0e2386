// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SchurSystem_h
#define DirectionFields_SchurSystem_h

#include "SparseCholesky/SupernodalCholesky.h"
#include "Types.h"

#include <vector>

namespace DirectionFields::Internal
{
/// A sparse symmetric system K x = b some of whose unknowns, the last ones, are to be integers. Its
/// factor K = L L^T keeps them last: the trailing block of L is the factor of the Schur complement,
/// which is left of the matrix once the others are eliminated.
class SchurSystem
{
public:
  using Matrix = SupernodalCholesky<double>::Matrix;

  /// @param lower the lower triangle of the matrix
  /// @param reals rows before those of the integers
  SchurSystem(Matrix lower, Index reals);

  /// False where the matrix is not positive definite up to rounding.
  bool IsDefinite() const { return this->Definite; }
  /// Releases the memory of the elimination, and a factor of more than mostValues values: nothing
  /// can be solved then until it is restored. The structure of the factor stays.
  void Shrink(std::size_t mostValues);
  /// Makes a released factor again, the same one.
  void Restore();
  Eigen::VectorXd Solve(const Eigen::VectorXd& rightHandSide) const;
  /// The solution among the vectors with the given integers.
  /// @param relaxed the solution among all vectors
  Eigen::VectorXd SolveWith(const Eigen::VectorXd& relaxed, const Eigen::VectorXd& integers) const;
  /// The lower factor of the Schur complement of the integers.
  const Eigen::MatrixXd& TrailingFactor() const { return this->Trailing; }

private:
  Index Size;
  Index Reals;
  /// The lower triangle of the matrix, as long as it may have to be factored.
  Matrix Lower;
  SupernodalCholesky<double> Factor;
  Eigen::MatrixXd Trailing;
  bool Definite = false;
  bool IsReleased = false;
};
/// The solution, some of whose unknowns are integers, where these are too many to be rounded with
/// regard to each other: first all are real, then, in a few rounds, those that are nearest to an
/// integer get it and the rest is solved for again. Returns an empty vector where the matrix is not
/// positive definite up to rounding.
/// @param lower, reals as for SchurSystem
Eigen::VectorXd SolveInRounds(
  const SchurSystem::Matrix& lower, const Eigen::VectorXd& rightHandSide, Index reals);
}

#endif
