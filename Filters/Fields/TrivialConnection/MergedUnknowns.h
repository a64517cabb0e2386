// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MergedUnknowns_h
#define DirectionFields_MergedUnknowns_h

#include "Types.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Unknowns that are merged by given differences of their values: each set of them has one degree
/// of freedom.
class MergedUnknowns
{
public:
  explicit MergedUnknowns(Index unknowns);

  bool AreJoined(Index a, Index b) { return this->Find(a) == this->Find(b); }
  /// Lets the value of b be that of a and the difference. Nothing is done where the two are joined
  /// already.
  void Join(Index a, Index b, double difference);
  /// Lists the sets; nothing is joined after that.
  void Close();

  /// Changes the values of each set, as little as may be in the mean square, such that they differ
  /// as given.
  void Satisfy(Eigen::VectorXd& values) const;
  /// Makes the values of each set the same: their mean.
  void Average(Eigen::Ref<Eigen::VectorXd> values) const;
  void Average(Eigen::Ref<Eigen::VectorXf> values) const;

private:
  template <typename Vector>
  void AverageSets(Vector& values) const;
  /// The set's first unknown, after which the paths there are short.
  Index Find(Index a);
  /// The value of an unknown over that of the set's first one.
  double Difference(Index a) const;

  std::vector<Index> Parent;
  /// Of each unknown over its parent.
  std::vector<double> Offset;
  std::vector<Index> Touched;
  /// The members of set k are those from Begin[k] to Begin[k + 1], and their differences.
  std::vector<Index> Begin;
  std::vector<Index> Members;
  std::vector<double> Differences;
};
}

#endif
