// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The ranges that the filters keep with the arrays of their outputs are those that VTK computes.

#include "Checks.h"
#include "FilterOutputs.h"

#include "vtkClipPolyData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkPlane.h"

using namespace Checks;
using namespace FilterOutputs;

namespace
{
/// The same values in an array that knows nothing of their ranges.
vtkSmartPointer<vtkDataArray> Fresh(vtkDataArray* array)
{
  const auto copy =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(array->GetDataType()));
  copy->SetNumberOfComponents(array->GetNumberOfComponents());
  copy->SetNumberOfTuples(array->GetNumberOfTuples());
  copy->InsertTuples(0, array->GetNumberOfTuples(), 0, array);
  return copy;
}

bool IsSameRange(const double* one, const double* other)
{
  for (int end = 0; end < 2; ++end)
  {
    if (one[end] != other[end] && !(std::isnan(one[end]) && std::isnan(other[end])))
    {
      return false;
    }
  }
  return true;
}

bool HasRightRanges(vtkDataArray* array)
{
  const auto fresh = Fresh(array);
  for (int c = -1; c < array->GetNumberOfComponents(); ++c)
  {
    double kept[2];
    double computed[2];
    array->GetRange(kept, c);
    fresh->GetRange(computed, c);
    if (!IsSameRange(computed, kept))
    {
      return false;
    }
    array->GetFiniteRange(kept, c);
    fresh->GetFiniteRange(computed, c);
    if (!IsSameRange(computed, kept))
    {
      return false;
    }
  }
  return true;
}

bool HasKept(vtkDataArray* array)
{
  return array->HasInformation() && array->GetInformation()->Has(vtkDataArray::PER_COMPONENT()) &&
    array->GetInformation()->Has(vtkDataArray::PER_FINITE_COMPONENT());
}

std::vector<vtkDataArray*> ArraysOf(vtkPolyData* output)
{
  std::vector<vtkDataArray*> arrays;
  for (int kind = 0; kind < 2; ++kind)
  {
    vtkDataSetAttributes* const data = output->GetAttributes(kind);
    for (int k = 0; k < data->GetNumberOfArrays(); ++k)
    {
      if (data->GetArray(k))
      {
        arrays.push_back(data->GetArray(k));
      }
    }
  }
  if (output->GetPoints())
  {
    arrays.push_back(output->GetPoints()->GetData());
  }
  return arrays;
}

/// The ranges are right at first and after changes.
void CheckRanges(vtkPolyData* output)
{
  for (vtkDataArray* const array : ArraysOf(output))
  {
    CHECK(HasRightRanges(array));
    if (array->GetNumberOfTuples() == 0)
    {
      continue;
    }
    for (const double value : { 1000.0, std::nan(""), vtkMath::Inf() })
    {
      if (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE ||
        std::isfinite(value))
      {
        array->SetComponent(0, 0, array->GetDataTypeSize() > 1 ? value : 100.0);
        array->Modified();
        CHECK(!HasKept(array));
        CHECK(HasRightRanges(array));
      }
    }
  }
}

void TestOutputs()
{
  int kept = 0;
  for (const double size : { 1.0, 1e160 })
  {
    for (vtkPolyData* const output : OutputsAt(size))
    {
      for (vtkDataArray* const array : ArraysOf(output))
      {
        kept += HasKept(array);
      }
      CheckRanges(output);
    }
  }
  CHECK(kept > 60);
}

/// All arrays of a field have their ranges; those that the input shares are left as they are.
void TestField()
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    const auto mesh = PolyMeshes::Pebble(2, type);
    vtkNew<vtkFloatArray> given;
    given->SetName("Given");
    given->SetNumberOfTuples(mesh->GetNumberOfPoints());
    given->FillValue(2.0f);
    mesh->GetPointData()->AddArray(given);
    const auto field = Field(mesh, 4);
    for (vtkDataArray* const array : ArraysOf(field))
    {
      const bool isShared = array == given || array == mesh->GetPoints()->GetData();
      CHECK(HasKept(array) != isShared);
    }
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfTuples(mesh->GetNumberOfPoints());
    ghosts->FillValue(0);
    ghosts->SetValue(3, vtkDataSetAttributes::DUPLICATEPOINT);
    mesh->GetPointData()->AddArray(ghosts);
    CheckRanges(Field(mesh, 4));
    // A part of the surface has ranges of its own.
    vtkNew<vtkPlane> plane;
    plane->SetNormal(0.3, 0.2, 1.0);
    vtkNew<vtkClipPolyData> part;
    part->SetClipFunction(plane);
    part->SetInputData(field);
    part->Update();
    for (vtkDataArray* const array : ArraysOf(part->GetOutput()))
    {
      CHECK(HasRightRanges(array));
    }
    CheckRanges(field);
  }
}
}

int TestFilterRanges(int, char*[])
{
  TestOutputs();
  TestField();
  return Result();
}
