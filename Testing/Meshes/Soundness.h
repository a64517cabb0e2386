// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Soundness_h
#define DirectionFields_Soundness_h

#include "DirectionField.h"

#include <string>

/// Statements that hold for the field of any surface that is not refused, whatever is wrong with it.
namespace Meshes
{
/// The first statement that does not hold; empty if all do: sizes, unit tangent directions
/// at the used points and none elsewhere, finite figures, indices that sum up to n times the Euler
/// characteristic over closed components.
std::string Flaw(const DirectionFields::Surface& surface, const DirectionFields::Options& options,
  const DirectionFields::Result& result);
}

#endif
