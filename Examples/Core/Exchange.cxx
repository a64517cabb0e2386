// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes a field to a file for other programs, reads it back, and compares the two.

#include "Surfaces.h"

#include <DirectionFields/Comparison/FieldDifference.h>
#include <DirectionFields/DirectionField.h>
#include <DirectionFields/Exchange/FieldExport.h>
#include <DirectionFields/Exchange/FieldImport.h>

#include <cstdio>
#include <cstdlib>

using namespace DirectionFields;

int main()
{
  const Surface sphere = Sphere(16);
  const Result result = DirectionField(sphere).Compute(Options());
  const GivenField field(sphere, DirectionsOf(result));

  // A direction for each point; sphere.obj has the mesh, sphere.sharp its features, as QuadWild reads them.
  ExportOptions options;
  options.Format = FieldFormat::Rosy;
  options.On = FieldOn::Points;
  WriteFiles("sphere.rosy", ExportField(field, nullptr, options));

  const FieldFile file = ReadFieldFile("sphere.rosy");
  const ImportedField imported = ImportField(file, sphere, FieldOn::Points, true);
  const FieldDifference difference =
    Compare(field, DirectionsOf(result), DirectionsOf(imported.Field));
  std::printf("%d rows of degree %d, the directions differ by %.4f degrees\n",
    static_cast<int>(file.Rows()), file.Degree, difference.Maximum);
  return difference.Maximum < 1e-4 && imported.Field.SingularityIndex == result.SingularityIndex
    ? EXIT_SUCCESS
    : EXIT_FAILURE;
}
