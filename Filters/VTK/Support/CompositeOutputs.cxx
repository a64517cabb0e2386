// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/CompositeOutputs.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace DirectionFields
{
void MakeOutputsLike(vtkInformationVector* inputVector, vtkInformationVector* outputs)
{
  vtkDataObject* const input = vtkDataObject::GetData(inputVector);
  auto* const composite = vtkCompositeDataSet::SafeDownCast(input);
  for (int port = 0; input && port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* const info = outputs->GetInformationObject(port);
    vtkDataObject* const now = info->Get(vtkDataObject::DATA_OBJECT());
    const std::string wanted = composite ? composite->GetClassName() : "vtkPolyData";
    if (!now || now->GetClassName() != wanted)
    {
      vtkSmartPointer<vtkDataObject> output;
      output.TakeReference(
        composite ? static_cast<vtkDataObject*>(composite->NewInstance()) : vtkPolyData::New());
      info->Set(vtkDataObject::DATA_OBJECT(), output);
    }
  }
}
}
