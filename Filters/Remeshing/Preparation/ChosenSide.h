// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ChosenSide_h
#define DirectionFields_ChosenSide_h

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Which triangles of a mesh a surface consists of: all, but of a double cover one side of each,
/// chosen such that the line between the two sides is short. The front's own line may be jagged.
std::vector<char> ChosenSide(const TriangleMesh& mesh, const std::vector<Vector3>& points);
}

#endif
