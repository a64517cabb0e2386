// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Output/InterpolatedData.h"

#include "Conversion/Input/FieldArrays.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>

namespace DirectionFields
{
namespace
{
bool IsUnshared(const std::string& name)
{
  return ArrayNames::IsOfTheField(name.c_str(), 16) || name == ArrayNames::OriginalPointIds ||
    name == vtkDataSetAttributes::GhostArrayName();
}

/// Removes arrays that another mesh of the same surface cannot take over.
void RemoveUnsharedArrays(vtkDataSetAttributes* data)
{
  for (int k = data->GetNumberOfArrays() - 1; k >= 0; --k)
  {
    const char* name = data->GetArrayName(k);
    if (name && IsUnshared(name))
    {
      data->RemoveArray(k);
    }
  }
}
}

namespace
{
/// Whether values between those of an array mean nothing, as of ids.
bool IsOfIds(vtkAbstractArray* array)
{
  const int type = array->GetDataType();
  const int components = array->GetNumberOfComponents();
  const bool isOfColors = type == VTK_UNSIGNED_CHAR && (components == 3 || components == 4);
  return vtkDataArray::SafeDownCast(array) && type != VTK_FLOAT && type != VTK_DOUBLE &&
    !isOfColors;
}

/// Puts the values of the nearest points in place of those that were interpolated.
void TakeNearest(vtkPointData* input, std::size_t count,
  const std::function<WeightedPoints(std::size_t)>& at, vtkPointData* output)
{
  std::vector<std::pair<vtkAbstractArray*, vtkAbstractArray*>> arrays;
  for (int k = 0; k < input->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* const given = input->GetAbstractArray(k);
    vtkAbstractArray* const taken =
      given->GetName() ? output->GetAbstractArray(given->GetName()) : nullptr;
    if (taken && IsOfIds(given))
    {
      arrays.emplace_back(given, taken);
    }
  }
  for (std::size_t i = 0; i < count && !arrays.empty(); ++i)
  {
    const WeightedPoints place = at(i);
    const std::array<double, 3>& weights = place.second;
    const auto nearest = std::max_element(weights.begin(), weights.end()) - weights.begin();
    for (const auto& [given, taken] : arrays)
    {
      taken->SetTuple(static_cast<vtkIdType>(i), place.first[nearest], given);
    }
  }
}
}

void InterpolatePointData(vtkPolyData* input, std::size_t count,
  const std::function<WeightedPoints(std::size_t)>& at, vtkPointData* output)
{
  vtkNew<vtkPointData> data;
  data->ShallowCopy(input->GetPointData());
  RemoveUnsharedArrays(data);
  data->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
  output->InterpolateAllocate(data, static_cast<vtkIdType>(count));
  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(3);
  for (std::size_t i = 0; i < count && data->GetNumberOfArrays() > 0; ++i)
  {
    WeightedPoints place = at(i);
    for (int c = 0; c < 3; ++c)
    {
      ids->SetId(c, place.first[c]);
    }
    output->InterpolatePoint(data, static_cast<vtkIdType>(i), ids, place.second.data());
  }
  TakeNearest(data, count, at, output);
}

void CopyCellData(vtkPolyData* input, const TriangulatedPolyData& surface,
  const std::vector<Index>& triangles, vtkCellData* output)
{
  vtkNew<vtkCellData> data;
  data->ShallowCopy(input->GetCellData());
  RemoveUnsharedArrays(data);
  // The index of the field in a cell is not that in its parts.
  data->RemoveArray(ArrayNames::SingularityIndex);
  data->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
  data->SetActiveAttribute(-1, vtkDataSetAttributes::PEDIGREEIDS);
  output->CopyAllocate(data, static_cast<vtkIdType>(triangles.size()));
  for (std::size_t f = 0; f < triangles.size() && data->GetNumberOfArrays() > 0; ++f)
  {
    output->CopyData(data, surface.Cell(triangles[f]), static_cast<vtkIdType>(f));
  }
}

bool IsLeftOutAtCells(const std::string& name)
{
  return IsUnshared(name) || name == ArrayNames::SingularityIndex;
}
}
