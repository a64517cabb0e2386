// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSMDirectionFieldRepresentationProxy.h"

#include "DisplayHints.h"
#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMTransferFunctionProxy.h"

#include <cstring>

vtkStandardNewMacro(vtkSMDirectionFieldRepresentationProxy);

//------------------------------------------------------------------------------
vtkSMDirectionFieldRepresentationProxy::vtkSMDirectionFieldRepresentationProxy() = default;
vtkSMDirectionFieldRepresentationProxy::~vtkSMDirectionFieldRepresentationProxy() = default;

//------------------------------------------------------------------------------
void vtkSMDirectionFieldRepresentationProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
bool vtkSMDirectionFieldRepresentationProxy::SetScalarBarVisibility(vtkSMProxy* view, bool visible)
{
  const auto find = [&]() -> vtkSMProxy*
  {
    vtkSMProxy* map = vtkSMPropertyHelper(this, "LookupTable", /*quiet=*/true).GetAsProxy();
    return map && view ? vtkSMTransferFunctionProxy::FindScalarBarRepresentation(map, view)
                       : nullptr;
  };
  vtkSMProxy* before = find();
  const bool done = this->Superclass::SetScalarBarVisibility(view, visible);
  vtkSMProxy* legend = find();
  if (legend && legend != before)
  {
    const char* array = vtkSMPropertyHelper(this, "ColorArrayName").GetInputArrayNameToProcess();
    display_hints::ForDisplay(this,
      [&](vtkPVXMLElement* element)
      {
        display_hints::ForNested(element, "Legend",
          [&](vtkPVXMLElement* nested)
          {
            if (array && std::strcmp(nested->GetAttributeOrEmpty("array"), array) == 0)
            {
              display_hints::SetProperties(legend, nested, [](const std::string&) { return true; });
              legend->UpdateVTKObjects();
            }
          });
      });
  }
  return done;
}

#if !__has_include("vtkSMColorMapEditorHelper.h")
//------------------------------------------------------------------------------
bool vtkSMDirectionFieldRepresentationProxy::RescaleTransferFunctionToDataRange(
  vtkPVArrayInformation* info, bool extend, bool force)
{
  return info && this->Superclass::RescaleTransferFunctionToDataRange(info, extend, force);
}
#endif
