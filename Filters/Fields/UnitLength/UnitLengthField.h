// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_UnitLengthField_h
#define DirectionFields_UnitLengthField_h

#include "Matrices/FreeVertices.h"
#include "Multigrid/Hierarchy.h"
#include "Progress.h"
#include "UnitLength/UnitLengthProblem.h"

namespace DirectionFields::Internal
{
/// How a unit field came about.
struct UnitLengthReport
{
  /// The energy of the start, scaled to modulus 1, and of the field.
  double EnergyBefore = 0.0;
  double EnergyAfter = 0.0;
  int CancelledPairs = 0;
  /// Steps of diffusion and of descent.
  int Steps = 0;
};

struct UnitLengthSettings
{
  /// The cost of a singularity of index 1, in the unit of the energy; at least 0.
  double SingularityCost = 0.0;
  /// The order of magnitude of the smallest eigenvalue, in 1 / unit^2: diffusion takes times of the
  /// order of its inverse.
  double Rate = 1.0;
  /// How strongly the guidance draws: the mean of |p| over the mass at a vertex; 0 without
  /// guidance.
  double Pull = 0.0;
  /// The number of starts, of which the best field is kept; 0 for one, or more on small surfaces.
  int Starts = 0;
};

/// Makes of a section one of modulus 1 with less energy: diffusion, descent in the phases, and
/// pairs of singularities that cancel each other. It is a local minimum, which depends on the
/// start; it is never worse than that, the cost of its singularities included. Further starts are
/// random. Throws Stopped.
/// @param hierarchy of the matrices among the free vertices
/// @param free      the free vertices; null where all are
/// @param u         the start; its value at given vertices is the one given, of modulus 1
UnitLengthReport MakeUnitLength(const UnitLengthProblem& problem, const Hierarchy& hierarchy,
  const FreeVertices* free, const UnitLengthSettings& settings, const Progress& progress,
  ComplexVector& u);
}

#endif
