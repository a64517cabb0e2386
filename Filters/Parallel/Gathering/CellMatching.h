// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef CellMatching_h
#define CellMatching_h

#include "Gathering/GatheredArrays.h"

#include "vtkType.h"

#include <vector>

namespace DirectionFields::Parallel
{
/// For each polygon of one list one of another list with the same corners, in any order, or -1. In
/// linear time.
std::vector<vtkIdType> FindCells(const GatheredCells& cells, const GatheredCells& wanted);
}

#endif
