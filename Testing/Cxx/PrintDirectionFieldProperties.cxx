// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints default and range of each property of vtkPDirectionField, which has those of vtkDirectionField, too, as JSON, for the comparison with
// the server manager's. Switches and names of arrays have no range, names are null.

#include "vtkPDirectionField.h"

#include "vtkNew.h"

#include <iomanip>
#include <iostream>
#include <limits>

namespace
{
void PrintDefault(const char* name, double value)
{
  std::cout << "  \"" << name << "\": {\"default\": " << value;
}

void PrintDefault(const char* name, const char* value)
{
  std::cout << "  \"" << name << "\": {\"default\": ";
  if (value)
  {
    std::cout << '"' << value << '"';
  }
  else
  {
    std::cout << "null";
  }
}
}

#define PRINT_DEFAULT(name, end)                                                                   \
  PrintDefault(#name, vtkNew<vtkPDirectionField>()->Get##name());                                  \
  std::cout << "}" end "\n"

#define PRINT(name, end)                                                                           \
  PrintDefault(#name, vtkNew<vtkPDirectionField>()->Get##name());                                  \
  std::cout << ", \"min\": " << vtkNew<vtkPDirectionField>()->Get##name##MinValue()                \
            << ", \"max\": " << vtkNew<vtkPDirectionField>()->Get##name##MaxValue()                \
            << "}" end "\n"

int main()
{
  std::cout << std::setprecision(std::numeric_limits<double>::max_digits10) << "{\n";
  PRINT(Degree, ",");
  PRINT(EnergyBias, ",");
  PRINT(Tolerance, ",");
  PRINT(MaximumIterations, ",");
  PRINT(Solver, ",");
  PRINT(NumberOfThreads, ",");
  PRINT_DEFAULT(KeepStages, ",");
  PRINT(GatherLimit, ",");
  PRINT(MergePoints, ",");
  PRINT_DEFAULT(IntrinsicDelaunay, ",");
  PRINT_DEFAULT(CellDirections, ",");
  PRINT_DEFAULT(UnitLength, ",");
  PRINT(SingularityCost, ",");
  PRINT(Alignment, ",");
  PRINT(CurvatureDirection, ",");
  PRINT(CurvatureScale, ",");
  PRINT(AlignmentStrength, ",");
  PRINT_DEFAULT(UseShift, ",");
  PRINT(Shift, ",");
  PRINT_DEFAULT(GuidanceVectors, ",");
  PRINT_DEFAULT(GuidanceWeights, ",");
  PRINT_DEFAULT(ConstrainBoundary, ",");
  PRINT_DEFAULT(ConstrainSharpEdges, ",");
  PRINT(FeatureAngle, ",");
  PRINT(MinimumFeatureLength, ",");
  PRINT_DEFAULT(ConstrainCurvature, ",");
  PRINT(CurvatureTolerance, ",");
  PRINT(ConsistencyAngle, ",");
  PRINT_DEFAULT(DropConstraintsAtSingularities, ",");
  PRINT_DEFAULT(ConstrainGuidance, ",");
  PRINT(ConstraintSolver, "");
  std::cout << "}\n";
  return 0;
}
