// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Sweeps_h
#define DirectionFields_Sweeps_h

#include "Solvers/Multigrid/CompactMatrix.h"

// The smoother of multigrid. Sweeps are Gauss-Seidel within blocks of rows and Jacobi between them, so
// that blocks run at once and results do not depend on the number of threads. What couples a row with
// other blocks is added to its diagonal, which keeps the sweep convergent (the l1 smoother of
// A. Baker et al., SIAM J. Sci. Comput. 33, 2011). The local rows of each block are swept a few times
// more, by themselves (local relaxation: A. Brandt, Multigrid Techniques, 1984).
namespace DirectionFields
{
/// How often local rows are swept besides.
constexpr int LocalSweeps = 4;

/// The matrix A + shift m that is swept, but for its entries.
struct SweepDiagonal
{
  SweepDiagonal() = default;
  /// @param m, shift   as above
  /// @param relaxation how far a sweep goes towards each row's solution, above 0 and below 2
  SweepDiagonal(const CompactMatrix& matrix, const LargeArray<float>& m, float shift,
    float relaxation = 1.0f);

  float Relaxation = 1.0f;
  LargeArray<float> Diagonal;
  /// The relaxation over the diagonal and the couplings to other blocks.
  LargeArray<float> Inverse;
  /// The couplings to other blocks of each row of the boundary.
  LargeArray<float> Extra;
};

/// In the order of the rows and then some in that order again, or all in the opposite order: sweeps
/// adjoint to each other.
enum class SweepOrder
{
  Down,
  Up
};

/// One sweep for (A + shift m) x = b that goes on from x.
/// @param b, x    B sections each
/// @param r       b - (A + shift m) x once swept, in the same pass over the matrix; or null
/// @param product Re b^* x once swept, of all sections, likewise
template <int B>
void Sweep(const CompactMatrix& matrix, const SweepDiagonal& diagonal, SweepOrder order,
  const float* b, float* x, float* r = nullptr, double* product = nullptr);

/// One sweep down that starts from zero.
template <int B>
void SweepFromZero(const CompactMatrix& matrix, const SweepDiagonal& diagonal, const float* b,
  float* x, float* r = nullptr);
}

#endif
