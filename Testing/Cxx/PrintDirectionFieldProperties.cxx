// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints default and range of each property of vtkDirectionField as JSON, for the comparison with
// the server manager's.

#include "vtkDirectionField.h"

#include "vtkNew.h"

#include <iomanip>
#include <iostream>
#include <limits>

#define PRINT(name, end)                                                                           \
  std::cout << "  \"" #name "\": {\"default\": " << vtkNew<vtkDirectionField>()->Get##name()       \
            << ", \"min\": " << vtkNew<vtkDirectionField>()->Get##name##MinValue()                 \
            << ", \"max\": " << vtkNew<vtkDirectionField>()->Get##name##MaxValue() << "}" end "\n"

int main()
{
  std::cout << std::setprecision(std::numeric_limits<double>::max_digits10) << "{\n";
  PRINT(Degree, ",");
  PRINT(EnergyBias, ",");
  PRINT(Tolerance, ",");
  PRINT(MaximumIterations, "");
  std::cout << "}\n";
  return 0;
}
