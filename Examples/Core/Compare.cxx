// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compares a cross field with the same field turned by 20 degrees: the angle between their directions at each point,
// the distances between their singularities, and the divergence and curl of a vector field.

#include "Surfaces.h"

#include <DirectionFields/Comparison/FieldDerivatives.h>
#include <DirectionFields/Comparison/FieldDifference.h>
#include <DirectionFields/DirectionField.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

using namespace DirectionFields;

int main()
{
  const Surface sphere = Sphere(16);
  const Result result = DirectionField(sphere).Compute(Options());

  // The other field comes as an array, four vectors a point, as from any program.
  std::vector<Vector3> turned;
  for (Index k = 0; k < static_cast<Index>(4 * sphere.Points.size()); ++k)
  {
    turned.push_back(std::cos(Pi / 9.0) * result.Direction(k / 4, k % 4) +
      std::sin(Pi / 9.0) * result.Direction(k / 4, (k + 1) % 4));
  }
  const GivenField one(sphere, DirectionsOf(result));
  const FieldDifference difference = Compare(one, DirectionsOf(result), DirectionsOf(4, turned));
  const std::vector<ComparedSingularity> matches =
    MatchSingularities(one, GivenField(sphere, DirectionsOf(4, turned)));
  const auto matched = std::count_if(matches.begin(), matches.end(),
    [](const ComparedSingularity& match) { return match.Match != None && match.Distance < 0.1; });
  std::printf("mean %.3f, maximum %.3f degrees, %d singularities have a partner nearby\n",
    difference.Mean, difference.Maximum, static_cast<int>(matched));

  // Along the meridians to the north the divergence is minus the tangent of the latitude, and the curl 0.
  std::vector<Vector3> north;
  for (const Vector3& p : sphere.Points)
  {
    north.push_back(Vector3::UnitZ() - p.z() * p);
  }
  const FieldDerivatives derivatives(GivenField(sphere, DirectionsOf(1, north)));
  double error = 0.0;
  for (std::size_t t = 0; t < sphere.Triangles.size(); ++t)
  {
    const double z = Center(sphere, t).normalized().z();
    const double excess = derivatives.Divergence[t] + z / std::sqrt(1.0 - z * z);
    error = std::max(error, z * z < 0.25 ? std::abs(excess) + std::abs(derivatives.Curl[t]) : 0.0);
  }
  std::printf("divergence and curl err by %.2f at most\n", error);
  const double from20 = std::abs(difference.Maximum - 20.0) + std::abs(difference.Mean - 20.0);
  return from20 < 1e-3 && matched == 16 && error < 0.1 ? EXIT_SUCCESS : EXIT_FAILURE;
}
