// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Input/FieldArrays.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPoints.h"

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
}
