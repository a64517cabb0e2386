// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_PairCancellation_h
#define DirectionFields_PairCancellation_h

#include "Progress.h"
#include "UnitLength/PairPatch.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Cancels pairs of singularities of opposite sign, and lets singularities leave over the boundary,
/// where that lowers the sum of the energy and the cost of the singularities.
class PairCancellation
{
public:
  /// @param cost the rise of the energy that is accepted for one singularity of index 1 less, at
  ///             least 0
  PairCancellation(const UnitLengthProblem& problem, double cost);

  /// Goes through all pairs once, from the closest to the farthest, and changes the field in
  /// patches around them; from the second round on through those with an end where a patch of the
  /// round before has turned the field. The same bytes for any number of threads. Throws Stopped.
  /// @return the number of pairs that were cancelled
  int Round(ComplexVector& u, const Progress& progress);
  /// Cancels the pairs of the last round that are predicted to pay off once all around them has
  /// come to rest, which raises the energy until then. The caller decides whether it was worth it.
  /// @return the number of pairs
  int CancelOnApproval(ComplexVector& u);

private:
  class Queue;
  std::vector<SingularityPair> FindCandidates(const ComplexVector& u);
  /// Whether the patch pays off in full.
  bool PaysOff(const PairPatch& patch, const ComplexVector& u) const;
  void Accept(const PairPatch& patch, ComplexVector& u);
  /// Whether a patch of a double cover reaches its own mirror image, which cannot be changed with
  /// it then.
  bool ReachesItself(const PairPatch& patch);

  const UnitLengthProblem& Problem;
  double Cost;
  /// The rise of the energy of a patch that is accepted for one singularity of index 1 less.
  double Allowance;
  PatchNumbers Numbers;
  std::vector<SingularityPair> OnApproval;
  /// 1 for the vertices that the last round has turned.
  std::vector<char> Changed;
  bool IsFirstRound = true;
  /// The patch that each vertex belongs to, or None.
  std::vector<Index> Owner;
};
}

#endif
