// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDirectionFieldTensors.h"

#include "Conversion/Tensors/TensorArrays.h"

#include <DirectionFields/Guidance/SurfaceTensors.h>

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"

namespace
{
/// The first array to process; null where there is none.
vtkInformation* FirstArray(vtkInformation* filter)
{
  vtkInformationVector* const arrays = filter->Get(vtkAlgorithm::INPUT_ARRAYS_TO_PROCESS());
  return arrays ? arrays->GetInformationObject(0) : nullptr;
}
}

//------------------------------------------------------------------------------
vtkDirectionFieldTensors::vtkDirectionFieldTensors()
  : TensorStrength(1.0)
{
  const DirectionFields::TensorGuidanceOptions defaults;
  this->TensorDirection = static_cast<int>(defaults.Direction);
  this->TensorScale = defaults.Scale;
}

//------------------------------------------------------------------------------
void vtkDirectionFieldTensors::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const std::string name = this->GetTensorArrayName();
  os << indent << "TensorArray: " << (name.empty() ? "(none)" : name) << "\n";
  os << indent << "TensorDirection: " << this->TensorDirection << "\n";
  os << indent << "TensorStrength: " << this->TensorStrength << "\n";
  os << indent << "TensorScale: " << this->TensorScale << "\n";
}

//------------------------------------------------------------------------------
void vtkDirectionFieldTensors::SetTensorArray(int association, const char* name)
{
  this->SetInputArrayToProcess(0, 0, 0, association, name ? name : "");
}

//------------------------------------------------------------------------------
std::string vtkDirectionFieldTensors::GetTensorArrayName()
{
  vtkInformation* const array = FirstArray(this->GetInformation());
  const char* const name = array ? array->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  return name ? name : "";
}

//------------------------------------------------------------------------------
bool vtkDirectionFieldTensors::AreTensorsOfCells()
{
  vtkInformation* const array = FirstArray(this->GetInformation());
  return array &&
    array->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_CELLS;
}

//------------------------------------------------------------------------------
DirectionFields::SurfaceTensors vtkDirectionFieldTensors::ReadTensors(
  vtkPolyData* input, const DirectionFields::TriangulatedPolyData& surface)
{
  return DirectionFields::PolyDataToTensors(
    input, surface, this->AreTensorsOfCells(), this->GetTensorArrayName());
}

//------------------------------------------------------------------------------
DirectionFields::TensorGuidanceOptions vtkDirectionFieldTensors::MakeTensorOptions() const
{
  DirectionFields::TensorGuidanceOptions options;
  options.Direction = static_cast<DirectionFields::TensorDirection>(this->TensorDirection);
  options.Scale = this->TensorScale;
  return options;
}
