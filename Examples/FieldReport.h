// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the examples have in common: they read the arrays of a field, and tell what is in them.

#ifndef FieldReport_h
#define FieldReport_h

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDirectionField.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cstdlib>
#include <iostream>
#include <string>

/// The sum of all values of an array; nothing where it is missing.
inline int Sum(vtkFieldData* data, const char* name)
{
  vtkDataArray* array = data->GetArray(name);
  int sum = 0;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    sum += static_cast<int>(array->GetTuple1(i));
  }
  return sum;
}

/// Runs the filter on a closed surface, prints what it found, and returns what main returns:
/// success if all directions are there and the indices sum up to n times the Euler characteristic.
inline int Report(vtkDirectionField* filter)
{
  filter->Update();
  vtkPolyData* surface = filter->GetOutput(0);
  vtkPolyData* singularities = filter->GetOutput(1);
  const int degree = filter->GetDegree();
  int directions = 0;
  for (int k = 0; k < degree; ++k)
  {
    const std::string name = "Direction" + std::to_string(k);
    vtkDataArray* array = surface->GetPointData()->GetArray(name.c_str());
    directions += array && array->GetNumberOfTuples() == surface->GetNumberOfPoints() ? 1 : 0;
  }
  const int index = Sum(surface->GetCellData(), "SingularityIndex");
  const int characteristic = Sum(surface->GetFieldData(), "EulerCharacteristic");
  std::cout << surface->GetNumberOfPoints() << " points with " << directions << " directions, "
            << singularities->GetNumberOfPoints() << " singularities, index sum " << index << " = "
            << degree << " x " << characteristic << std::endl;
  const bool complete = surface->GetNumberOfPoints() > 0 && directions == degree;
  return complete && index == degree * characteristic ? EXIT_SUCCESS : EXIT_FAILURE;
}

/// The file that a program is to read; ends the program where none is given.
inline const char* FileArgument(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " FILE" << std::endl;
    std::exit(EXIT_FAILURE);
  }
  return argv[1];
}

#endif
