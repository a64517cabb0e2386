// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curvature/Rounding.h"

#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace DirectionFields::Internal
{
namespace
{
/// The power of ten of the first digit of a positive number.
double Decade(double x)
{
  return std::floor(std::log10(x));
}

/// Whether a number has at most this number of decimal digits, within the rounding of single
/// precision.
bool HasDigits(double x, int digits, double tolerance)
{
  const double size = std::abs(x);
  if (!(size > std::numeric_limits<float>::min()) || size > std::numeric_limits<float>::max())
  {
    return size == 0.0;
  }
  const double scaled = size * std::pow(10.0, digits - 1 - Decade(size));
  return std::abs(scaled - std::round(scaled)) <= tolerance * scaled;
}

void Add(double x, Precision& precision)
{
  constexpr double single = std::numeric_limits<float>::epsilon();
  constexpr double few = 16.0 * std::numeric_limits<double>::epsilon();
  precision.Largest = std::max(precision.Largest, std::abs(x));
  precision.IsSingle = precision.IsSingle && static_cast<double>(static_cast<float>(x)) == x;
  precision.HasSixDigits = precision.HasSixDigits && HasDigits(x, 6, single);
  // Single precision tells no seven digits apart.
  precision.HasSevenDigits = precision.HasSevenDigits && HasDigits(x, 7, few);
}
}

Precision& Precision::operator+=(const Precision& other)
{
  this->Largest = std::max(this->Largest, other.Largest);
  this->IsSingle = this->IsSingle && other.IsSingle;
  this->HasSixDigits = this->HasSixDigits && other.HasSixDigits;
  this->HasSevenDigits = this->HasSevenDigits && other.HasSevenDigits;
  return *this;
}

double Precision::RoundingError() const
{
  if (this->Largest > 0.0 && (this->HasSixDigits || this->HasSevenDigits))
  {
    return 0.5 * std::pow(10.0, Decade(this->Largest) - (this->HasSixDigits ? 5 : 6));
  }
  return 0.5 * this->Largest *
    (this->IsSingle ? std::numeric_limits<float>::epsilon()
                    : std::numeric_limits<double>::epsilon());
}

Precision PrecisionOf(
  const std::vector<Vector3>& positions, const TriangleMesh::Component& component)
{
  return ParallelSum<Precision>(component.Vertices(), LightPiece, {},
    [&](Index begin, Index end)
    {
      Precision part;
      for (Index v = component.FirstVertex + begin; v < component.FirstVertex + end; ++v)
      {
        for (const double x : positions[v])
        {
          Add(x, part);
        }
      }
      return part;
    });
}

double RoundingError(
  const std::vector<Vector3>& positions, const TriangleMesh::Component& component)
{
  return PrecisionOf(positions, component).RoundingError();
}
}
