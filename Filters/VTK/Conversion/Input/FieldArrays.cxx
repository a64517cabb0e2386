// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Input/FieldArrays.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstdlib>
#include <new>
#include <numeric>

namespace DirectionFields
{
namespace ArrayNames
{
std::string Direction(int k)
{
  return "Direction" + std::to_string(k);
}

bool IsOfTheField(const char* name, int degree)
{
  const std::string wanted = name ? name : "";
  for (int k = 0; k < degree; ++k)
  {
    if (wanted == Direction(k))
    {
      return true;
    }
  }
  return wanted == RepresentationMagnitude || wanted == EnergyDensity ||
    wanted == ConstraintDirection || wanted == ConstraintKind || wanted == PrincipalDirection0 ||
    wanted == PrincipalDirection1;
}
}

void RequireMemory(std::size_t bytes)
{
  // Volatile, since the compiler may leave out what is asked for and given back.
  void* volatile room = std::malloc(bytes);
  if (!room && bytes > 0)
  {
    throw std::bad_alloc();
  }
  std::free(room);
}

vtkNew<vtkPoints> MakePoints(const std::vector<Vector3>& positions, int pointDataType)
{
  vtkNew<vtkPoints> points;
  if (pointDataType == VTK_DOUBLE)
  {
    points->SetData(MakeVectors<vtkDoubleArray>("Points", positions));
  }
  else
  {
    points->SetData(MakeVectors<vtkFloatArray>("Points", positions));
  }
  return points;
}

vtkNew<vtkIdTypeArray> MakeIds(const std::vector<std::int64_t>& ids)
{
  auto array = MakeArray<vtkIdTypeArray>("", 1, ids.size());
  std::copy(ids.begin(), ids.end(), array->GetPointer(0));
  return array;
}

vtkNew<vtkIntArray> MakeReasons(
  std::size_t lines, const std::function<int(std::size_t, int)>& reason)
{
  auto array = MakeArray<vtkIntArray>("ReasonForTermination", 2, lines);
  array->SetComponentName(0, "Start");
  array->SetComponentName(1, "End");
  for (std::size_t i = 0; i < lines; ++i)
  {
    for (int end = 0; end < 2; ++end)
    {
      array->SetTypedComponent(static_cast<vtkIdType>(i), end, reason(i, end));
    }
  }
  return array;
}

void SetPolyLines(const std::vector<Vector3>& positions, const std::vector<std::int64_t>& offsets,
  int pointDataType, vtkPolyData* output)
{
  output->SetPoints(MakePoints(positions, pointDataType));
  std::vector<std::int64_t> connectivity(positions.size());
  std::iota(connectivity.begin(), connectivity.end(), 0);
  vtkNew<vtkCellArray> cells;
  cells->SetData(MakeIds(offsets), MakeIds(connectivity));
  output->SetLines(cells);
}

void SetVertices(const std::vector<Vector3>& positions, int pointDataType, vtkPolyData* output)
{
  output->SetPoints(MakePoints(positions, pointDataType));
  vtkNew<vtkCellArray> cells;
  RequireMemoryToGrow(2 * sizeof(vtkIdType) * positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    cells->InsertNextCell({ static_cast<vtkIdType>(i) });
  }
  output->SetVerts(cells);
}
}
