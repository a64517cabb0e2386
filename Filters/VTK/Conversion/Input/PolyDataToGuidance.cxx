// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Input/PolyDataToGuidance.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <stdexcept>
#include <string>

namespace DirectionFields
{
namespace
{
/// The point array of a name and a number of components; null where the name is empty or ParaView's
/// "None".
/// @param property of the filter, for the sentence of the error
vtkDataArray* FindPointArray(
  vtkPolyData* polyData, const char* name, int components, const char* property)
{
  const std::string wanted = name ? name : "";
  vtkDataArray* array = polyData->GetPointData()->GetArray(wanted.c_str());
  if (wanted.empty() || (!array && wanted == "None"))
  {
    return nullptr;
  }
  if (!array || array->GetNumberOfComponents() != components)
  {
    throw std::invalid_argument("There is no point array \"" + wanted + "\" of " +
      std::to_string(components) + (components == 1 ? " component" : " components") +
      ". Choose another for " + property + ".");
  }
  return array;
}
}

std::vector<double> PointValues(vtkPolyData* polyData, const char* name, const char* property)
{
  std::vector<double> values;
  if (vtkDataArray* array = FindPointArray(polyData, name, 1, property))
  {
    values.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      values[i] = array->GetTuple1(i);
    }
  }
  return values;
}

Guidance PolyDataToGuidance(vtkPolyData* polyData, const char* vectors, const char* weights)
{
  Guidance guidance;
  if (vtkDataArray* array = FindPointArray(polyData, vectors, 3, "Guidance Vectors"))
  {
    guidance.Vectors.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      array->GetTuple(i, guidance.Vectors[i].data());
    }
  }
  guidance.Weights = PointValues(polyData, weights, "Guidance Weights");
  return guidance;
}
}
