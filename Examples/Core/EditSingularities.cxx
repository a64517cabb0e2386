// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Puts the singularities of a cross field on a sphere where they are wanted: near the corners of a cube, one moved
// away from its corner.

#include "Surfaces.h"

#include <DirectionFields/DirectionField.h>
#include <DirectionFields/PrescribedSingularities/EditedResult.h>
#include <DirectionFields/PrescribedSingularities/SingularityEditor.h>

#include <cstdio>
#include <cstdlib>

using namespace DirectionFields;

int main()
{
  const Surface sphere = Sphere(24);
  const Result field = DirectionField(sphere).Compute(Options());

  // Eight of index 1/4: the sum, in units of 1/n, has to be n times the Euler characteristic, 4 x 2.
  std::vector<WantedSingularity> wanted;
  for (int k = 0; k < 8; ++k)
  {
    const Vector3 corner(k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0);
    wanted.push_back(
      { (corner + (k == 0 ? Vector3(0.4, 0.1, 0.0) : Vector3(0.0, 0.05, 0.02))).normalized(), 1 });
  }

  SingularityEditor editor(sphere, DirectionsOf(field));
  const EditedField edited = editor.Edit(wanted);
  const Result result = ToResult(editor, edited);

  // Each is in a triangle near the place that was asked for.
  int found = 0;
  for (std::size_t t = 0; t < sphere.Triangles.size(); ++t)
  {
    for (std::size_t k = 0; result.SingularityIndex[t] == 1 && k < wanted.size(); ++k)
    {
      found += (Center(sphere, t) - wanted[k].Position).norm() < 0.06 ? 1 : 0;
    }
  }
  std::printf("%d of 8 singularities are where they were asked for, %d triangles are wrong\n",
    found, static_cast<int>(edited.WrongTriangles.size()));
  return found == 8 && edited.WrongTriangles.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
}
