// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DistributedEigenpair_h
#define DistributedEigenpair_h

#include "Solver/DistributedHierarchy.h"
#include "Solver/DistributedMatrices.h"
#include "Solver/PetscObjects.h"

#include <functional>

namespace DirectionFields::Parallel
{
/// The smallest eigenpair of A u = lambda M u.
struct DistributedEigenpair
{
  double Value = 0.0;
  /// u^* M u = 1.
  OwnedVec Vector;
  /// As Eigenpair::Residual.
  double Residual = 0.0;
  double RequiredResidual = 0.0;
  /// V-cycles on the finest level.
  int Iterations = 0;
  /// Whether the next eigenvalue is the same up to 1e-4 of it, so that the solver, not the surface,
  /// decides on the section.
  bool IsRepeated = false;
};

/// Limits of the solver, as in Options.
struct DistributedSettings
{
  double Tolerance = 1e-6;
  int MaximumIterations = 200;
  /// The order of magnitude of the smallest eigenvalue.
  double Scale = 1.0;
  /// Is called by all processes now and then with the part that is done; false on all of them
  /// stops.
  std::function<bool(double)> GoOn;
};

/// Davidson's iteration with the hierarchy's V-cycle for a preconditioner, one cycle a step
/// (SLEPc's takes two: it also applies it to M u). It begins with the smallest pairs of the
/// coarsest level, which are refined level by level. All processes call it; throws
/// std::runtime_error on all of them, and Stopped.
DistributedEigenpair FindSmallestPair(const DistributedMatrices& matrices,
  DistributedHierarchy& hierarchy, const DistributedSettings& settings);
}

#endif
