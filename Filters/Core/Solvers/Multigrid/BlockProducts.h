// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_BlockProducts_h
#define DirectionFields_BlockProducts_h

#include "Solvers/Matrices/Operators.h"

namespace DirectionFields
{
/// A x and M x of four sections in single precision (see CompactSections), A x added up in double
/// precision.
void Multiply(const Operators& operators, const float* x, float* ax, float* mx);
}

#endif
