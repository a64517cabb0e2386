// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Traces the smoothest cross field of a sphere. Evenly spaced streamlines have, for each of the two
// families, the area over the spacing for their length. A singularity of index i / 4 has 4 - i
// streamlines, and all indices i sum up to 4 x 2: S singularities have 4 S - 8.

#include <DirectionFields/DirectionField.h>
#include <DirectionFields/Streamlines.h>

#include <cstdio>
#include <cstdlib>
#include <numeric>

using namespace DirectionFields;

int main()
{
  // The unit sphere: a cube of 6 x 20 x 20 squares, blown up. Points in one place become one.
  constexpr Index n = 20;
  Surface sphere;
  for (Index k = 0; k < 6 * (n + 1) * (n + 1); ++k)
  {
    const Index i = k % (n + 1), j = k / (n + 1) % (n + 1), face = k / ((n + 1) * (n + 1));
    const double side = face % 2 == 0 ? -1.0 : 1.0;
    const Vector3 p(side * n, side * (2 * i - n), 2 * j - n);
    const Index x = face / 2, y = (x + 1) % 3, z = (x + 2) % 3;
    sphere.Points.push_back(Vector3(p[x], p[y], p[z]).normalized());
    if (i < n && j < n)
    {
      sphere.Triangles.push_back({ k, k + 1, k + n + 2 });
      sphere.Triangles.push_back({ k, k + n + 2, k + n + 1 });
    }
  }
  Options options;
  options.Degree = 4;
  const Result result = DirectionField(sphere).Compute(options);

  const PointDirections directions = DirectionsOf(result);
  const GivenField field(sphere, directions);
  const Streamlines even = TraceStreamlines(field, directions);
  const double length = std::accumulate(even.Length.begin(), even.Length.end(), 0.0);
  const double cover = length * even.Spacing / (2.0 * 4.0 * Pi);
  StreamlineOptions outOfSingularities;
  outOfSingularities.Seeds = SeedType::Singularities;
  const Streamlines rays = TraceStreamlines(field, directions, {}, outOfSingularities);
  std::printf("%zu streamlines cover the sphere: length times spacing is %.1f of the area\n",
    even.Length.size(), cover);
  std::printf("%zu singularities, %zu streamlines\n", rays.Nodes.size(), rays.Length.size());
  const bool isRight =
    cover > 0.8 && cover < 1.4 && rays.Length.size() == 4 * rays.Nodes.size() - 8;
  return isRight ? EXIT_SUCCESS : EXIT_FAILURE;
}
