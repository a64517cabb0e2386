// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/VectorMath.h"

#include <cmath>

// Compiled with options under which the compiler may take the C library's vector functions. Nothing
// but loops over those belongs here: elsewhere the options would change results.

namespace DirectionFields::Internal
{
void CosinesAndSines(const double* __restrict angles, Index count, double* __restrict cosines,
  double* __restrict sines)
{
  // In one loop the compiler would join the two to a function that exists for single numbers only.
  for (Index k = 0; k < count; ++k)
  {
    cosines[k] = std::cos(angles[k]);
  }
  for (Index k = 0; k < count; ++k)
  {
    sines[k] = std::sin(angles[k]);
  }
}

void Arctangents(const double* __restrict values, Index count, double* __restrict angles)
{
  for (Index k = 0; k < count; ++k)
  {
    angles[k] = std::atan(values[k]);
  }
}

void Arguments(const Complex* __restrict values, Index count, double* __restrict angles)
{
  // Pairs of numbers, as the standard guarantees.
  const auto* const parts = reinterpret_cast<const double*>(values);
  for (Index k = 0; k < count; ++k)
  {
    angles[k] = std::atan2(parts[2 * k + 1], parts[2 * k]);
  }
}
}
