// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ByMultigrid_h
#define DirectionFields_ByMultigrid_h

#include "Eigenpairs/JacobiDavidson.h"
#include "Meshes/System.h"

namespace Meshes
{
inline DirectionFields::EigenpairSettings Settings(const System& system)
{
  DirectionFields::EigenpairSettings settings;
  settings.Scale = system.Scale;
  return settings;
}

/// The smallest eigenpair of a system by multigrid.
inline DirectionFields::Eigenpair ByMultigrid(const System& system)
{
  const DirectionFields::Hierarchy hierarchy(system.Matrices, system.Scale);
  DirectionFields::LowestSections lowest;
  return SolveByJacobiDavidson(system.Matrices, hierarchy, Settings(system), {}, lowest);
}
}

#endif
