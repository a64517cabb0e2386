// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Sweeps_h
#define DirectionFields_Sweeps_h

#include "Multigrid/CompactMatrix.h"

// The smoother of multigrid. Sweeps are Gauss-Seidel within blocks of rows and Jacobi between them,
// so that blocks run at once and results do not depend on the number of threads. The coupling of a
// row with other blocks is added to its diagonal, which keeps the sweep convergent (the l1 smoother
// of A. Baker et al., SIAM J. Sci. Comput. 33, 2011). The local rows of each block are swept a few
// times more, by themselves (local relaxation: A. Brandt, Multigrid Techniques, 1984).
namespace DirectionFields::Internal
{
/// How often local rows are swept besides the sweep of all rows.
constexpr int LocalSweeps = 4;

/// The diagonal data that sweeps need for the matrix A + shift m besides the entries of A, where m
/// is a diagonal.
struct SweepDiagonal
{
  SweepDiagonal() = default;
  /// @param relaxation how far a sweep goes towards each row's solution, above 0 and below 2
  SweepDiagonal(
    const CompactMatrix& matrix, const LargeArray<float>& m, float shift, float relaxation = 1.0f);

  float Relaxation = 1.0f;
  LargeArray<float> Diagonal;
  /// The relaxation over the sum of the diagonal and the couplings to other blocks.
  LargeArray<float> Inverse;
  /// For each row of the boundary the sum of its couplings to other blocks.
  LargeArray<float> Extra;
};

/// The order in which a sweep goes through the rows of a block. Sweeps in the two orders are
/// adjoint to each other.
enum class SweepOrder
{
  /// All rows, then the local ones again, by ascending numbers.
  Down,
  /// The local rows, then all of them, by descending numbers.
  Up
};

/// One sweep for (A + shift m) x = b that goes on from x.
/// @param b, x    B sections each
/// @param r       becomes b - (A + shift m) x of the new x, in the same pass over the matrix; or
///                null
/// @param product becomes the sum over the sections of Re b^* x of the new x, in the same pass; or
///                null
template <int B>
void Sweep(const CompactMatrix& matrix, const SweepDiagonal& diagonal, SweepOrder order,
  const float* b, float* x, float* r = nullptr, double* product = nullptr);

/// One sweep down that starts from zero.
template <int B>
void SweepFromZero(const CompactMatrix& matrix, const SweepDiagonal& diagonal, const float* b,
  float* x, float* r = nullptr);
}

#endif
