// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FoldRepair_h
#define DirectionFields_FoldRepair_h

#include "Extraction/ExtractionMesh.h"

namespace DirectionFields::Internal
{
/// Where a map folds, a lattice point may have been inserted more than once, and cones may have been rounded
/// to the same place. This takes such lattice points back, and makes vertices one that edges without
/// length join, so that more vertices can be removed. Returns whether anything was done.
bool RepairFolds(ExtractionMesh& mesh);
}

#endif
