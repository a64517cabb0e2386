// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LevelDiffusion_h
#define DirectionFields_LevelDiffusion_h

#include "Matrices/FreeVertices.h"
#include "Multigrid/Hierarchy.h"
#include "Progress.h"
#include "UnitLength/UnitLengthProblem.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Diffusion and projection (see PhaseDescent::Diffuse) on the coarse levels of a hierarchy, from
/// coarse to fine. Over large times singularities go where they belong, however far that is, and
/// each time is repeated until they no longer move. That would take too many steps on the fine
/// level, where steps of short times leave singularities in their triangles; a coarse level has a
/// small part of the vertices, and holds singularities at longer times only. Without guidance.
class LevelDiffusion
{
public:
  /// @param hierarchy of the matrices among the free vertices
  /// @param free      the free vertices; null where all are
  /// @param rate      as in UnitLengthSettings
  LevelDiffusion(const UnitLengthProblem& problem, const Hierarchy& hierarchy,
    const FreeVertices* free, double rate);

  /// Whether the hierarchy has coarse levels that are small enough, and not too small.
  bool IsPossible() const;
  /// Diffuses a section of modulus 1 on all coarse levels, if that is possible; its given values
  /// stay. The same bytes for any number of threads. Throws Stopped.
  /// @return the number of steps
  int Run(const Progress& progress, ComplexVector& u);

  /// The shifts of the steps on the finest level that are to follow: down to the
  /// time in which values spread about as far as an edge.
  std::vector<double> FineShifts() const;

private:
  using Values = LargeArray<CompactComplex>;
  Index Vertex(Index row) const { return this->Free ? this->Free->GetVertices()[row] : row; }
  void RestrictTo(std::size_t coarsest, const ComplexVector& u);
  int RunOn(std::size_t level, const Progress& progress);

  const UnitLengthProblem& Problem;
  const Hierarchy& Matrices;
  const FreeVertices* Free;
  /// That of the last time so far.
  double Shift;
  /// The section on each level, and what given values add to the right-hand side.
  std::vector<Values> Sections;
  std::vector<Values> Held;
};
}

#endif
