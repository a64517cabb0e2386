// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Input/PolyDataToField.h"

#include "Conversion/Input/FieldArrays.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace DirectionFields
{
namespace
{
/// The point array of a name; null if there is none.
vtkDataArray* FindArray(vtkPolyData* polyData, const std::string& name, int components)
{
  vtkDataArray* array = polyData->GetPointData()->GetArray(name.c_str());
  if (array && array->GetNumberOfComponents() != components)
  {
    throw std::invalid_argument("The point array \"" + name + "\" must have " +
      std::to_string(components) + (components == 1 ? " component" : " components") +
      ". Apply Direction Field first and take its first output, or rename the array.");
  }
  return array;
}

/// Throws std::invalid_argument where a point array has a value that is not finite.
void RequireFinite(vtkDataArray* array)
{
  const auto isFinite = [array](vtkIdType i)
  {
    std::array<double, 3> tuple{};
    array->GetTuple(i, tuple.data());
    return std::isfinite(tuple[0] + tuple[1] + tuple[2]);
  };
  const vtkIdType tuples = array->GetNumberOfTuples();
  std::atomic<bool> areFinite{ true };
  ForEachPieceOfTuples(static_cast<std::size_t>(tuples),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        if (!isFinite(static_cast<vtkIdType>(i)))
        {
          areFinite.store(false, std::memory_order_relaxed);
        }
      }
    });
  vtkIdType first = 0;
  while (!areFinite && isFinite(first))
  {
    ++first;
  }
  if (!areFinite)
  {
    throw std::invalid_argument("The point array \"" + std::string(array->GetName()) +
      "\" is NaN or infinite at point " + std::to_string(first) +
      ". Apply Direction Field anew, or correct the array.");
  }
}
}

PointDirections FindDirections(vtkPolyData* polyData)
{
  PointDirections field;
  std::vector<vtkDataArray*> arrays;
  while (vtkDataArray* array =
           FindArray(polyData, ArrayNames::Direction(static_cast<int>(arrays.size())), 3))
  {
    arrays.push_back(array);
  }
  std::for_each(arrays.begin(), arrays.end(), RequireFinite);
  field.Degree = static_cast<int>(arrays.size());
  field.Direction = [arrays](Index point, int k)
  {
    Vector3 direction;
    arrays[k]->GetTuple(point, direction.data());
    return direction;
  };
  vtkDataArray* magnitude = FindArray(polyData, ArrayNames::RepresentationMagnitude, 1);
  if (magnitude)
  {
    RequireFinite(magnitude);
  }
  field.Magnitude = [magnitude](Index point)
  { return magnitude ? magnitude->GetComponent(point, 0) : 1.0; };
  return field;
}

PointDirections RequireDirections(vtkPolyData* polyData)
{
  PointDirections field = FindDirections(polyData);
  if (field.Degree == 0)
  {
    throw std::invalid_argument("The input has no point array \"Direction0\" of 3 components. "
                                "Apply Direction Field first and take its first output.");
  }
  return field;
}
}
