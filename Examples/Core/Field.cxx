// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Computes the smoothest cross field of a surface like a potato and prints its singularities.

#include "Surfaces.h"

#include <DirectionFields/DirectionField.h>

#include <cstdio>
#include <cstdlib>

using namespace DirectionFields;

int main()
{
  Surface potato = Sphere(16);
  for (Vector3& p : potato.Points)
  {
    p = { 1.5 * p.x() + 0.3 * p.y() * p.y(), p.y() + 0.2 * p.x() * p.z(), 0.8 * p.z() };
  }
  Options options;
  options.Degree = 4;
  const Result field = DirectionField(potato).Compute(options);

  int sum = 0;
  int singularities = 0;
  for (std::size_t t = 0; t < potato.Triangles.size(); ++t)
  {
    const int index = field.SingularityIndex[t];
    if (index != 0)
    {
      const Vector3 place = Center(potato, t);
      std::printf("index %+d/4 at %.1f %.1f %.1f\n", index, place.x(), place.y(), place.z());
      ++singularities;
    }
    sum += index;
  }

  // At each point there are four unit directions, a quarter of a turn apart.
  bool isCross = true;
  for (Index i = 0; i < static_cast<Index>(potato.Points.size()); ++i)
  {
    isCross = isCross && std::abs(field.Direction(i, 0).norm() - 1.0) < 1e-9 &&
      (field.Direction(i, 0) + field.Direction(i, 2)).norm() < 1e-9 &&
      std::abs(field.Direction(i, 0).dot(field.Direction(i, 1))) < 1e-9;
  }
  std::printf("%d singularities, index sum %d = 4 x 2\n", singularities, sum);
  // Poincaré and Hopf: the sum is the degree times the Euler characteristic.
  return isCross && sum == 8 && field.Components[0].Converged ? EXIT_SUCCESS : EXIT_FAILURE;
}
