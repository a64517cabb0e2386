// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SectionIntegrals_h
#define DirectionFields_SectionIntegrals_h

#include "Types.h"

namespace DirectionFields
{
/// The functions of the holonomy Omega of a triangle in the integrals of two hat sections, which are
/// transported radially from their vertices over a triangle of constant curvature (KCPS13,
/// appendix D). With z = i Omega:
///
/// E4 = (exp(z) - 1 - z - z^2/2 - z^3/6) / z^4,
/// F1, F2: the coefficients of |p_ij|^2 + |p_ki|^2 and <p_ij, p_ik> in the Dirichlet energy.
struct SectionIntegrals
{
  Complex E4;
  Complex F1;
  Complex F2;

  /// Below this |Omega| the power series is summed, above it the closed form: that loses all digits
  /// near 0, the series converges slowly far from it.
  static constexpr double SwitchHolonomy = 2.0;

  /// Accurate to 1e-13 for any Omega.
  static SectionIntegrals At(double omega);
  static SectionIntegrals Series(double omega);
  static SectionIntegrals ClosedForm(double omega);
};

/// Integrals over one triangle of positive area, its corners 0, 1, 2 counter-clockwise. Entry
/// [c] of the off-diagonal arrays belongs to the row of corner c and the column of corner c + 1.
struct LocalMatrices
{
  std::array<double, 3> EnergyDiagonal;
  std::array<Complex, 3> Energy;
  double MassDiagonal;
  std::array<Complex, 3> Mass;

  /// @param squaredLength |p|^2 of the edges from corner c to c + 1
  /// @param area          area of the triangle
  /// @param omega         its holonomy, not wrapped
  /// @param transport     r of the edges from corner c to c + 1, of modulus 1
  /// @param energyBias    s
  LocalMatrices(const std::array<double, 3>& squaredLength, double area, double omega,
    const std::array<Complex, 3>& transport, double energyBias);
};
}

#endif
