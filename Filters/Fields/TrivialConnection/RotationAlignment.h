// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RotationAlignment_h
#define DirectionFields_RotationAlignment_h

#include "TrivialConnection/TrivialConnection.h"

namespace DirectionFields::Internal
{
/// Turns a field towards a guidance q of degree n without any change of its indices. Minimizes the
/// energy of the rotation plus strength times the integral of |q| times the square of the
/// difference of the phases, which is wrapped anew a few times. Where that would move an index, the
/// strength is halved until none moves; where ten halvings do not help, the field stays as it is.
/// @param guidance q of each vertex of the component; its modulus is 1 in the mean square, after
///                 scaling
/// @param strength in 1 / unit^2
/// @return the part of the strength that was taken
double AlignField(TrivialConnection& rotation, const RotationTarget& target,
  const ComplexVector& guidance, double strength, const Progress& progress, TurnedField& field);

/// 2 pi n / area times tau / (1 - tau), as for aligned fields.
double StrengthOf(double alignmentStrength, int degree, double area);
}

#endif
