// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CompactMatrix_h
#define DirectionFields_CompactMatrix_h

#include "Types.h"

#include <array>
#include <cmath>
#include <complex>
#include <vector>

namespace DirectionFields
{
/// What preconditioners compute with: half the memory traffic of Complex, and enough digits for a
/// correction.
using CompactComplex = std::complex<float>;

/// The modulus, for numbers whose squares neither overflow nor matter if they vanish.
inline float Modulus(const CompactComplex& z)
{
  return std::sqrt(z.real() * z.real() + z.imag() * z.imag());
}

/// B sections side by side: for each vertex B real parts, then B imaginary parts. One section is an
/// array of CompactComplex.
using CompactSections = std::vector<float>;

/// The B values of a vertex.
template <int B>
struct CompactValues
{
  std::array<float, B> Real{};
  std::array<float, B> Imaginary{};

  CompactValues() = default;
  CompactValues(const float* sections, Index v)
  {
    const float* from = sections + static_cast<std::size_t>(2 * B) * v;
    for (int b = 0; b < B; ++b)
    {
      this->Real[b] = from[b];
      this->Imaginary[b] = from[B + b];
    }
  }
  void Store(float* sections, Index v) const
  {
    float* to = sections + static_cast<std::size_t>(2 * B) * v;
    for (int b = 0; b < B; ++b)
    {
      to[b] = this->Real[b];
      to[B + b] = this->Imaginary[b];
    }
  }
  /// Adds a multiple of the values of another vertex.
  void Add(const CompactComplex& factor, const float* sections, Index v)
  {
    const float* from = sections + static_cast<std::size_t>(2 * B) * v;
    const float re = factor.real();
    const float im = factor.imag();
    for (int b = 0; b < B; ++b)
    {
      this->Real[b] += re * from[b] - im * from[B + b];
      this->Imaginary[b] += re * from[B + b] + im * from[b];
    }
  }
  void AddReal(float factor, const float* sections, Index v)
  {
    const float* from = sections + static_cast<std::size_t>(2 * B) * v;
    for (int b = 0; b < B; ++b)
    {
      this->Real[b] += factor * from[b];
      this->Imaginary[b] += factor * from[B + b];
    }
  }
  void Scale(float factor)
  {
    for (int b = 0; b < B; ++b)
    {
      this->Real[b] *= factor;
      this->Imaginary[b] *= factor;
    }
  }
};

/// Hermitian matrix in single precision with the sweeps of a smoother. Compressed rows, columns
/// ascending; the diagonal stands apart.
///
/// Sweeps are Gauss-Seidel within blocks of BlockRows rows and Jacobi between them, so that blocks
/// run at once and results do not depend on the number of threads. What couples a row with other
/// blocks is added to its diagonal, which keeps the sweep convergent (the l1 smoother of
/// A. Baker et al., SIAM J. Sci. Comput. 33, 2011).
struct CompactMatrix
{
  static constexpr Index BlockRows = 4096;
  /// Rows of a piece where rows do not depend on each other.
  static constexpr Index PieceRows = 2048;

  /// Entries of row v: Begin[v] to Upper[v] left of the diagonal, Upper[v] to Begin[v + 1] right of it.
  std::vector<Index> Begin;
  std::vector<Index> Upper;
  std::vector<Index> Column;
  std::vector<CompactComplex> Value;
  std::vector<float> Diagonal;

  CompactMatrix() = default;
  /// Rounds a Hermitian matrix.
  explicit CompactMatrix(const SparseMatrix& matrix);

  Index Rows() const { return static_cast<Index>(this->Diagonal.size()); }

  /// Row v of A x.
  template <int B>
  CompactValues<B> RowTimes(Index v, const float* x) const
  {
    CompactValues<B> sum;
    sum.AddReal(this->Diagonal[v], x, v);
    for (Index k = this->Begin[v]; k < this->Begin[v + 1]; ++k)
    {
      sum.Add(this->Value[k], x, this->Column[k]);
    }
    return sum;
  }
};

/// What a sweep divides by.
struct SweepDiagonal
{
  SweepDiagonal() = default;
  /// @param m, shift the matrix swept is A + shift m
  SweepDiagonal(const CompactMatrix& matrix, const std::vector<float>& m, float shift);

  /// Of A + shift m with the couplings to other blocks.
  std::vector<float> Inverse;
  /// The couplings to other blocks.
  std::vector<float> Extra;
};

/// One sweep downwards that starts from zero: x; and what it leaves of b: r = b - (A + shift m) x.
/// @param x, r B sections each
template <int B>
void SweepDown(const CompactMatrix& matrix, const SweepDiagonal& diagonal, const float* b,
  float* x, float* r);

/// One sweep upwards that goes on from x: y.
template <int B>
void SweepUp(const CompactMatrix& matrix, const SweepDiagonal& diagonal, const float* b,
  const float* x, float* y);
}

#endif
