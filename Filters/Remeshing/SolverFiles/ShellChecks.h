// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ShellChecks_h
#define DirectionFields_ShellChecks_h

#include "SolverFiles/ShellMesh.h"

namespace DirectionFields::Internal
{
/// Throws std::invalid_argument, its text a sentence for the user, for a mesh without faces, with
/// numbers of points or faces that there are not, coordinates that are no finite numbers, a face
/// without area, or another number of directions than of faces.
void CheckMesh(const ShellMesh& mesh);

/// 3 or 4.
int CornersOf(const std::array<Index, 4>& face);

/// Across a face, of the length of twice its area.
Vector3 NormalOf(const ShellMesh& mesh, const std::array<Index, 4>& face);
}

#endif
