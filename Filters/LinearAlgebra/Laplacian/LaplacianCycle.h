// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LaplacianCycle_h
#define DirectionFields_LaplacianCycle_h

#include "Laplacian/LaplacianHierarchy.h"

#include <vector>

namespace DirectionFields::Internal
{
/// A multigrid cycle B, nearly the inverse of L + shift M, up to constants where the shift is 0:
/// one sweep down, the coarser level's cycle, one sweep up. From the third level on a level's cycle
/// is applied again, to the residual that it leaves. Symmetric, and the same bytes for any number
/// of threads. Sweeps are Gauss-Seidel within blocks of rows and Jacobi between them, with the
/// couplings of a row with other blocks added to its diagonal (the l1 smoother of A. Baker et al.,
/// SIAM J. Sci. Comput. 33, 2011).
class LaplacianCycle
{
public:
  /// @param hierarchy must outlive the cycle
  /// @param shift     at least 0
  LaplacianCycle(const LaplacianHierarchy& hierarchy, double shift);

  /// False where the coarsest matrix is not positive definite up to rounding.
  bool IsUsable() const { return this->Usable; }
  /// y = B b
  void Apply(const LargeArray<float>& b, LargeArray<float>& y);

private:
  /// The vectors of a cycle on one level.
  struct Storage
  {
    /// The diagonal, with the shift.
    LargeArray<float> Diagonal;
    /// The relaxation over the diagonal and the couplings to other blocks, and by how much 1 over
    /// that exceeds the diagonal.
    LargeArray<float> Inverse;
    LargeArray<float> Excess;
    LargeArray<float> Right;
    LargeArray<float> Rest;
    LargeArray<float> Up;
    LargeArray<float> Before;
    LargeArray<float> Left;
    bool IsRepeated = false;
  };
  void Factor(double shift);
  void SolveCoarsest(const float* b, float* y) const;
  void Apply(std::size_t level, const float* b, float* y);
  /// One sweep for L x = b by ascending rows, from zero, and the residual r = b - L x. The part of
  /// a row that the sweep has added up is not added up again, so that both take no longer than a
  /// product with the matrix.
  void SweepDown(std::size_t level, const float* b, float* x, float* r) const;
  /// One by descending rows.
  void SweepUp(std::size_t level, const float* b, float* x);
  /// r = b - L x
  void FindRest(std::size_t level, const float* b, const float* x, float* r) const;

  const std::vector<LaplacianHierarchy::Level>& Levels;
  std::vector<Storage> Kept;
  Eigen::MatrixXd DenseFactor;
  bool Usable = true;
};
}

#endif
