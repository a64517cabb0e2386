// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Hierarchy_h
#define DirectionFields_Hierarchy_h

#include "Solvers/Matrices/Operators.h"
#include "Solvers/Multigrid/Aggregation.h"
#include "Solvers/Multigrid/LevelMatrices.h"
#include "Solvers/Multigrid/Prolongator.h"

#include <vector>

namespace DirectionFields
{
/// A hierarchy of ever smaller matrices for the sections of one component, in single precision: a
/// V-cycle costs a few passes over the matrix and inverts it up to a small factor whatever the
/// number of vertices, as far as the triangles are well shaped.
class Hierarchy
{
public:
  /// Sections on the coarsest level at most, as a rule.
  static constexpr Index CoarsestRows = 150;
  /// Sections on the coarsest level where coarsening ends early.
  static constexpr Index MostCoarsestRows = 1500;

  struct Level
  {
    LevelMatrices Matrices;
    /// Mass of each vertex' surroundings, sum of |M_ij| over j: what M does to smooth sections.
    LargeArray<float> LumpedMass;
    /// From the next coarser level; empty on the coarsest.
    Prolongator FromCoarser;

    Index Rows() const { return this->Matrices.Energy.Rows(); }
  };

  /// @param scale    the order of magnitude of the smallest eigenvalue, as in EigenpairSettings
  /// @param leftOver Drop for linear systems alone
  Hierarchy(const Operators& operators, double scale, LeftOver leftOver = LeftOver::Keep);

  const std::vector<Level>& GetLevels() const { return this->Levels; }
  double GetScale() const { return this->Scale; }
  /// Entries of all levels' matrices over those of the finest.
  double OperatorComplexity() const;

private:
  std::vector<Level> Levels;
  double Scale;
};
}

#endif
