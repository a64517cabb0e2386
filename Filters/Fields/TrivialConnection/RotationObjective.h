// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RotationObjective_h
#define DirectionFields_RotationObjective_h

namespace DirectionFields
{
/// Which of the fields with the prescribed singularities is taken: the one whose sum over the edges
/// of weight times the square of an angle is least.
enum class RotationObjective
{
  /// The angle is the field's rotation along the edge: the smoothest field.
  Smoothest = 0,
  /// The angle is the rotation less that of the given field: the field that is changed least.
  LeastChange = 1
};
}

#endif
