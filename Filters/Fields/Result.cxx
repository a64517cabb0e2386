// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Result.h"

#include "Support/VectorMath.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace DirectionFields
{
void Result::FirstAngles(Index begin, Index end, double* angles) const
{
  assert(end - begin <= FewPoints);
  const double period = 2.0 * Pi / this->Degree;
  const Index count = end - begin;
  std::array<Complex, FewPoints> axis;
  std::array<double, FewPoints> wanted;
  for (Index i = 0; i < count; ++i)
  {
    const Vector3& normal = this->Normal[begin + i];
    // The angle wanted is that of the x axis of space, or of the y axis where x is nearly normal.
    const int c = std::abs(normal[0]) < 1.0 - 1e-6 ? 0 : 1;
    const Vector3& x = this->XAxis[begin + i];
    axis[i] = Complex(x[c], normal.cross(x)[c]);
  }
  Arguments(axis.data(), count, wanted.data());
  Arguments(this->Representation.data() + begin, count, angles);
  for (Index i = 0; i < count; ++i)
  {
    angles[i] /= this->Degree;
    angles[i] += period * std::round((wanted[i] - angles[i]) / period);
  }
}

Vector3 Result::Direction(Index point, int k) const
{
  double angle;
  this->FirstAngles(point, point + 1, &angle);
  angle += k * (2.0 * Pi / this->Degree);
  const Vector3& x = this->XAxis[point];
  return std::cos(angle) * x + std::sin(angle) * this->Normal[point].cross(x);
}

void Result::Directions(Index begin, Index end, Vector3* directions) const
{
  const Complex turn = std::polar(1.0, 2.0 * Pi / this->Degree);
  for (Index first = begin; first < end; first += FewPoints)
  {
    const Index last = std::min(end, first + FewPoints);
    std::array<double, FewPoints> angle;
    this->FirstAngles(first, last, angle.data());
    std::array<double, FewPoints> cosine;
    std::array<double, FewPoints> sine;
    CosinesAndSines(angle.data(), last - first, cosine.data(), sine.data());
    for (Index i = first; i < last; ++i)
    {
      const Vector3& x = this->XAxis[i];
      const Vector3 y = this->Normal[i].cross(x);
      Complex z(cosine[i - first], sine[i - first]);
      for (int k = 0; k < this->Degree; ++k, z *= turn)
      {
        *directions++ = z.real() * x + z.imag() * y;
      }
    }
  }
}
}
