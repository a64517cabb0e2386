// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MultigridSystem_h
#define DirectionFields_MultigridSystem_h

#include "Solvers/Multigrid/Hierarchy.h"
#include "Solvers/Multigrid/SectionBlock.h"
#include "Solvers/Systems/LinearSystem.h"
#include "Solvers/Systems/ReducedBasis.h"

#include <functional>
#include <memory>
#include <vector>

namespace DirectionFields
{
/// The matrices among the vertices that are not given, and their hierarchy.
struct FreeSystem
{
  /// @param scale as in Hierarchy
  FreeSystem(const Operators& operators, const std::vector<Index>& given, double scale);

  std::vector<Index> Given;
  /// Ascending.
  std::vector<Index> Free;
  Operators Matrices;
  DirectionFields::Hierarchy Hierarchy;
  /// Of the energy's solutions so far.
  ReducedBasis Solved;
};

/// K = a A + m M of one component, a >= 0, inverted by conjugate gradients with V-cycles in time linear in
/// its vertices. What the functions return may have a Residual that is not small: where V-cycles do
/// not help, or where goOn, called before each step, has said false.
struct MultigridSystem
{
  const Operators& Matrices;
  double EnergyFactor;
  double MassFactor;
  /// Of the relative residual.
  double Tolerance;
  std::function<bool()> GoOn;
  /// Whether others with other factors are to follow: the first solution then takes longer, and they
  /// take fewer steps.
  bool OthersFollow = false;

  /// m / a, within the range of the hierarchy.
  double Shift() const;
  /// K x
  ComplexVector Times(const ComplexVector& x) const;

  /// K u = b.
  /// @param lowest approximations of the smallest eigenvectors of A, orthonormal in M, which K may
  ///               nearly map to zero; or empty
  /// @param solved where to begin, the solution is added
  SystemSolution Solve(const Hierarchy& hierarchy, const LowestSections& lowest,
    const ComplexVector& rightHandSide, ReducedBasis& solved) const;

  /// As SolveConstrainedEnergy. Adds the solution to those of the free system.
  SystemSolution SolveConstrainedEnergy(FreeSystem& freeSystem,
    const ComplexVector& rightHandSide, const GivenValues& given) const;

  /// As SolveConstrainedLeastSquares.
  SystemSolution SolveConstrainedLeastSquares(const FreeSystem& freeSystem,
    const ComplexVector& rightHandSide, const GivenValues& given) const;
};
}

#endif
