// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SingularityMoves_h
#define DirectionFields_SingularityMoves_h

#include "UnitLength/PairPatch.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Moves singularities to where the field has less energy. Descent in the phases alone does not:
/// between two triangles there is always a little more of it.
class SingularityMoves
{
public:
  explicit SingularityMoves(const UnitLengthProblem& problem);

  /// Tries each singularity in six directions, twice as far as it went the last time and half as
  /// far as where it did not; it is done with where it would not go to the next triangle. On double
  /// covers nothing is moved. The same bytes for any number of threads.
  /// @return the number of those that moved
  int Sweep(ComplexVector& u);
  /// Whether no singularity is left that might move.
  bool IsDone() const { return !this->IsFirstSweep && this->Waiting.empty(); }

private:
  /// A singularity that is to be tried.
  struct Singularity
  {
    Index Triangle;
    int Sign;
    /// How many edges to cross.
    Index Length;
  };
  /// A move that it may make.
  struct Move
  {
    SingularityPair Path;
    std::unique_ptr<PairPatch> Patch;
  };
  void FindAll(const ComplexVector& u);
  /// The path from a triangle through one of its sides, as straight as triangles let it be.
  SingularityPair Walk(const Singularity& singularity, int side, bool left) const;
  /// Finds the best of six moves; it has no patch where none of them lowers the energy.
  void FindBest(const Singularity& singularity, const ComplexVector& u, Move& move);
  /// Makes that move if nothing else has changed there in this sweep.
  bool Go(const Move& move, ComplexVector& u);

  const UnitLengthProblem& Problem;
  PatchNumbers Numbers;
  /// 1 for the vertices that this sweep has changed.
  std::vector<char> Changed;
  std::vector<Singularity> Waiting;
  bool IsFirstSweep = true;
};
}

#endif
