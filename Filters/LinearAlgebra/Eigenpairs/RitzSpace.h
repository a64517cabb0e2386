// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RitzSpace_h
#define DirectionFields_RitzSpace_h

#include "Eigenpairs/RayleighRitz.h"
#include "Matrices/OperatorProducts.h"

#include <vector>

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

  int Size() const { return static_cast<int>(this->Basis.size()); }
  /// The Ritz values, ascending.
  const Eigen::VectorXd& GetValues() const { return this->Pairs.Values; }
  /// The Ritz vector of the smallest value, of unit length in M.
  SectionProducts First() const;
  /// Writes the Ritz vectors of the next values, as far as there are any, and their energy products
  /// to the sections 1, 2, 3 of a block.
  void WriteNext(SectionBlock& block) const;

private:
  /// Leaves the Ritz vectors of the smallest KeptSections values as the basis.
  void Forget();

  const Operators& Matrices;
  /// The sections are orthonormal in M.
  std::vector<SectionProducts> Basis;
  /// V^* A V and V^* M V of the basis V.
  SmallMatrix Energy;
  SmallMatrix Mass;
  RitzPairs Pairs;
};
}

#endif
