// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RitzSpace_h
#define DirectionFields_RitzSpace_h

#include "Eigenpairs/RayleighRitz.h"
#include "Matrices/OperatorProducts.h"

#include <initializer_list>

namespace DirectionFields::Internal
{
/// A space of sections that grows by one at a time, and its Ritz pairs in double precision. Where
/// many eigenvalues nearly agree, it separates their eigenvectors.
class RitzSpace
{
public:
  /// The space has at most this many sections. Where another one comes, the Ritz vectors of the
  /// smallest values are kept, and the rest is forgotten.
  static constexpr int MostSections = 20;
  static constexpr int KeptSections = 14;

  /// @param operators must outlive the space
  explicit RitzSpace(const Operators& operators);

  /// Adds a section, unless it is in the space already.
  void Add(ComplexVector section);

  int Size() const { return this->Count; }
  /// The Ritz values, ascending.
  const Eigen::VectorXd& GetValues() const { return this->Pairs.Values; }
  /// The Ritz vector of the smallest value, of unit length in M; there has to be one. Those of the
  /// next values, as far as there are any, and their energy products are written to the sections
  /// 1, 2, 3 of a block.
  SectionProducts First(SectionBlock& next) const;

private:
  /// Leaves the Ritz vectors of the smallest KeptSections values as the basis.
  void Forget();
  /// The rows begin to end - 1 of the sections.
  auto Rows(Index begin, Index end) const
  {
    return this->Basis.block(begin, 0, end - begin, this->Count);
  }
  /// V^* x, one column for each vector x.
  SmallMatrix InnerProducts(std::initializer_list<const ComplexVector*> vectors) const;

  const Operators& Matrices;
  /// Its first Count columns are the sections, orthonormal in M. Their products are not kept: to
  /// compute those of a sum of sections takes less than to add them up, and a third of the memory.
  Eigen::MatrixXcd Basis;
  int Count = 0;
  /// V^* A V and V^* M V of the basis V.
  SmallMatrix Energy;
  SmallMatrix Mass;
  RitzPairs Pairs;
};
}

#endif
