// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Galerkin_h
#define DirectionFields_Galerkin_h

#include "Solvers/Multigrid/LevelMatrices.h"
#include "Solvers/Multigrid/Prolongator.h"

namespace DirectionFields::Internal
{
/// P^* A P and P^* M P.
LevelMatrices Coarsen(const LevelMatrices& matrices, const Prolongator& prolongator);
}

#endif
