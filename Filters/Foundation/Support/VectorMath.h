// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_VectorMath_h
#define DirectionFields_VectorMath_h

#include "Types.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace DirectionFields::Internal
{
/// The modulus, for numbers whose squares neither overflow nor matter if they vanish: a third of
/// the time that std::abs takes.
inline double Modulus(const Complex& z)
{
  return std::sqrt(std::norm(z));
}

/// A unit vector orthogonal to a unit vector.
inline Vector3 AnyOrthogonal(const Vector3& unit)
{
  Eigen::Index smallest;
  unit.cwiseAbs().minCoeff(&smallest);
  return unit.cross(Vector3::Unit(smallest)).normalized();
}

/// Elementary functions of many finite numbers at once. Where the C library has them for vectors of
/// numbers, they take a third of the time, and are accurate to a few units in the last place.

/// @param angles in radians
void CosinesAndSines(const double* angles, Index count, double* cosines, double* sines);
/// The same for k = begin ... end - 1: angle(k) gives an angle, set(k, cosine, sine) takes both.
template <typename Angle, typename Set>
void ForCosinesAndSines(Index begin, Index end, const Angle& angle, const Set& set)
{
  constexpr Index most = 64;
  std::array<double, most> angles;
  std::array<double, most> cosines;
  std::array<double, most> sines;
  for (Index first = begin; first < end; first += most)
  {
    const Index count = std::min(most, end - first);
    for (Index k = 0; k < count; ++k)
    {
      angles[k] = angle(first + k);
    }
    CosinesAndSines(angles.data(), count, cosines.data(), sines.data());
    for (Index k = 0; k < count; ++k)
    {
      set(first + k, cosines[k], sines[k]);
    }
  }
}
void Arctangents(const double* values, Index count, double* angles);
/// The arguments of complex numbers, -pi to pi; 0 for 0.
void Arguments(const Complex* values, Index count, double* angles);
}

#endif
