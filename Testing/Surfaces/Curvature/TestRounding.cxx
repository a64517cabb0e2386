// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curvature/Rounding.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>

using namespace DirectionFields;
using namespace DirectionFields::Internal;
using namespace Meshes;

namespace
{
using Round = double (*)(double);
double ErrorOf(Surface surface, Round round)
{
  for (Vector3& p : surface.Points)
  {
    p = { round(p.x()), round(p.y()), round(p.z()) };
  }
  const TriangleMesh mesh(surface);
  return RoundingError(mesh.Positions(surface.Points), mesh.GetComponents()[0]);
}

/// GCC 12 leaves the rounding out where a number is turned into one of single precision and back at
/// once.
double Single(double x)
{
  const volatile auto rounded = static_cast<float>(x);
  return rounded;
}

double Digits(double x, int digits)
{
  std::string text(40, ' ');
  std::snprintf(text.data(), text.size(), "%.*g", digits, x);
  return std::atof(text.c_str());
}
}

TEST(Rounding, IsSeenInTheNumbersThemselves)
{
  // Coordinates of up to about 14.
  const Surface surface =
    Transformed(Potato(3), 10.0 * ObliqueRotation(1.0), { 0.1234567, 2.3456789, -1.0 });
  double largest = 0.0;
  for (const Vector3& p : surface.Points)
  {
    largest = std::max(largest, p.lpNorm<Eigen::Infinity>());
  }
  ASSERT_GT(largest, 10.0);
  EXPECT_NEAR(ErrorOf(surface, [](double x) { return x; }), largest * std::pow(2.0, -53), 1e-18);
  const double single = ErrorOf(surface, &Single);
  EXPECT_NEAR(single, largest * std::pow(2.0, -24), 1e-9);
  EXPECT_NEAR(ErrorOf(surface, [](double x) { return Digits(x, 6); }), 5e-5, 1e-18);
  EXPECT_NEAR(ErrorOf(surface, [](double x) { return Digits(x, 7); }), 5e-6, 1e-18);
  // A reader of six digits that keeps single precision.
  EXPECT_NEAR(ErrorOf(surface, [](double x) { return Single(Digits(x, 6)); }), 5e-5, 1e-18);
}

TEST(Rounding, ZerosHaveNone)
{
  EXPECT_EQ(ErrorOf(Square(2), [](double) { return 0.0; }), 0.0);
}
