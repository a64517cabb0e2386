// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_OutwardSides_h
#define DirectionFields_OutwardSides_h

#include "Surface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// For each triangle the side that is outside: 1 where the normal points there that its winding
/// gives, -1 where that points inwards, because the component encloses a negative volume or because
/// the triangle is wound against the others. 0 where there is no outside: on components that have a
/// boundary or cannot be oriented, and for triangles that are unsound or there twice.
///
/// Components are connected across seams, where points share places (FirstAcrossSeams). Anything
/// may be wrong with the surface. Takes linear time.
std::vector<signed char> OutwardSides(const Surface& surface);
}

#endif
