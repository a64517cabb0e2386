// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Input/PolyDataCheck.h"

#include "Conversion/Input/CellCorners.h"
#include "Conversion/Input/FieldArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace DirectionFields
{
namespace
{
/// The first i = 0 ... count - 1 for which isWrong(i); -1 if there is none.
template <typename IsWrong>
vtkIdType FirstWrong(vtkIdType count, const IsWrong& isWrong)
{
  std::atomic<bool> any{ false };
  ForEachPieceOfTuples(static_cast<std::size_t>(count),
    [&](std::size_t begin, std::size_t end)
    {
      // Without branches the compiler compares several at once.
      bool wrong = false;
      for (std::size_t i = begin; i < end; ++i)
      {
        wrong |= isWrong(static_cast<vtkIdType>(i));
      }
      if (wrong)
      {
        any.store(true, std::memory_order_relaxed);
      }
    });
  vtkIdType first = any ? 0 : -1;
  while (any && !isWrong(first))
  {
    ++first;
  }
  return first;
}

[[noreturn]] void RefuseOffsets(const std::string& cells, const std::string& why)
{
  throw std::invalid_argument("The offsets of the " + cells +
    " must ascend from 0 to the number of their corners, but " + why +
    ". The mesh is damaged: read or make it anew.");
}

/// @param name of the cells, for the sentence
void CheckOffsets(const char* name, vtkCellArray* cells)
{
  vtkDataArray* offsets = cells->GetOffsetsArray();
  vtkDataArray* connectivity = cells->GetConnectivityArray();
  const vtkIdType last = offsets->GetNumberOfTuples() - 1;
  if (last < 0 || offsets->GetNumberOfComponents() != 1 ||
    connectivity->GetNumberOfComponents() != 1)
  {
    RefuseOffsets(name, last < 0 ? "there are none" : "there is more than one to a cell");
  }
  const vtkIdType corners = connectivity->GetNumberOfTuples();
  WithIntegers(offsets,
    [&](const auto* values)
    {
      const vtkIdType wrong =
        FirstWrong(last, [values](vtkIdType i) { return values[i] > values[i + 1]; });
      if (wrong >= 0)
      {
        RefuseOffsets(name,
          std::to_string(values[wrong + 1]) + " follows " + std::to_string(values[wrong]) +
            " at cell " + std::to_string(wrong) + " of them");
      }
      if (values[0] != 0 || values[last] != corners)
      {
        RefuseOffsets(name,
          "they go from " + std::to_string(values[0]) + " to " + std::to_string(values[last]) +
            ", and there are " + std::to_string(corners) + " corners");
      }
    });
}

/// @param what   "point" or "cell"
/// @param number of the points or cells
void CheckArrays(vtkDataSetAttributes* data, const std::string& what, vtkIdType number)
{
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = data->GetAbstractArray(k);
    const std::string name = array->GetName() ? array->GetName() : "";
    if (array->GetNumberOfTuples() < number)
    {
      throw std::invalid_argument("The " + what + " array \"" + name + "\" has " +
        std::to_string(array->GetNumberOfTuples()) + " tuples, but there are " +
        std::to_string(number) + " " + what + "s. Remove it, or give it one for each.");
    }
    if (name == vtkDataSetAttributes::GhostArrayName() &&
      (!vtkUnsignedCharArray::SafeDownCast(array) || array->GetNumberOfComponents() != 1))
    {
      throw std::invalid_argument("The " + what + " array \"" + name +
        "\" must be of type unsigned char and have one component. Convert or rename it.");
    }
  }
}
}

void CheckPolyData(vtkPolyData* polyData)
{
  CheckOffsets("vertices", polyData->GetVerts());
  CheckOffsets("lines", polyData->GetLines());
  CheckOffsets("polygons", polyData->GetPolys());
  CheckOffsets("strips", polyData->GetStrips());
  const vtkIdType points = polyData->GetNumberOfPoints();
  CheckCorners(polyData->GetVerts(), 0, points);
  CheckCorners(polyData->GetLines(), polyData->GetNumberOfVerts(), points);
  CheckArrays(polyData->GetPointData(), "point", points);
  CheckArrays(polyData->GetCellData(), "cell", polyData->GetNumberOfCells());
}

void CheckCorners(vtkCellArray* cells, vtkIdType firstCell, vtkIdType points)
{
  WithCorners(cells,
    [&](const auto* offsets, const auto* ids)
    {
      const vtkIdType wrong = FirstWrong(cells->GetNumberOfConnectivityIds(),
        [ids, points](vtkIdType i) { return ids[i] < 0 || ids[i] >= points; });
      if (wrong >= 0)
      {
        const auto* const after =
          std::upper_bound(offsets, offsets + cells->GetNumberOfCells() + 1, wrong);
        RefuseId(firstCell + (after - offsets) - 1, ids[wrong], points);
      }
    });
}

void RefuseId(vtkIdType cell, vtkIdType id, vtkIdType points)
{
  throw std::out_of_range("Cell " + std::to_string(cell) + " uses point " + std::to_string(id) +
    ", but the input has " + std::to_string(points) +
    (points > 0 ? " points, numbered from 0" : " points") +
    ". Correct the connectivity of the mesh.");
}
}
