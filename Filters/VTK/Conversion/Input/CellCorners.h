// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef CellCorners_h
#define CellCorners_h

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkType.h"

#include <cstddef>
#include <vector>

namespace DirectionFields
{
/// Calls body with the integers of an array, in whatever type they are stored.
template <typename Body>
void WithIntegers(vtkDataArray* array, const Body& body)
{
  if (auto* const longs = vtkAOSDataArrayTemplate<vtkTypeInt64>::FastDownCast(array))
  {
    body(longs->GetPointer(0));
  }
  else if (auto* const ints = vtkAOSDataArrayTemplate<vtkTypeInt32>::FastDownCast(array))
  {
    body(ints->GetPointer(0));
  }
  else
  {
    std::vector<vtkIdType> copy(static_cast<std::size_t>(array->GetNumberOfTuples()));
    for (std::size_t i = 0; i < copy.size(); ++i)
    {
      copy[i] = static_cast<vtkIdType>(array->GetComponent(static_cast<vtkIdType>(i), 0));
    }
    body(copy.data());
  }
}

/// Calls body with the offsets and the corners of cells.
template <typename Body>
void WithCorners(vtkCellArray* cells, const Body& body)
{
  WithIntegers(cells->GetOffsetsArray(),
    [&](const auto* offsets)
    {
      WithIntegers(
        cells->GetConnectivityArray(), [&](const auto* corners) { body(offsets, corners); });
    });
}
}

#endif
