// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SectionBlock_h
#define DirectionFields_SectionBlock_h

#include "Solvers/Multigrid/CompactMatrix.h"

#include <utility>
#include <vector>

namespace DirectionFields
{
using SmallMatrix = Eigen::MatrixXcd;

/// Four sections in single precision with what energy and mass matrix make of them.
struct SectionBlock
{
  static constexpr int Width = 4;

  CompactSections Vectors;
  CompactSections Energy;
  CompactSections Mass;

  SectionBlock() = default;
  /// The values are undefined.
  explicit SectionBlock(Index rows);
  Index Rows() const { return static_cast<Index>(this->Vectors.size() / (2 * Width)); }
};

/// Adds up the conjugates of four values times another one, in double precision.
class WideSum
{
public:
  void Add(const CompactValues<SectionBlock::Width>& values, const Complex& factor)
  {
    const Numbers re = values.Real.cast<double>();
    const Numbers im = values.Imaginary.cast<double>();
    this->Real += factor.real() * re + factor.imag() * im;
    this->Imaginary += factor.imag() * re - factor.real() * im;
  }
  WideSum& operator+=(const WideSum& other)
  {
    this->Real += other.Real;
    this->Imaginary += other.Imaginary;
    return *this;
  }
  Complex Value(int b) const { return { this->Real[b], this->Imaginary[b] }; }

private:
  using Numbers = Eigen::Array<double, SectionBlock::Width, 1>;
  Numbers Real = Numbers::Zero();
  Numbers Imaginary = Numbers::Zero();
};

/// The sections of the smallest eigenvalues, nearly, and nearly orthonormal in the mass matrix.
struct LowestSections
{
  /// Four sections; or empty.
  CompactSections Vectors;
  /// Ascending, but for the errors of all but the first.
  Eigen::VectorXd Values;
};

/// a^* b of each pair of blocks of four sections, 4 x 4, in one pass.
std::vector<SmallMatrix> Products(
  Index rows, const std::vector<std::pair<const CompactSections*, const CompactSections*>>& pairs);

/// target = sum of a c over the pairs (block a, 4 x 4 matrix c), for vectors and products alike, or
/// without Mass, which is emptied. The target may be one of the blocks.
void Combine(const std::vector<std::pair<const SectionBlock*, SmallMatrix>>& terms,
  SectionBlock& target, bool withMass = true);

/// The smallest pairs of a projected eigenvalue problem.
struct RitzPairs
{
  /// Ascending.
  Eigen::VectorXd Values;
  /// Coefficients of the vectors in the basis, orthonormal in its mass matrix.
  SmallMatrix Vectors;
};

/// Of energy and mass matrix of a basis, whose vectors may be nearly dependent and of any length.
/// No more than wanted pairs, fewer where the basis does not have them, none where it has values
/// that are not finite.
RitzPairs RayleighRitz(const SmallMatrix& energy, const SmallMatrix& mass, int wanted);
}

#endif
