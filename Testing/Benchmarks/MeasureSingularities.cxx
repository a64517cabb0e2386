// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The time of edits of singularities beside that of the smoothest field of the same mesh: MeasureSingularities [LEVELS],
// with 20 * 4^LEVELS triangles. Prints seconds of the processor, the ratio to the field, and how many triangles are wrong.

#include "DirectionField.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "PrescribedSingularities/EditedResult.h"
#include "Support/Threads.h"

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <string>

using namespace DirectionFields;

namespace
{
double Seconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The corners of a cube, one of them moved by a step.
std::vector<WantedSingularity> Corners(double step)
{
  std::vector<WantedSingularity> corners;
  for (int k = 0; k < 8; ++k)
  {
    corners.push_back({ Vector3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1).normalized(), 1 });
  }
  corners.back().Position[0] -= step;
  return corners;
}
}

int main(int argc, char** argv)
{
  const int levels = argc > 1 ? std::atoi(argv[1]) : 7;
  const Surface surface = Meshes::Potato(levels);
  Threads threads;
  const Threads::Scope scope(threads);
  double begin = Seconds();
  const Result field = Fields::Compute(surface, 4);
  const double whole = Seconds() - begin;
  std::cout << surface.Triangles.size() << " triangles, smoothest field: " << whole << " s\n";
  const auto report = [&](const std::string& what, const EditedField& edited)
  {
    const double seconds = Seconds() - begin;
    std::cout << what << ": " << seconds << " s, " << 100.0 * seconds / whole << " %, "
              << edited.WrongTriangles.size() << " wrong\n";
  };
  // The directions lie in arrays, as those that a filter reads.
  std::vector<Vector3> directions(surface.Points.size());
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    directions[i] = field.Direction(static_cast<int>(i), 0);
  }
  PointDirections base = Fields::Of(field);
  base.Direction = [&](Index point, int) { return directions[point]; };
  begin = Seconds();
  SingularityEditor editor(surface, base);
  EditedField edited = editor.Edit(Corners(0.0), {}, {});
  report("first edit", edited);
  for (const double step : { 0.02, 0.04, 0.06 })
  {
    begin = Seconds();
    edited = editor.Edit(Corners(step), {}, {});
    report("further edit", edited);
  }
  EditOptions least;
  least.Objective = RotationObjective::LeastChange;
  begin = Seconds();
  edited = editor.Edit(Corners(0.08), least, {});
  report("least change", edited);
  begin = Seconds();
  const Result result = ToResult(editor, edited);
  report("arrays", edited);
  return result.Components.empty() ? 1 : 0;
}
