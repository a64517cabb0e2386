// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Galerkin_h
#define DirectionFields_Galerkin_h

#include "Multigrid/LevelMatrices.h"
#include "Multigrid/Prolongator.h"

namespace DirectionFields::Internal
{
/// P^* A P and P^* M P.
LevelMatrices Coarsen(const LevelMatrices& matrices, const Prolongator& prolongator);
}

#endif
