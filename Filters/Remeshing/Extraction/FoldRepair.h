// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FoldRepair_h
#define DirectionFields_FoldRepair_h

#include "Extraction/ExtractionMesh.h"

namespace DirectionFields::Internal
{
/// Where a map folds, a grid point may have been inserted more than once, and cones may have been
/// rounded to the same place. Such grid points are given up, and vertices that are joined by edges
/// without length become one, so that more vertices can be removed. Returns whether anything was
/// changed.
bool RepairFolds(ExtractionMesh& mesh);
}

#endif
