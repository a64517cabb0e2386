// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Cycle_h
#define DirectionFields_Cycle_h

#include "Solvers/Multigrid/Hierarchy.h"
#include "Solvers/Multigrid/Sweeps.h"

#include <vector>

namespace DirectionFields
{
/// A cycle for A + shift M, approximately: one sweep down, the coarser level's cycle, which from the
/// third level on is repeated for what it leaves, one sweep up; a Cholesky factor on the coarsest
/// level. Symmetric and positive definite for a shift >= 0.
class Cycle
{
public:
  /// @param hierarchy must outlive the cycle
  Cycle(const Hierarchy& hierarchy, double shift);

  /// False where the coarsest matrix could not be factored.
  bool IsUsable() const { return this->Usable; }
  /// What the coarsest level adds to A instead of shift M is this times M: a little more.
  double GetCoarsestShift() const { return this->CoarsestShift; }

  /// y = B b on the given level.
  /// @param b, y    B sections each, not the same
  /// @param product Re b^* y, of all sections; or null
  template <int B>
  void Apply(const float* b, float* y, std::size_t level = 0, double* product = nullptr) const;

  /// Frees the storage that Apply has kept for next time.
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
  template <int B>
  void SolveCoarsest(const float* b, float* y, double* product) const;
  /// Corrects the Up of the level by what it leaves of its Right, which is overwritten.
  template <int B>
  void ApplyAgain(std::size_t level) const;

  const std::vector<Hierarchy::Level>& Levels;
  float Shift;
  double CoarsestShift;
  std::vector<SweepDiagonal> Diagonals;
  Eigen::MatrixXcd CoarsestFactor;
  bool Usable = false;
  mutable std::vector<Workspace> Workspaces;
};
}

#endif
