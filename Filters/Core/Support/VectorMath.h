// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_VectorMath_h
#define DirectionFields_VectorMath_h

#include "Types.h"

#include <cmath>

namespace DirectionFields::Internal
{
/// The modulus, for numbers whose squares neither overflow nor matter if they vanish: a third of the
/// time that std::abs takes.
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
void Arctangents(const double* values, Index count, double* angles);
/// The arguments of complex numbers, -pi to pi; 0 for 0.
void Arguments(const Complex* values, Index count, double* angles);
}

#endif
