// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Running/GatheringWarnings.h"

#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <algorithm>

namespace DirectionFields::Parallel
{
std::string DescribeLargeSurface(vtkIdType polygons)
{
  return "The surface has " + std::to_string(polygons) +
    " polygons, more than Gather Limit. All of them are on one process now, which takes about " +
    std::to_string(std::max<vtkIdType>(1, polygons * 67 / 100000000)) +
    " GB there. Decimate the surface where that is too much.";
}

std::string DescribeLostCopies(vtkIdType count)
{
  return "Make ghost cells anew after the filters that take cells away: " + std::to_string(count) +
    (count == 1 ? " ghost cell is a copy of a polygon that no process has, and shows"
                : " ghost cells are copies of polygons that no process has, and show") +
    " no field.";
}

void AddWarning(const std::string& warning, vtkPolyData* output)
{
  vtkSmartPointer<vtkStringArray> warnings =
    vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("Warnings"));
  if (!warnings)
  {
    warnings = vtkSmartPointer<vtkStringArray>::New();
    warnings->SetName("Warnings");
    output->GetFieldData()->AddArray(warnings);
  }
  warnings->InsertNextValue(warning);
}
}
