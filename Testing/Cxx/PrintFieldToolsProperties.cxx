// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints default and range of each property of the filters that use fields, and of the writer, as JSON by the names
// that ParaView has for them, for the comparison with the server manager's. Switches have no range.

#include "vtkCompareDirectionFields.h"
#include "vtkDirectionFieldReader.h"
#include "vtkDirectionFieldWriter.h"
#include "vtkGuidanceCurves.h"

#include "vtkNew.h"

#include <iomanip>
#include <iostream>
#include <limits>

#define PRINT(filter, name)                                                                        \
  "\"" #name "\": {\"default\": " << (filter)->Get##name()                                         \
                                  << ", \"min\": " << (filter)->Get##name##MinValue()              \
                                  << ", \"max\": " << (filter)->Get##name##MaxValue() << "}"

int main()
{
  vtkNew<vtkDirectionFieldReader> reader;
  vtkNew<vtkDirectionFieldWriter> writer;
  vtkNew<vtkGuidanceCurves> curves;
  vtkNew<vtkCompareDirectionFields> comparison;
  std::cout << std::setprecision(std::numeric_limits<double>::max_digits10)
            << "{\"ReadDirectionField\": {" << PRINT(reader, FieldOn) << "},\n"
            << "\"DirectionFieldWriter\": {" << PRINT(writer, FieldOn) << ",\n"
            << PRINT(writer, FeatureAngle) << ",\n"
            << PRINT(writer, MinimumFeatureLength) << "},\n"
            << "\"GuidanceFromCurves\": {" << PRINT(curves, Degree) << ",\n"
            << PRINT(curves, Radius) << ",\n"
            << PRINT(curves, Falloff) << ",\n"
            << PRINT(curves, MaximumDistance) << "},\n"
            << "\"CompareDirectionFields\": {\"MatchSingularities\": {\"default\": "
            << comparison->GetMatchSingularities()
            << "},\n\"DivergenceAndCurl\": {\"default\": " << comparison->GetDivergenceAndCurl()
            << "}}}\n";
  return 0;
}
