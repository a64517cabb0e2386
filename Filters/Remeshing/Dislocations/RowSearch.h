// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RowSearch_h
#define DirectionFields_RowSearch_h

#include "Dislocations/RowEdits.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The rows that bring the edges of a mesh closest to their wanted lengths: of each chain the part
/// along which two rows more or less do most, and of all chains those that do most first, as long
/// as they are not near each other. Takes time in proportion to the mesh.
/// @param wanted length of the edges at each vertex
std::vector<RowEdit> FindRows(
  const FaceMesh& mesh, const EdgeLoops& chains, const std::vector<double>& wanted);
}

#endif
