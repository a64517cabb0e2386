// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Regions/CellRegions.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

namespace DirectionFields
{
namespace
{
/// Borders around more regions than these are the edges of the surface.
constexpr std::size_t MostRegions = 10000;
constexpr std::size_t FewCells = 100;

bool IsOfReals(vtkAbstractArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}

/// Numbers the values of an array at the cells of all faces.
template <typename Value>
CellRegions Numbered(const FaceCells& faces, const std::function<Value(vtkIdType)>& valueOf,
  const std::function<std::string(const Value&)>& nameOf)
{
  CellRegions regions;
  std::map<Value, Index> number;
  regions.OfFaces.reserve(faces.Count);
  for (std::size_t f = 0; f < faces.Count; ++f)
  {
    const Value value = valueOf(faces.CellOf(f));
    const auto [found, isNew] = number.emplace(value, static_cast<Index>(number.size()));
    if (isNew)
    {
      regions.Names.push_back(nameOf(value));
    }
    regions.OfFaces.push_back(found->second);
  }
  return regions;
}

[[noreturn]] void Refuse(const std::string& name, const std::string& reason)
{
  throw std::invalid_argument("Region Array \"" + name + "\" " + reason);
}

CellRegions NumbersOf(const FaceCells& faces, vtkDataArray* array, const std::string& name)
{
  const auto valueOf = [&](vtkIdType cell) -> long long
  {
    if (!IsOfReals(array))
    {
      return array->GetVariantValue(cell).ToLongLong();
    }
    constexpr double most = 9e15;
    const double value = array->GetComponent(cell, 0);
    if (!(std::abs(value) < most) || value != std::floor(value))
    {
      Refuse(name,
        "has a value at cell " + std::to_string(cell) +
          " that is no whole number. Take an array of integers or strings, or round this one with "
          "Calculator.");
    }
    return static_cast<long long>(value);
  };
  return Numbered<long long>(
    faces, valueOf, [](const long long& value) { return std::to_string(value); });
}
}

CellRegions FindRegions(vtkPolyData* polyData, const FaceCells& faces, const char* name)
{
  const std::string wanted = name ? name : "";
  vtkAbstractArray* array = polyData->GetCellData()->GetAbstractArray(wanted.c_str());
  if (wanted.empty() || (!array && wanted == "None"))
  {
    return {};
  }
  if (!array || array->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument(
      "There is no cell array \"" + wanted + "\" of 1 component. Choose another for Region Array.");
  }
  CellRegions regions;
  if (auto* strings = vtkStringArray::SafeDownCast(array))
  {
    regions = Numbered<std::string>(
      faces, [&](vtkIdType cell) { return std::string(strings->GetValue(cell)); },
      [](const std::string& value) { return "\"" + value + "\""; });
  }
  else if (auto* numbers = vtkDataArray::SafeDownCast(array))
  {
    regions = NumbersOf(faces, numbers, wanted);
  }
  else
  {
    Refuse(wanted, "has neither numbers nor strings. Choose another.");
  }
  const std::size_t cells = regions.OfFaces.size();
  const std::size_t count = regions.Names.size();
  if (count > MostRegions || (cells > FewCells && 2 * count > cells))
  {
    Refuse(wanted,
      "has " + std::to_string(count) + " values on " + std::to_string(cells) +
        " faces: it numbers cells, not regions. Choose another.");
  }
  return regions;
}
}
