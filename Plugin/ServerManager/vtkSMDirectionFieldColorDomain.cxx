// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSMDirectionFieldColorDomain.h"

#include "vtkDataObject.h"
#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"

#include <string>

namespace
{
/// Whether a name is a prefix with a number behind it, as Direction3.
bool IsNumbered(const std::string& name, const std::string& prefix)
{
  return name.size() > prefix.size() && name.compare(0, prefix.size(), prefix) == 0 &&
    name.find_first_not_of("0123456789", prefix.size()) == std::string::npos;
}

/// Whether an array has unit vectors, or the tensors by which a field was guided.
bool IsOfDirections(const std::string& name)
{
  return IsNumbered(name, "Direction") || IsNumbered(name, "PrincipalDirection") ||
    name == "ConstraintDirection" || name == "Normals" || name == "SurfaceTensor";
}
}

vtkStandardNewMacro(vtkSMDirectionFieldColorDomain);

//------------------------------------------------------------------------------
vtkSMDirectionFieldColorDomain::vtkSMDirectionFieldColorDomain() = default;
vtkSMDirectionFieldColorDomain::~vtkSMDirectionFieldColorDomain() = default;

//------------------------------------------------------------------------------
void vtkSMDirectionFieldColorDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
bool vtkSMDirectionFieldColorDomain::IsFilteredArray(
  vtkPVDataInformation* data, int association, const char* name)
{
  vtkPVArrayInformation* const array =
    data ? data->GetArrayInformation(name, association) : nullptr;
  const bool isText = array && array->GetDataType() == VTK_STRING;
  // ParaView's display makes a group of a single surface, too.
  vtkPVDataInformation* const input = this->GetInputDataInformation("Input");
  const bool isOneColor =
    association == vtkDataObject::FIELD && input && !input->IsCompositeDataSet();
  // The index at the vertices of a mesh is 0 but at single points, which its second output shows.
  const bool isOfMesh = association == vtkDataObject::POINT && name == std::string("FieldIndex") &&
    data && data->GetArrayInformation("VertexKind", association);
  return isText || isOfMesh || isOneColor || IsOfDirections(name) ||
    this->Superclass::IsFilteredArray(data, association, name);
}
