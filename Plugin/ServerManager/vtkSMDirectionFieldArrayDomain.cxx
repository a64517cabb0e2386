// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSMDirectionFieldArrayDomain.h"

#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMInputProperty.h"
#include "vtkSMSourceProxy.h"

vtkStandardNewMacro(vtkSMDirectionFieldArrayDomain);

//------------------------------------------------------------------------------
vtkSMDirectionFieldArrayDomain::vtkSMDirectionFieldArrayDomain() = default;
vtkSMDirectionFieldArrayDomain::~vtkSMDirectionFieldArrayDomain() = default;

//------------------------------------------------------------------------------
void vtkSMDirectionFieldArrayDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << this->ArrayName << "\n";
}

//------------------------------------------------------------------------------
int vtkSMDirectionFieldArrayDomain::ReadXMLAttributes(
  vtkSMProperty* property, vtkPVXMLElement* element)
{
  this->ArrayName = element->GetAttributeOrEmpty("array_name");
  return this->Superclass::ReadXMLAttributes(property, element);
}

//------------------------------------------------------------------------------
int vtkSMDirectionFieldArrayDomain::IsInDomain(vtkSMProperty* property)
{
  auto* const input = vtkSMInputProperty::SafeDownCast(property);
  if (this->ArrayName.empty() || !input || input->GetNumberOfUncheckedProxies() == 0)
  {
    return this->Superclass::IsInDomain(property);
  }
  auto* const source = vtkSMSourceProxy::SafeDownCast(input->GetUncheckedProxy(0));
  vtkPVDataInformation* const data =
    source ? source->GetDataInformation(input->GetUncheckedOutputPortForConnection(0)) : nullptr;
  vtkPVArrayInformation* const array =
    data ? data->GetArrayInformation(this->ArrayName.c_str(), vtkDataObject::POINT) : nullptr;
  return array && array->GetNumberOfComponents() == 3 ? 1 : 0;
}
