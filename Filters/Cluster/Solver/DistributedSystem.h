// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DistributedSystem_h
#define DistributedSystem_h

#include "Computation/SystemFactors.h"
#include "Mesh/DistributedMesh.h"
#include "Mesh/Messages.h"
#include "Solver/DistributedGuide.h"
#include "Solver/DistributedHierarchy.h"
#include "Solver/DistributedMatrices.h"
#include "Solver/PetscObjects.h"

#include <functional>

namespace DirectionFields::Parallel
{
/// The linear systems of one component of the whole surface: the counterpart of GuidanceTerms and
/// FreeSystem on one process.
class DistributedSystem
{
public:
  /// All processes call it, and all other functions, too; they throw std::runtime_error on all of
  /// them.
  /// @param matrices must outlive the system
  DistributedSystem(const Messages& messages, const DistributedMesh& mesh,
    const DistributedMatrices& matrices, const DistributedGuide& guide);

  bool HasGuidance() const { return this->IsGuided; }
  bool HasGiven() const { return this->IsConstrained; }
  /// How many vertices of the component are constrained.
  Index CountGiven() const { return this->Given; }

  struct Solution
  {
    OwnedVec Vector;
    /// As SystemSolution::Residual.
    double Residual = 0.0;
    /// The matrix is not positive definite: there is no solution.
    bool Indefinite = false;
  };
  /// Conjugate gradients with the hierarchy's V-cycle. Throws Stopped.
  /// @param hierarchy of the matrices, whose shift it changes; another one is made where values are
  /// given
  /// @param goOn      as in DistributedSettings
  Solution Solve(const SystemFactors& factors, double tolerance, DistributedHierarchy& hierarchy,
    const std::function<bool(double)>& goOn) const;

  /// Turns the smoothest field to the phase that is closest to the guidance, if there is any.
  void TurnToGuidance(Vec u) const;

private:
  void MakeGuidance(const Messages& messages, const std::vector<Complex>& drawn);
  Solution SolveFree(Mat matrix, Vec right, const SystemFactors& factors, double tolerance,
    double scale, const std::function<bool(double)>& goOn) const;

  const DistributedMatrices& Matrices;
  bool IsGuided = false;
  bool IsConstrained = false;
  Index Given = 0;
  /// For each own row whether its value is given, and whether its value or a neighbour's is given.
  std::vector<char> IsGiven;
  std::vector<char> IsNearGiven;
  /// The given values, zero elsewhere.
  OwnedVec GivenValues;
  /// M q
  OwnedVec MassTimes;
};
}

#endif
