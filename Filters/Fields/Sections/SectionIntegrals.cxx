// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Sections/SectionIntegrals.h"

#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// The first term of E4 that is left out is 2^20 / 24! at the switch, which is below rounding.
constexpr int MostTerms = 20;

/// The coefficients of z^m in E4, -F1 and -F2.
struct Coefficients
{
  std::array<double, MostTerms> E4{};
  std::array<double, MostTerms> F1{};
  std::array<double, MostTerms> F2{};

  constexpr Coefficients()
  {
    double factorial = 24.0;
    for (int m = 0; m < MostTerms; ++m)
    {
      // 1 / (m + 4)!
      this->E4[m] = 1.0 / factorial;
      factorial *= m + 5;
      // The first terms of F1 and F2 follow another rule.
      this->F1[m] = m == 0 ? 0.0 : m == 1 ? 1.0 / 24.0 : 0.5 * (m + 1) * (m + 2) * this->E4[m];
      this->F2[m] = m == 0 ? 0.25 : m == 1 ? 1.0 / 24.0 : (m + 2) * (m + 2) * this->E4[m];
    }
  }
};

/// Horner's scheme in z^2 = -omega^2 for the even (real) and the odd (imaginary) terms.
template <int Terms>
SectionIntegrals Sum(double omega)
{
  static_assert(Terms % 2 == 0, "Even and odd terms come in pairs.");
  constexpr Coefficients c;
  const double square = -omega * omega;
  const auto sum = [&](const std::array<double, MostTerms>& terms)
  {
    double even = 0.0;
    double odd = 0.0;
    for (int m = Terms - 2; m >= 0; m -= 2)
    {
      even = even * square + terms[m];
      odd = odd * square + terms[m + 1];
    }
    return Complex(even, omega * odd);
  };
  return { sum(c.E4), -sum(c.F1), -sum(c.F2) };
}
}

SectionIntegrals SectionIntegrals::At(double omega)
{
  // The first term of F2 that is left out is less than 1e-15.
  const double size = std::abs(omega);
  return size < 0.01        ? Sum<6>(omega)
    : size < 0.06           ? Sum<8>(omega)
    : size < 0.3            ? Sum<12>(omega)
    : size < SwitchHolonomy ? Series(omega)
                            : ClosedForm(omega);
}

SectionIntegrals SectionIntegrals::Series(double omega)
{
  return Sum<MostTerms>(omega);
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
}
