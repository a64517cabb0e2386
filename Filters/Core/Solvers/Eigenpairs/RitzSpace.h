// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RitzSpace_h
#define DirectionFields_RitzSpace_h

#include "Solvers/Matrices/OperatorProducts.h"
#include "Solvers/Multigrid/SectionBlock.h"

#include <vector>

namespace DirectionFields
{
/// A space of sections that grows by one at a time, and its Ritz pairs in double precision. Where many
/// eigenvalues nearly agree, it separates their eigenvectors.
class RitzSpace
{
public:
  /// Sections at most; where there are more, those of the largest values are forgotten.
  static constexpr int MostSections = 20;
  static constexpr int KeptSections = 14;

  /// @param operators must outlive the space
  explicit RitzSpace(const Operators& operators);

  /// One that is in the space already is left out.
  void Add(ComplexVector section);

  int Size() const { return static_cast<int>(this->Basis.size()); }
  /// Ascending.
  const Eigen::VectorXd& GetValues() const { return this->Pairs.Values; }
  /// The Ritz vector of the smallest value, of unit length in M.
  SectionProducts First() const;
  /// Writes the Ritz vectors of the next values, as far as there are any, to the sections 1, 2, 3 of
  /// a block, without Mass.
  void WriteNext(SectionBlock& block) const;

private:
  void Forget();

  const Operators& Matrices;
  /// Orthonormal in M.
  std::vector<SectionProducts> Basis;
  /// Of the basis.
  SmallMatrix Energy;
  SmallMatrix Mass;
  RitzPairs Pairs;
};
}

#endif
