// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_StripeMatrices_h
#define DirectionFields_StripeMatrices_h

#include "Matrices/Operators.h"
#include "Stripes/WantedPhases.h"

namespace DirectionFields::Internal
{
/// Energy and mass matrix of the sections psi = exp(i alpha) of a component, which are parallel
/// where alpha changes as is wanted: KCPS13's integrals, the steps in place of the parallel
/// transport and their sum around a triangle, not wrapped, in place of its curvature. In units of
/// the component's mean edge length.
///
/// Row v belongs to the node FirstNode + v. With two sheets, rows 2 v and 2 v + 1 do: on the second
/// sheet alpha has the opposite sign. Complex conjugation and the change of sheets together commute
/// with both matrices. Triangles whose steps flip an odd number of times have no integrals, since
/// the sheets meet in their middles; their edges draw their ends together as an even triangle's do.
/// @param withSteps false: for functions on the sheets in place of phases, as if no steps were
///                  wanted
Operators AssembleStripeMatrices(
  const WantedPhases& wanted, const WantedPhases::Component& component, bool withSteps = true);

/// The sum of the moduli of the fluxes of the triangles that have integrals, in radians, each
/// triangle in space once.
double TotalFlux(const WantedPhases& wanted, const WantedPhases::Component& component);
}

#endif
