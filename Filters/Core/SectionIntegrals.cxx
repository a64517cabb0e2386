// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SectionIntegrals.h"

#include <cmath>

namespace DirectionFields
{
namespace
{
/// 2^20 / 24!, the first term left out at the switch, is below rounding.
constexpr int SeriesTerms = 20;

/// 1 / (m + 4)!
const std::array<double, SeriesTerms>& InverseFactorials()
{
  static const std::array<double, SeriesTerms> values = []
  {
    std::array<double, SeriesTerms> inverse;
    double factorial = 24.0;
    for (int m = 0; m < SeriesTerms; ++m)
    {
      inverse[m] = 1.0 / factorial;
      factorial *= m + 5;
    }
    return inverse;
  }();
  return values;
}
}

SectionIntegrals SectionIntegrals::At(double omega)
{
  return std::abs(omega) < SwitchHolonomy ? Series(omega) : ClosedForm(omega);
}

SectionIntegrals SectionIntegrals::Series(double omega)
{
  // Horner's scheme in z^2 = -omega^2 for the even (real) and the odd (imaginary) terms.
  const std::array<double, SeriesTerms>& inverse = InverseFactorials();
  const double square = -omega * omega;
  std::array<double, 2> e4{};
  std::array<double, 2> f1{};
  std::array<double, 2> f2{};
  for (int m = SeriesTerms - 1; m >= 0; --m)
  {
    const int parity = m % 2;
    // The first terms of F1 and F2 follow another rule: 0 and -z/24, -1/4 and -z/24.
    const double c1 = m == 0 ? 0.0 : m == 1 ? 1.0 / 24.0 : 0.5 * (m + 1) * (m + 2) * inverse[m];
    const double c2 = m == 0 ? 0.25 : m == 1 ? 1.0 / 24.0 : (m + 2) * (m + 2) * inverse[m];
    e4[parity] = e4[parity] * square + inverse[m];
    f1[parity] = f1[parity] * square - c1;
    f2[parity] = f2[parity] * square - c2;
  }
  const auto sum = [omega](const std::array<double, 2>& s) { return Complex(s[0], omega * s[1]); };
  return { sum(e4), sum(f1), sum(f2) };
}

SectionIntegrals SectionIntegrals::ClosedForm(double omega)
{
  const Complex i(0.0, 1.0);
  const double o2 = omega * omega;
  const double o3 = o2 * omega;
  const double o4 = o2 * o2;
  const double o5 = o4 * omega;
  const Complex e = std::polar(1.0, omega);
  return { (e - 1.0 - i * omega + 0.5 * o2 + i * o3 / 6.0) / o4,
    (3.0 + i * omega + o4 / 24.0 - i * o5 / 60.0 + (-3.0 + 2.0 * i * omega + 0.5 * o2) * e) / o4,
    (4.0 + i * omega - i * o3 / 6.0 - o4 / 12.0 + i * o5 / 30.0 +
      (-4.0 + 3.0 * i * omega + o2) * e) /
      o4 };
}

LocalMatrices::LocalMatrices(const std::array<double, 3>& squaredLength, double area, double omega,
  const std::array<Complex, 3>& transport, double energyBias)
{
  const SectionIntegrals integrals = SectionIntegrals::At(omega);
  this->MassDiagonal = area / 6.0;
  for (int j = 0; j < 3; ++j)
  {
    const int k = (j + 1) % 3;
    const int i = (j + 2) % 3;
    const double jk = squaredLength[j];
    const double ki = squaredLength[k];
    const double ij = squaredLength[i];
    // <p_ij, p_ik>, at the corner opposite the edge jk.
    const double dot = 0.5 * (ij + ki - jk);

    // The diagonal entry of corner i.
    this->EnergyDiagonal[i] = (jk + omega * omega * (ij + dot + ki) / 90.0) / (4.0 * area) -
      energyBias * omega / 6.0;

    const Complex r = std::conj(transport[j]);
    this->Mass[j] = r * (2.0 * area * integrals.E4);
    const Complex dirichlet = r * (((ij + ki) * integrals.F1 + dot * integrals.F2) / area);
    this->Energy[j] =
      dirichlet - energyBias * (omega / area * this->Mass[j] - Complex(0.0, 0.5) * r);
  }
}
}
