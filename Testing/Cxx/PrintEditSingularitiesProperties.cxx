// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints default and range of each property of vtkDirectionFieldSingularities as JSON, for the comparison with the server
// manager's. Switches and arrays have no range.

#include "vtkDirectionFieldSingularities.h"

#include "vtkNew.h"

#include <iostream>

#define PRINT(name)                                                                                \
  "\"" #name "\": {\"default\": " << edit->Get##name()                                             \
                                  << ", \"min\": " << edit->Get##name##MinValue()                  \
                                  << ", \"max\": " << edit->Get##name##MaxValue() << "},\n"
#define PRINT_SWITCH(name) "\"" #name "\": {\"default\": " << edit->Get##name() << "},\n"

int main()
{
  vtkNew<vtkDirectionFieldSingularities> edit;
  std::cout << "{" << PRINT(SingularityMode) << PRINT(Objective)
            << PRINT_SWITCH(BalanceAutomatically) << PRINT_SWITCH(RefineWhereNeeded)
            << PRINT_SWITCH(KeepConstraints) << PRINT(Alignment) << PRINT(AlignmentStrength)
            << PRINT_SWITCH(KeepStages) << "\"GuidanceVectors\": {\"default\": null},\n"
            << "\"GuidanceWeights\": {\"default\": null}}\n";
  return 0;
}
