// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints default and range of each property of vtkStripePattern as JSON, for the comparison
// with the server manager's. Switches have no range, and the array's name neither.

#include "vtkStripePattern.h"

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
  vtkNew<vtkStripePattern> filter;
  std::cout << std::setprecision(std::numeric_limits<double>::max_digits10) << "{\n";
  PRINT(StripeDirection);
  PRINT(Spacing);
  PRINT(LineOffset);
  PRINT_SWITCH(Bands);
  PRINT_SWITCH(TextureCoordinates);
  std::cout << "  \"SpacingArray\": {\"default\": \""
            << (filter->GetSpacingArray() ? filter->GetSpacingArray() : "None") << "\"}\n}\n";
  return 0;
}
