// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/VectorMath.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace DirectionFields;

namespace
{
constexpr double Rounding = 1e-15;
}

/// Of any length: functions for several numbers at once leave a remainder.
TEST(VectorMath, IsThatOfSingleNumbers)
{
  for (Index count = 0; count <= 67; ++count)
  {
    std::vector<double> angles(count);
    for (Index k = 0; k < count; ++k)
    {
      angles[k] = 40.0 * std::sin(1.0 + 3.7 * k);
    }
    std::vector<double> cosines(count);
    std::vector<double> sines(count);
    std::vector<double> arctangents(count);
    std::vector<double> arguments(count);
    CosinesAndSines(angles.data(), count, cosines.data(), sines.data());
    Arctangents(angles.data(), count, arctangents.data());
    std::vector<Complex> numbers(count);
    for (Index k = 0; k < count; ++k)
    {
      numbers[k] = Complex(cosines[k], sines[k]);
    }
    Arguments(numbers.data(), count, arguments.data());
    for (Index k = 0; k < count; ++k)
    {
      EXPECT_NEAR(cosines[k], std::cos(angles[k]), Rounding);
      EXPECT_NEAR(sines[k], std::sin(angles[k]), Rounding);
      EXPECT_NEAR(arctangents[k], std::atan(angles[k]), 2.0 * Rounding);
      EXPECT_NEAR(arguments[k], std::atan2(sines[k], cosines[k]), 4.0 * Rounding);
    }
  }
}

TEST(VectorMath, ArgumentsOnTheAxesAndOfAnyLength)
{
  for (const double length : { 1e-300, 1e-160, 1.0, 1e160, 1e300 })
  {
    const std::vector<Complex> numbers{ length, { 0.0, length }, -length, { 0.0, -length },
      { length, length }, { -length, length }, { length, -length } };
    const std::vector<double> expected{ 0.0, 0.5 * Pi, Pi, -0.5 * Pi, 0.25 * Pi, 0.75 * Pi,
      -0.25 * Pi };
    std::vector<double> angles(numbers.size());
    Arguments(numbers.data(), static_cast<Index>(numbers.size()), angles.data());
    for (std::size_t k = 0; k < numbers.size(); ++k)
    {
      EXPECT_NEAR(angles[k], expected[k], 4.0 * Rounding) << length << ", " << k;
    }
  }
  const std::vector<Complex> zeros(5, 0.0);
  std::vector<double> angles(5, 1.0);
  Arguments(zeros.data(), 5, angles.data());
  EXPECT_EQ(angles, std::vector<double>(5, 0.0));
}
