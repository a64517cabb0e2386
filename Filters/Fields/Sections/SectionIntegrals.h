// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SectionIntegrals_h
#define DirectionFields_SectionIntegrals_h

#include "Types.h"

namespace DirectionFields::Internal
{
/// The functions of the holonomy Omega of a triangle in the integrals of two hat sections, which
/// are transported radially from their vertices over a triangle of constant curvature (KCPS13,
/// appendix D). With z = i Omega:
///
/// E4 = (exp(z) - 1 - z - z^2/2 - z^3/6) / z^4, F1, F2: the coefficients of |p_ij|^2 + |p_ki|^2 and
/// <p_ij, p_ik> in the Dirichlet energy.
struct SectionIntegrals
{
  Complex E4;
  Complex F1;
  Complex F2;

  /// Below this |Omega| the power series is summed, above it the closed form: that loses all digits
  /// near 0, the series converges slowly far from it.
  static constexpr double SwitchHolonomy = 2.0;

  /// Accurate to 1e-13 for any Omega. Sums as many terms as matter.
  static SectionIntegrals At(double omega);
  /// Sums as many terms as are needed up to SwitchHolonomy.
  static SectionIntegrals Series(double omega);
  static SectionIntegrals ClosedForm(double omega);
};

/// Integrals over one triangle of positive area, its corners 0, 1, 2 counter-clockwise, of hat
/// sections that are not transported between its corners: entry [c] of the row of corner c and the
/// column of corner c + 1 is yet to be multiplied by conj(r) of that edge.
class LocalIntegrals
{
public:
  /// @param squaredLength |p|^2 of the edges from corner c to c + 1
  /// @param area          area of the triangle
  /// @param omega         its holonomy, not wrapped
  /// @param energyBias    s
  LocalIntegrals(
    const std::array<double, 3>& squaredLength, double area, double omega, double energyBias)
    : Functions(SectionIntegrals::At(omega))
    , SquaredLength(squaredLength)
    , Area(area)
    , Omega(omega)
    , EnergyBias(energyBias)
  {
  }

  double EnergyDiagonal(int c) const
  {
    const int next = (c + 1) % 3;
    const double spread =
      this->SquaredLength[c] + this->DotAt(c) + this->SquaredLength[(c + 2) % 3];
    return (this->SquaredLength[next] + this->Omega * this->Omega * spread / 90.0) /
      (4.0 * this->Area) -
      this->EnergyBias * this->Omega / 6.0;
  }

  Complex Energy(int c) const
  {
    const int next = (c + 1) % 3;
    const int previous = (c + 2) % 3;
    const double sum = this->SquaredLength[next] + this->SquaredLength[previous];
    const Complex dirichlet =
      (sum * this->Functions.F1 + this->DotAt(previous) * this->Functions.F2) / this->Area;
    return dirichlet -
      this->EnergyBias * (2.0 * this->Omega * this->Functions.E4 - Complex(0.0, 0.5));
  }

  double MassDiagonal() const { return this->Area / 6.0; }
  /// The same for all edges.
  Complex Mass() const { return 2.0 * this->Area * this->Functions.E4; }

private:
  /// The scalar product of the two edges from a corner.
  double DotAt(int c) const
  {
    return 0.5 *
      ((this->SquaredLength[c] + this->SquaredLength[(c + 2) % 3]) -
        this->SquaredLength[(c + 1) % 3]);
  }

  SectionIntegrals Functions;
  std::array<double, 3> SquaredLength;
  double Area;
  double Omega;
  double EnergyBias;
};
}

#endif
