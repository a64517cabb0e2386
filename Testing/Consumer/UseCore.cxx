// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The field of a tetrahedron, without VTK.

#include <DirectionFields/DirectionField.h>

// These names may be the consumer's own.
#if __has_include(<Options.h>) || __has_include(<Types.h>) || __has_include(<DirectionField.h>)
#error "Headers of Direction Fields lie bare on the include path."
#endif

#include <cstdlib>
#include <iostream>

int main()
{
  DirectionFields::Surface surface;
  surface.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  surface.Triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
  DirectionFields::Options options;
  options.Degree = 4;
  const auto field = DirectionFields::DirectionField(surface).Compute(options);
  std::cout << "Index sum: " << field.Components.at(0).IndexSum << std::endl;
  return field.Components.at(0).IndexSum == 8 ? EXIT_SUCCESS : EXIT_FAILURE;
}
