// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Times the smoothest, the curvature-aligned and the constrained cross field on finer and finer
// meshes of one shape, from the arrays of the mesh to the indices, and prints a table as CSV. As
// figure 4.6 and table 4.1 of C. Clemenz' thesis have it, each time contains all that the field
// needs; the aligned and the constrained field need the smoothest first.
//
//   TimeOverPolygons [LEVELS]     20 4^level polygons for the levels 3 to LEVELS, default 7

#include "DirectionField.h"
#include "Meshes/Surfaces.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

using namespace DirectionFields;

namespace
{
constexpr int Repetitions = 3;

/// Least of several times, in seconds: the rest is the machine's.
double Time(const Surface& surface, const Options& options)
{
  double least = 1e300;
  for (int k = 0; k < Repetitions; ++k)
  {
    const auto begin = std::chrono::steady_clock::now();
    const Result result = DirectionField(surface).Compute(options);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    least = std::min(least, time.count());
    if (!result.Components.at(0).Converged)
    {
      std::fprintf(stderr, "The field has not converged.\n");
      std::exit(1);
    }
  }
  return least;
}
}

int main(int argc, char* argv[])
{
  const int last = argc > 1 ? std::atoi(argv[1]) : 7;
  if (last < 3 || last > 9)
  {
    std::fprintf(stderr, "LEVELS is a number from 3 to 9.\n");
    return 1;
  }
  std::printf("polygons,vertices,smooth,aligned,constrained\n");
  for (int level = 3; level <= last; ++level)
  {
    const Surface surface = Meshes::Potato(level);
    Options aligned;
    aligned.Alignment = Alignment::PrincipalCurvature;
    Options constrained = aligned;
    constrained.ConstrainBoundary = true;
    constrained.ConstrainSharpEdges = true;
    constrained.ConstrainCurvature = true;
    constrained.CurvatureTolerance = 1.0;
    std::printf("%zu,%zu,%.6f,%.6f,%.6f\n", surface.Triangles.size(), surface.Points.size(),
      Time(surface, {}), Time(surface, aligned), Time(surface, constrained));
    std::fflush(stdout);
  }
}
