// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Sections/SectionDirections.h"

#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index PieceSize = 1 << 13;

/// The direction of the principal square root.
Complex HalfTurned(const Complex& z)
{
  // The quotient by the larger part comes first: squares of small numbers underflow.
  const double larger = std::max(std::abs(z.real()), std::abs(z.imag()));
  Complex unit(z.real() / larger, z.imag() / larger);
  unit /= std::sqrt(std::norm(unit));
  // The larger of cosine and sine comes from the root, and the other follows without cancellation.
  if (unit.real() >= 0.0)
  {
    const double cosine = std::sqrt(0.5 + 0.5 * unit.real());
    return { cosine, 0.5 * unit.imag() / cosine };
  }
  const double sine = std::copysign(std::sqrt(0.5 - 0.5 * unit.real()), unit.imag());
  return { 0.5 * unit.imag() / sine, sine };
}

}

std::vector<Vector3> DirectionsOf(
  const std::vector<Complex>& section, const TangentFrames& frames, int degree)
{
  std::vector<Vector3> vectors(section.size(), Vector3::Zero());
  ParallelFor(static_cast<Index>(section.size()), PieceSize,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        if (section[v] != 0.0)
        {
          const Complex direction =
            degree == 2 ? HalfTurned(section[v]) : std::polar(1.0, std::arg(section[v]) / degree);
          vectors[v] = direction.real() * frames.X[v] + direction.imag() * frames.Y(v);
        }
      }
    });
  return vectors;
}
}
