// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Hierarchy_h
#define DirectionFields_Hierarchy_h

#include "Matrices/Operators.h"
#include "Multigrid/Aggregation.h"
#include "Multigrid/LevelMatrices.h"
#include "Multigrid/Prolongator.h"

#include <vector>

namespace DirectionFields::Internal
{
/// A hierarchy of ever smaller matrices for the sections of one component, in single precision: a
/// V-cycle costs a few passes over the matrix and inverts it up to a small factor whatever the
/// number of vertices, as far as the triangles are well shaped. Coarsening ends early where levels
/// hardly get smaller.
class Hierarchy
{
public:
  /// The coarsest level has no more rows than this, where coarsening goes on to its end.
  static constexpr Index CoarsestRows = 150;

  struct Level
  {
    LevelMatrices Matrices;
    /// The sum of |M_ij| over j for each row i: for smooth sections M nearly acts as this diagonal
    /// does.
    LargeArray<float> LumpedMass;
    /// Interpolates sections of the next coarser level; empty on the coarsest.
    Prolongator FromCoarser;

    Index Rows() const { return this->Matrices.Energy.Rows(); }
  };

  /// Throws std::invalid_argument where energy and mass matrix have different patterns, or where
  /// the mass matrix does not tell the transport of sections (see Operators): aggregates would be
  /// made of vertices whose values the energy does not draw together, and cycles would hardly
  /// reduce errors.
  /// @param scale    the order of magnitude of the smallest eigenvalue, as in EigenpairSettings
  /// @param leftOver Drop where only linear systems will be solved with the hierarchy
  Hierarchy(const Operators& operators, double scale, LeftOver leftOver = LeftOver::Keep);

  const std::vector<Level>& GetLevels() const { return this->Levels; }
  double GetScale() const { return this->Scale; }
  /// The number of entries of all levels' matrices over that of the finest.
  double OperatorComplexity() const;

private:
  std::vector<Level> Levels;
  double Scale;
};
}

#endif
