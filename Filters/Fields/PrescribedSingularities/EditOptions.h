// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_EditOptions_h
#define DirectionFields_EditOptions_h

#include "TrivialConnection/RotationObjective.h"
#include "Types.h"

namespace DirectionFields
{
/// A singularity that is asked for.
struct WantedSingularity
{
  /// In space, in the surface's unit of length; the singularity comes to the nearest point of the
  /// surface. Where it is not finite, SingularityEditor::Edit throws (without
  /// EditOptions::KeepsUnmet).
  Vector3 Position;
  /// In units of 1/n, of either sign; 0 is ignored.
  int Index = 1;
};

/// How singularities of a field are edited. The defaults stand here and nowhere else.
struct EditOptions
{
  /// The singularities are added to those of the given field; else they replace these in all
  /// connected components that have one.
  bool AddsToBase = false;
  /// The singularities are all that the surface is to have, as a list of SingularityHand: the given
  /// field's go wherever they are. Components that have none before and after keep their field.
  /// Without AddsToBase only.
  bool IsWholeList = false;
  /// Where indices do not add up, or no triangles can hold them, the component keeps its given
  /// field, with a sentence in EditedField::Notes; singularities without a place are left out.
  /// Else Edit throws.
  bool KeepsUnmet = false;
  RotationObjective Objective = RotationObjective::Smoothest;
  /// Adds the singularities that are missing where indices do not add up to n times the Euler
  /// characteristic (or, on regions enclosed by directions that are kept, to the number that these
  /// ask for). Else Edit throws there.
  bool Balances = false;
  /// tau, free of units, 0 to less than 1, as Options::AlignmentStrength: the field is drawn to the
  /// guidance without any change of its singularities. 0 for not at all.
  double AlignmentStrength = 0.0;
};
}

#endif
