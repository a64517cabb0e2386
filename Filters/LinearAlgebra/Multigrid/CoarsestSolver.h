// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CoarsestSolver_h
#define DirectionFields_CoarsestSolver_h

#include "Multigrid/LevelMatrices.h"
#include "Multigrid/Sweeps.h"

namespace DirectionFields::Internal
{
/// Nearly the inverse of A + shift M on the coarsest level of a hierarchy, at a cost in proportion
/// to the rows: a dense Cholesky factor of a small matrix, and sweeps down and up for a large one.
/// A level stays large where neighbouring values have little to do with each other, as on very
/// rough surfaces, and there sweeps converge. Hermitian and positive definite.
class CoarsestSolver
{
public:
  /// The most rows of a matrix that is factored; that takes a hundredth of a second.
  static constexpr Index MostDenseRows = 400;
  /// The most pairs of sweeps, one down and one up.
  static constexpr int MostPairs = 4;

  /// @param matrices   must outlive the solver, prepared for sweeps
  /// @param lumpedMass as in Hierarchy::Level
  CoarsestSolver(const LevelMatrices& matrices, const LargeArray<float>& lumpedMass, double shift);

  /// False where the matrix is not positive definite up to rounding, or where sweeps diverge.
  bool IsUsable() const { return this->Usable; }
  /// The pairs of sweeps of each solution, which reduce errors to about a third if that many can; 0
  /// for a factor.
  int GetPairs() const { return this->Pairs; }
  /// The part of an error that one pair of sweeps leaves, if an unfavourable one; 0 for a factor.
  double GetContraction() const { return this->Contraction; }

  /// y is about (A + shift M)^-1 b for B sections in different storage.
  /// @param product becomes the sum over the sections of Re b^* y; or null
  template <int B>
  void Solve(const float* b, float* y, double* product) const;

private:
  void Factor(double shift);
  /// Finds Contraction.
  void Contract();
  template <int B>
  void SolveByFactor(const float* b, float* y, double* product) const;

  const LevelMatrices& Matrices;
  Eigen::MatrixXcd DenseFactor;
  SweepDiagonal Diagonal;
  double Contraction = 0.0;
  int Pairs = 0;
  bool Usable = false;
};
}

#endif
