// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Carrying/CarriedCellData.h"

#include "Conversion/Input/FieldArrays.h"
#include "Conversion/Output/InterpolatedData.h"

#include <DirectionFields/Transfer/CarriedValues.h>

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkType.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>

namespace DirectionFields
{
namespace
{
/// The user is told of an integral that changes values by more than this part of their size.
constexpr double NotableChange = 0.1;

bool IsReal(vtkAbstractArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}

/// The values of an array at the cells of all triangles, one component after the other.
std::vector<double> ValuesOf(const TriangulatedPolyData& surface, vtkDataArray* array)
{
  const auto components = static_cast<std::size_t>(array->GetNumberOfComponents());
  std::vector<double> values(surface.Mesh.Triangles.size() * components);
  for (std::size_t t = 0; t < surface.Mesh.Triangles.size(); ++t)
  {
    array->GetTuple(surface.Cell(t), values.data() + t * components);
  }
  return values;
}

/// Numbers of the values of the triangles, from 0 on.
template <typename Value>
std::vector<Index> Numbered(
  const TriangulatedPolyData& surface, const std::function<Value(std::size_t)>& valueOf)
{
  std::vector<Index> classes;
  std::map<Value, Index> number;
  for (std::size_t t = 0; t < surface.Mesh.Triangles.size(); ++t)
  {
    classes.push_back(number.emplace(valueOf(t), static_cast<Index>(number.size())).first->second);
  }
  return classes;
}

/// The same numbers for the same values of the triangles; none for arrays of neither numbers nor
/// strings.
std::vector<Index> ClassesOf(const TriangulatedPolyData& surface, vtkAbstractArray* array)
{
  if (auto* const strings = vtkStringArray::SafeDownCast(array))
  {
    return Numbered<std::string>(
      surface, [&](std::size_t t) { return std::string(strings->GetValue(surface.Cell(t))); });
  }
  auto* const numbers = vtkDataArray::SafeDownCast(array);
  if (!numbers)
  {
    return {};
  }
  // As integers: ids beyond 2^53 are not all doubles.
  const vtkIdType components = numbers->GetNumberOfComponents();
  return Numbered<std::vector<vtkTypeInt64>>(surface,
    [&](std::size_t t)
    {
      std::vector<vtkTypeInt64> tuple;
      for (vtkIdType c = 0; c < components; ++c)
      {
        tuple.push_back(numbers->GetVariantValue(surface.Cell(t) * components + c).ToTypeInt64());
      }
      return tuple;
    });
}

/// Puts values of the faces in the place of an array.
void SetValues(const std::vector<double>& values, vtkDataArray* array)
{
  const auto components = static_cast<std::size_t>(array->GetNumberOfComponents());
  for (vtkIdType f = 0; f < array->GetNumberOfTuples(); ++f)
  {
    array->SetTuple(f, values.data() + static_cast<std::size_t>(f) * components);
  }
}

/// The array whose integral is kept; null for none.
vtkDataArray* ConservedOf(vtkPolyData* input, const std::string& name)
{
  vtkDataArray* const array = name.empty() ? nullptr : input->GetCellData()->GetArray(name.c_str());
  if (!array && !name.empty() && name != "None")
  {
    throw std::invalid_argument("There is no cell array \"" + name +
      "\" of numbers. Choose another for Conserved Array; Point Data to Cell Data makes one of "
      "those at points.");
  }
  return array;
}
}

void CheckConserved(vtkPolyData* input, const CellDataRules& rules)
{
  vtkDataArray* const conserved = ConservedOf(input, rules.ConservedArray);
  if (conserved &&
    (conserved == input->GetCellData()->GetNormals() || IsLeftOutAtCells(rules.ConservedArray)))
  {
    throw std::invalid_argument("\"" + rules.ConservedArray +
      "\" has normals, marks or directions of the input's own cells, which the mesh does not take "
      "over. Choose another for Conserved Array.");
  }
  if (conserved && rules.ConservedArray == rules.RegionArray)
  {
    throw std::invalid_argument("\"" + rules.ConservedArray +
      "\" is the Region Array, whose values are not to be changed. Choose another for Conserved "
      "Array.");
  }
}

std::vector<std::string> CarryCellData(vtkPolyData* input, const TriangulatedPolyData& surface,
  const RemeshResult& mesh, const CellDataRules& rules, vtkCellData* output)
{
  CopyCellData(input, surface, mesh.FaceSource, output);
  vtkDataArray* const conserved = ConservedOf(input, rules.ConservedArray);
  std::vector<vtkAbstractArray*> arrays;
  for (int k = 0; k < output->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* const array = output->GetAbstractArray(k);
    const char* const name = array->GetName();
    const bool isOfRegions = !mesh.Regions.empty() && name && name == rules.RegionArray;
    if (name && !isOfRegions && array != output->GetNormals() &&
      input->GetCellData()->GetAbstractArray(name))
    {
      arrays.push_back(array);
    }
  }
  std::vector<std::string> sentences;
  if (arrays.empty() || mesh.Faces.empty())
  {
    return sentences;
  }
  const FaceOverlaps overlaps = FindOverlaps(surface.Mesh, mesh, rules.Regions);
  const CarriedValues carried(surface.Mesh, mesh, rules.Regions, overlaps);
  for (vtkAbstractArray* const array : arrays)
  {
    vtkAbstractArray* const given = input->GetCellData()->GetAbstractArray(array->GetName());
    if (given == conserved)
    {
      double change = 0.0;
      const int components = conserved->GetNumberOfComponents();
      const std::vector<double> values =
        carried.Conserved(ValuesOf(surface, conserved), components, &change);
      auto kept = MakeArray<vtkDoubleArray>(array->GetName(), components, mesh.Faces.size());
      SetValues(values, kept);
      output->AddArray(kept);
      if (change > NotableChange)
      {
        sentences.push_back("Values of \"" + rules.ConservedArray + "\" were changed by " +
          std::to_string(static_cast<int>(100.0 * change + 0.5)) +
          " % of their size to keep its integral. More faces, which are closer to the surface, "
          "would change them less.");
      }
    }
    else if (IsReal(array))
    {
      auto* const reals = vtkDataArray::SafeDownCast(given);
      SetValues(carried.Means(ValuesOf(surface, reals), reals->GetNumberOfComponents()),
        vtkDataArray::SafeDownCast(array));
    }
    else if (const std::vector<Index> classes = ClassesOf(surface, given); !classes.empty())
    {
      const std::vector<Index> triangles = carried.LargestOverlaps(classes);
      for (std::size_t f = 0; f < triangles.size(); ++f)
      {
        array->SetTuple(static_cast<vtkIdType>(f), surface.Cell(triangles[f]), given);
      }
    }
  }
  return sentences;
}
}
