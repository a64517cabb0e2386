// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Cycle_h
#define DirectionFields_Cycle_h

#include "Multigrid/CoarsestSolver.h"
#include "Multigrid/Hierarchy.h"
#include "Multigrid/Sweeps.h"

#include <vector>

namespace DirectionFields::Internal
{
/// A multigrid cycle B, nearly the inverse of A + shift M: one sweep down, the coarser level's
/// cycle, one sweep up; on the coarsest level a CoarsestSolver. From the third level on a level's
/// cycle is applied again, to the residual that it leaves, unless levels get smaller so slowly that
/// this would take long. B is Hermitian, and positive definite for a shift >= 0.
class Cycle
{
public:
  /// @param hierarchy must outlive the cycle
  Cycle(const Hierarchy& hierarchy, double shift);

  /// False where the coarsest solver is not usable.
  bool IsUsable() const { return this->Coarsest.IsUsable(); }
  /// The coarsest level adds this times M to A: a little more than shift.
  double GetCoarsestShift() const { return this->CoarsestShift; }

  /// y = B b on the given level.
  /// @param b, y    B sections each, in different storage
  /// @param product becomes the sum over the sections of Re b^* y; or null
  template <int B>
  void Apply(const float* b, float* y, std::size_t level = 0, double* product = nullptr) const;

  /// The work of a cycle for one section (see WorkLimit), in proportion to the entries of all
  /// levels, as often as it comes to them.
  double Work() const;
  const CoarsestSolver& GetCoarsest() const { return this->Coarsest; }

  /// Frees the storage that Apply keeps between calls.
  void ReleaseStorage() { this->Workspaces = std::vector<Workspace>(this->Workspaces.size()); }

private:
  /// Storage of one level for up to four sections.
  struct Workspace
  {
    CompactSections Right;
    CompactSections Rest;
    CompactSections Up;
    CompactSections Once;
  };
  /// Corrects the Up of the level by its residual for Right, which is overwritten.
  template <int B>
  void ApplyAgain(std::size_t level) const;

  const std::vector<Hierarchy::Level>& Levels;
  float Shift;
  double CoarsestShift;
  CoarsestSolver Coarsest;
  std::vector<SweepDiagonal> Diagonals;
  /// How often a cycle comes to each level.
  std::vector<int> Visits;
  mutable std::vector<Workspace> Workspaces;
};
}

#endif
