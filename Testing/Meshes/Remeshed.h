// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Remeshed_h
#define DirectionFields_Remeshed_h

#include "Remesh.h"

#include <string>

/// Statements that hold for the mesh that is made of any surface.
namespace Meshes
{
/// The first statement that does not hold; empty if all do: sizes, finite points all of which are
/// used, edges of at most two faces that are wound consistently, one fan of faces at each vertex, the
/// Euler characteristic of the surface, and the sum of all valences' and corners' deviations from the regular
/// ones, which that determines.
std::string FlawOf(const DirectionFields::RemeshResult& mesh);

/// The least scaled Jacobian of the faces; 1 without any.
double LeastQuality(const DirectionFields::RemeshResult& mesh);

/// The loops that the boundary consists of.
int CountBoundaryLoops(const DirectionFields::RemeshResult& mesh);
int CountBoundaryLoops(const DirectionFields::Surface& surface);
}

#endif
