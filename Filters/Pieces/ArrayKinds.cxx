// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ArrayKinds.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkMultiProcessStream.h"

#include <cstddef>
#include <cstring>

namespace DirectionFields::Parallel
{
void WriteKinds(
  vtkDataSetAttributes* computed, vtkDataSetAttributes* given, vtkMultiProcessStream& stream)
{
  std::vector<vtkDataArray*> arrays;
  for (int k = 0; k < computed->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* const array = computed->GetArray(k);
    if (array && array->GetName() && given->GetArray(array->GetName()) != array &&
      std::strcmp(array->GetName(), OriginalPointIdsName) != 0)
    {
      arrays.push_back(array);
    }
  }
  stream << static_cast<int>(arrays.size());
  for (vtkDataArray* const array : arrays)
  {
    stream << std::string(array->GetName()) << array->GetDataType()
           << array->GetNumberOfComponents() << static_cast<int>(computed->GetVectors() == array);
  }
}

ArrayKinds ReadKinds(vtkMultiProcessStream& stream)
{
  int count = 0;
  stream >> count;
  ArrayKinds kinds(static_cast<std::size_t>(count));
  for (ArrayKind& kind : kinds)
  {
    int isVectors = 0;
    stream >> kind.Name >> kind.Type >> kind.Components >> isVectors;
    kind.IsVectors = isVectors != 0;
  }
  return kinds;
}

vtkSmartPointer<vtkDataArray> NewArray(const ArrayKind& kind, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(kind.Type));
  array->SetName(kind.Name.c_str());
  array->SetNumberOfComponents(kind.Components);
  array->SetNumberOfTuples(tuples);
  return array;
}

void AddZeros(const ArrayKinds& kinds, vtkIdType tuples, vtkDataSetAttributes* data)
{
  for (const ArrayKind& kind : kinds)
  {
    if (!data->HasArray(kind.Name.c_str()))
    {
      const vtkSmartPointer<vtkDataArray> array = NewArray(kind, tuples);
      array->Fill(0.0);
      data->AddArray(array);
    }
    if (kind.IsVectors && !data->GetVectors())
    {
      data->SetActiveVectors(kind.Name.c_str());
    }
  }
}
}
