// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SectionBlock_h
#define DirectionFields_SectionBlock_h

#include "Multigrid/CompactMatrix.h"

#include <utility>
#include <vector>

namespace DirectionFields::Internal
{
using SmallMatrix = Eigen::MatrixXcd;

/// Four sections x in single precision with their products A x and M x.
struct SectionBlock
{
  static constexpr int Width = 4;

  CompactSections Vectors;
  CompactSections Energy;
  CompactSections Mass;

  /// An empty block.
  SectionBlock() = default;
  /// The values are undefined.
  explicit SectionBlock(Index rows);
  Index Rows() const { return static_cast<Index>(this->Vectors.size() / (2 * Width)); }
};

/// The value of section b at vertex v, of SectionBlock::Width sections side by side.
inline Complex SectionValue(const CompactSections& sections, Index v, int b)
{
  const float* x = sections.data() + static_cast<std::size_t>(2 * SectionBlock::Width) * v;
  return { x[b], x[SectionBlock::Width + b] };
}
inline void SetSectionValue(CompactSections& sections, Index v, int b, const Complex& value)
{
  float* x = sections.data() + static_cast<std::size_t>(2 * SectionBlock::Width) * v;
  x[b] = static_cast<float>(value.real());
  x[SectionBlock::Width + b] = static_cast<float>(value.imag());
}

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

/// Approximations of the four smallest eigenpairs of A x = theta M x. The sections are orthonormal
/// in M to some digits.
struct LowestSections
{
  /// Four sections; or empty.
  CompactSections Vectors;
  /// The first value is exact; the others are ascending as far as their errors let them.
  Eigen::VectorXd Values;
};

/// x^* y, 4 x 4, for each pair (x, y) of four sections each, all in one pass.
std::vector<SmallMatrix> InnerProducts(
  Index rows, const std::vector<std::pair<const CompactSections*, const CompactSections*>>& pairs);

/// target = sum of x c over the pairs (block x, 4 x 4 matrix c), for vectors and products alike;
/// without mass, the target's Mass is emptied. The target may be one of the blocks.
void SetLinearCombination(const std::vector<std::pair<const SectionBlock*, SmallMatrix>>& terms,
  SectionBlock& target, bool withMass = true);
}

#endif
