// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LocalMatrices_h
#define DirectionFields_LocalMatrices_h

#include "Sections/SectionIntegrals.h"

#include <array>

namespace Meshes
{
using namespace DirectionFields;

/// The integrals over one triangle with the transport. Entry [c] of the off-diagonal arrays belongs to
/// the row of corner c and the column of corner c + 1.
struct LocalMatrices
{
  std::array<double, 3> EnergyDiagonal;
  std::array<Complex, 3> Energy;
  double MassDiagonal;
  std::array<Complex, 3> Mass;

  /// @param transport r of the edges from corner c to c + 1, of modulus 1
  LocalMatrices(const std::array<double, 3>& squaredLength, double area, double omega,
    const std::array<Complex, 3>& transport, double energyBias)
  {
    const LocalIntegrals integrals(squaredLength, area, omega, energyBias);
    this->MassDiagonal = integrals.MassDiagonal();
    for (int c = 0; c < 3; ++c)
    {
      this->EnergyDiagonal[c] = integrals.EnergyDiagonal(c);
      this->Energy[c] = std::conj(transport[c]) * integrals.Energy(c);
      this->Mass[c] = std::conj(transport[c]) * integrals.Mass();
    }
  }
};
}

#endif
