// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_PairPatch_h
#define DirectionFields_PairPatch_h

#include "UnitLength/SingularityPairs.h"

#include <memory>
#include <mutex>
#include <vector>

namespace DirectionFields::Internal
{
/// Numbers of vertices within a patch, None for all others: storage that patches borrow one after
/// the other, since it is as long as the component.
class PatchNumbers
{
public:
  explicit PatchNumbers(Index vertices)
    : Vertices(vertices)
  {
  }

  class Loan
  {
  public:
    explicit Loan(PatchNumbers& owner);
    ~Loan();
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;
    Index operator[](Index v) const { return (*this->Numbers)[v]; }
    void Set(Index v, Index number);

  private:
    PatchNumbers& Owner;
    std::unique_ptr<std::vector<Index>> Numbers;
    std::vector<Index> Used;
  };

private:
  Index Vertices;
  std::mutex Lock;
  std::vector<std::unique_ptr<std::vector<Index>>> Free;
};

/// The surroundings of a pair of singularities, in which the field is turned so that they cancel.
/// All vertices are counted from the first one of the component.
class PairPatch
{
public:
  /// Takes all free vertices within a number of edges of the path.
  PairPatch(const UnitLengthProblem& problem, const SingularityPair& pair, Index rings,
    PatchNumbers& numbers);

  const std::vector<Index>& GetVertices() const { return this->Vertices; }
  /// The vertices that are not in the patch, but neighbours of it.
  const std::vector<Index>& GetNeighbours() const { return this->Neighbours; }

  /// Finds the field of the patch without the pair, with the values around held; u is not changed.
  void Try(const ComplexVector& u);

  /// The change of the energy; infinite before Try.
  double GetEnergyChange() const { return this->EnergyChange; }
  /// The new values, in the order of the vertices.
  const std::vector<Complex>& GetValues() const { return this->Values; }
  /// The change of the sum of |index| over all triangles without a given value.
  int CountIndexChange(const ComplexVector& u) const;

private:
  struct System;
  void SortAlong(const std::vector<Index>& places, Index count);
  int CountIndices(const ComplexVector& u, const PatchNumbers::Loan& number, bool changed) const;

  const UnitLengthProblem& Problem;
  const SingularityPair& Pair;
  PatchNumbers& Numbers;
  Index Rings;
  std::vector<Index> Vertices;
  std::vector<Index> Neighbours;
  std::vector<Complex> Values;
  double EnergyChange;
};
}

#endif
