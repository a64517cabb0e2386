// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints default and range of each property of vtkDirectionFieldStreamlines as JSON, for the comparison
// with the server manager's. Switches have no range.

#include "vtkDirectionFieldStreamlines.h"

#include "vtkNew.h"

#include <iomanip>
#include <iostream>
#include <limits>

#define PRINT(name)                                                                                \
  std::cout << "  \"" #name "\": {\"default\": " << filter->Get##name()                            \
            << ", \"min\": " << filter->Get##name##MinValue()                                      \
            << ", \"max\": " << filter->Get##name##MaxValue() << "},\n"

int main()
{
  vtkNew<vtkDirectionFieldStreamlines> filter;
  std::cout << std::setprecision(std::numeric_limits<double>::max_digits10) << "{\n";
  PRINT(SeedType);
  PRINT(SeparatingDistance);
  PRINT(SeparatingDistanceRatio);
  PRINT(MaximumStreamlineLength);
  PRINT(MinimumStreamlineLength);
  PRINT(IntegrationDirection);
  PRINT(MaximumNumberOfLines);
  PRINT(Offset);
  std::cout << "  \"StopAtCrossings\": {\"default\": " << filter->GetStopAtCrossings() << "}\n}\n";
  return 0;
}
