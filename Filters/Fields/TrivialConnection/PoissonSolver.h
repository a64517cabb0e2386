// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_PoissonSolver_h
#define DirectionFields_PoissonSolver_h

#include "Laplacian/LaplacianHierarchy.h"
#include "Progress.h"
#include "TrivialConnection/ConstrainedSets.h"
#include "TrivialConnection/DiscreteForms.h"
#include "TrivialConnection/MergedUnknowns.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Numbers over the unknowns of one component (see ConstrainedSets), and the Laplacian of the
/// edges' weights on them, whose hierarchy is made once for all right-hand sides.
class PoissonSolver
{
public:
  PoissonSolver(const DiscreteForms& forms, const ConstrainedSets& constrained);

  struct Problem
  {
    /// Of each unknown.
    const Eigen::VectorXd& RightHandSide;
    /// Unknowns that are joined; null for none.
    const MergedUnknowns* Merged = nullptr;
    /// D, at least 0, which is added to the diagonal; null for 0. Without it the values are
    /// determined up to a common constant, and the right-hand side has to add up to 0.
    const Eigen::VectorXd* Diagonal = nullptr;
    /// Unknowns whose value stays that of the guess; null for none.
    const std::vector<Index>* Held = nullptr;
    /// Relative to the right-hand side.
    double Tolerance = 1e-8;
    DirectionFields::Progress Progress = {};
  };
  /// Minimizes x^T (L + D) x / 2 - b^T x by conjugate gradients with V-cycles. Joined unknowns keep
  /// the differences that they have in the guess. Returns the relative residual that is left.
  /// Throws Stopped.
  double Solve(const Problem& problem, Eigen::VectorXd& values) const;

  Index NumberOfUnknowns() const { return static_cast<Index>(this->Areas.size()); }
  /// A third of the area of the triangles at each unknown, in unit^2.
  const Eigen::VectorXd& GetAreas() const { return this->Areas; }
  double GetArea() const { return this->Area; }

  /// The sums of vertices' values over the unknowns, and the vertices' values from those of the
  /// unknowns.
  Eigen::VectorXd Gathered(const Eigen::VectorXd& vertices) const;
  Eigen::VectorXd Spread(const Eigen::VectorXd& unknowns) const;

private:
  class Iteration;
  const SweptLaplacian& GetLaplacian() const { return this->Hierarchy.GetLevels().front().Matrix; }

  std::vector<Index> Unknown;
  Eigen::VectorXd Areas;
  double Area;
  LaplacianHierarchy Hierarchy;
};
}

#endif
