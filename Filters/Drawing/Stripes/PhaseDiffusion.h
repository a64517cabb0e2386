// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_PhaseDiffusion_h
#define DirectionFields_PhaseDiffusion_h

#include "Matrices/Operators.h"
#include "Progress.h"
#include "Stripes/WantedPhases.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Phases whose steps along the edges match the wanted ones best: unit sections that are diffused
/// and scaled back to modulus 1 in turns, psi = x / |x| with (A + kappa M) x = kappa M psi. The
/// smallest eigenvector of A, the published choice, vanishes but for a few places where the wanted
/// changes do not integrate, so that its phases are noise; sections of modulus 1 cannot.
class PhaseDiffusion
{
public:
  PhaseDiffusion(const WantedPhases& wanted, const WantedPhases::Component& component);

  /// Phases that depend on the shape of the component only: noise in space, in the component's
  /// principal axes.
  ComplexVector Start() const;
  /// Relaxes a section of the matrices' rows. Throws Stopped.
  void Relax(const Progress& progress, ComplexVector& psi) const;
  /// The phases of a section in cycles, 0 to 1, over the nodes of the component.
  std::vector<double> Phases(const ComplexVector& psi) const;

  const Operators& GetMatrices() const { return this->Matrices; }
  /// The order of magnitude of the density of the flux, in 1 / unit^2, which says how fine the
  /// pattern of branch points is.
  double GetDensity() const { return this->Density; }

private:
  void MakeSymmetric(ComplexVector& psi) const;

  const WantedPhases& Wanted;
  const WantedPhases::Component& Component;
  Operators Matrices;
  double Density;
};

/// The root of the mean square of the differences between steps and wanted steps along the edges,
/// over that of the wanted steps: 0 for stripes of the wanted directions and spacing everywhere; 0
/// also where no stripes are wanted.
/// @param phases over all nodes, in cycles
double Misfit(const WantedPhases& wanted, const std::vector<double>& phases);
}

#endif
