// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_BoundaryAdvice_h
#define DirectionFields_BoundaryAdvice_h

#include "Boundary/BoundarySpacing.h"
#include "FaceMesh/FaceMesh.h"

#include <string>
#include <vector>

namespace DirectionFields::Internal
{
/// Sentences for the user on a boundary that could not be as it is wanted, and on triangles among
/// quads where none are wanted.
/// @param triangles that are left although quads only are wanted, else 0
std::vector<std::string> BoundaryAdvice(
  const FaceMesh& mesh, const BoundaryFigures& figures, BoundarySpacing spacing, Index triangles);
}

#endif
