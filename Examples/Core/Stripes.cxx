// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws stripes along the spokes of a ring. The outer circle is longer, hence stripes of one width
// branch in between: once for each line by which more of them reach the outer circle than the inner
// one.

#include <DirectionFields/Stripes.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

using namespace DirectionFields;

int main()
{
  constexpr Index around = 200, across = 40;
  Surface ring;
  for (Index k = 0; k < around * (across + 1); ++k)
  {
    const Index i = k % around, j = k / around, next = (i + 1) % around - i;
    const double angle = 2.0 * Pi * i / around, radius = 1.0 + 1.0 * j / across;
    ring.Points.push_back(radius * Vector3(std::cos(angle), std::sin(angle), 0.0));
    if (j < across)
    {
      ring.Triangles.push_back({ k, k + around, k + around + next });
      ring.Triangles.push_back({ k, k + around + next, k + next });
    }
  }
  PointDirections spokes;
  spokes.Degree = 1;
  spokes.Direction = [&](Index point, int) { return ring.Points[point].normalized(); };
  spokes.Magnitude = [](Index) { return 1.0; };
  StripeOptions options;
  options.Spacing = 0.1;
  options.Bands = false;
  const StripePattern pattern = MakeStripes(GivenField(ring, spokes), options);

  int outer = 0, inner = 0, branches = 0;
  for (std::size_t i = 0; i < pattern.Length.size(); ++i)
  {
    for (const int end : { 0, 1 })
    {
      const auto at = pattern.LineOffsets[i + end] - end;
      const bool isOuter = pattern.LinePositions[at].norm() > 1.5;
      (isOuter ? outer : inner) += pattern.EndSingularities[i][end] == None ? 1 : 0;
    }
  }
  for (const StripeSingularity& singularity : pattern.Singularities)
  {
    branches += singularity.StripeIndex;
  }
  std::printf(
    "%d lines reach the outer circle, %d the inner one: %d branches\n", outer, inner, branches);
  return outer - inner == branches && branches > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
