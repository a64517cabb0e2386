// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints default and range of each property of vtkFieldAlignedRemesh as JSON, for the comparison
// with the server manager's. Switches have no range, and the array's name neither.

#include "vtkFieldAlignedRemesh.h"

#include "vtkNew.h"

#include <iomanip>
#include <iostream>
#include <limits>

#define PRINT(name)                                                                                \
  std::cout << "  \"" #name "\": {\"default\": " << filter->Get##name()                            \
            << ", \"min\": " << filter->Get##name##MinValue()                                      \
            << ", \"max\": " << filter->Get##name##MaxValue() << "},\n"
#define PRINT_SWITCH(name)                                                                         \
  std::cout << "  \"" #name "\": {\"default\": " << filter->Get##name() << "},\n"

int main()
{
  vtkNew<vtkFieldAlignedRemesh> filter;
  std::cout << std::setprecision(std::numeric_limits<double>::max_digits10) << "{\n";
  PRINT(Element);
  PRINT_SWITCH(PureQuads);
  PRINT(SizeMode);
  PRINT(NumberOfFaces);
  PRINT(EdgeLength);
  PRINT_SWITCH(KeepFeatures);
  PRINT(FeatureAngle);
  PRINT(SmoothingIterations);
  PRINT_SWITCH(KeepStages);
  PRINT(NumberOfThreads);
  std::cout << "  \"SizingArray\": {\"default\": \""
            << (filter->GetSizingArray() ? filter->GetSizingArray() : "None") << "\"}\n}\n";
  return 0;
}
