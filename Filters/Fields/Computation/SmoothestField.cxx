// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/SmoothestField.h"

#include "Eigenpairs/JacobiDavidson.h"
#include "Eigenpairs/Lanczos.h"

#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Automatic takes the direct solver up to this number of rows. Multigrid takes half the time of it
/// on most surfaces of more rows, and of somewhat fewer, too; but where many eigenvalues are near
/// the smallest one, as on coarse surfaces of many handles, it takes twice the time down there.
constexpr Eigen::Index DirectRows = 1600;
/// The solves that the direct solver needs where multigrid is slow, as where many eigenvalues
/// nearly agree, and its work by the row and solve besides those with the factor (see WorkLimit).
constexpr int TypicalSolves = 60;
constexpr double WorkOfSolve = 150.0;
}

SmallestPairs FindSmallestPairs(const Operators& operators,
  const std::function<ComplexVector()>& start, Solver solver, const EigenpairSettings& settings,
  const Progress& progress)
{
  SmallestPairs pairs;
  const Eigen::Index rows = operators.Energy.rows();
  const bool automatic = solver == Solver::Automatic;
  if (solver != Solver::Direct && rows > (automatic ? DirectRows : Hierarchy::CoarsestRows))
  {
    pairs.Hierarchy = std::make_unique<Hierarchy>(operators, settings.Scale);
    const WorkLimit limit(operators.Energy, TypicalSolves, WorkOfSolve);
    EigenpairSettings limited = settings;
    limited.Limit = automatic ? &limit : nullptr;
    pairs.First =
      SolveByJacobiDavidson(operators, *pairs.Hierarchy, limited, progress, pairs.Lowest);
    pairs.SolverUsed = Solver::Multigrid;
    if (HasConverged(pairs.First) || (!automatic && std::isfinite(pairs.First.Residual)))
    {
      return pairs;
    }
    pairs = {};
  }
  pairs.First = SolveByLanczos(operators.Energy, operators.Mass, start(), settings, progress);
  return pairs;
}
}
