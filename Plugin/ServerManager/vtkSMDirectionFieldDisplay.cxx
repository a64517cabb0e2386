// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSMDirectionFieldDisplay.h"

#include "DisplayHints.h"
#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkSMDirectionFieldRepresentationProxy.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyListDomain.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSettings.h"
#include "vtkSMTransferFunctionManager.h"

#include <functional>
#include <string>

vtkStandardNewMacro(vtkSMDirectionFieldDisplay);

namespace
{
/// Of the property's name, whether it may be changed.
using Free = std::function<bool(const std::string&)>;

bool All(const std::string&)
{
  return true;
}

bool HasSetting(const std::string& key)
{
  return vtkSMSettings::GetInstance()->HasSetting(key.c_str());
}

//------------------------------------------------------------------------------
void ChooseGlyph(vtkSMProxy* display, vtkPVXMLElement* element, const Free& isFree)
{
  vtkSMProperty* property = display->GetProperty("GlyphType");
  auto* offered = property ? property->FindDomain<vtkSMProxyListDomain>() : nullptr;
  vtkSMProxy* glyph =
    offered ? offered->FindProxy("sources", element->GetAttributeOrEmpty("name")) : nullptr;
  if (glyph && isFree("GlyphType"))
  {
    display_hints::SetProperties(glyph, element, All);
    glyph->UpdateVTKObjects();
    vtkSMPropertyHelper(property).Set(glyph);
  }
}

//------------------------------------------------------------------------------
void GiveColorMap(vtkSMProxy* display, vtkPVXMLElement* element)
{
  const std::string array = element->GetAttributeOrEmpty("array");
  vtkSMSessionProxyManager* manager = display->GetSessionProxyManager();
  if (manager->GetProxy("lookup_tables", (array + ".PVLookupTable").c_str()) ||
    HasSetting(".array_lookup_tables." + array) || HasSetting(".standard_presets." + array))
  {
    return;
  }
  vtkNew<vtkSMTransferFunctionManager> maps;
  vtkSMProxy* map = maps->GetColorTransferFunction(array.c_str(), manager);
  display_hints::SetProperties(map, element, All);
  map->UpdateVTKObjects();
}
}

//------------------------------------------------------------------------------
vtkSMDirectionFieldDisplay::vtkSMDirectionFieldDisplay() = default;
vtkSMDirectionFieldDisplay::~vtkSMDirectionFieldDisplay() = default;

//------------------------------------------------------------------------------
void vtkSMDirectionFieldDisplay::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
void vtkSMDirectionFieldDisplay::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement* vtkNotUsed(xml), vtkMTimeType initializationTimeStamp)
{
  const std::string saved =
    std::string(".") + proxy->GetXMLGroup() + "." + proxy->GetXMLName() + ".";
  const Free isFree = [&](const std::string& name)
  {
    vtkSMProperty* property = proxy->GetProperty(name.c_str());
    return property && property->GetMTime() <= initializationTimeStamp && !HasSetting(saved + name);
  };
  using display_hints::ForNested;
  display_hints::ForDisplay(proxy,
    [&](vtkPVXMLElement* element)
    {
      ForNested(element, "ColorMap", [&](vtkPVXMLElement* map) { GiveColorMap(proxy, map); });
      ForNested(
        element, "Glyph", [&](vtkPVXMLElement* glyph) { ChooseGlyph(proxy, glyph, isFree); });
      display_hints::SetProperties(proxy, element, isFree);
    });
  if (auto* representation = vtkSMDirectionFieldRepresentationProxy::SafeDownCast(proxy))
  {
    representation->ColorWhereThereAreValues();
    if (display_hints::HasHint(proxy, "HideDirections"))
    {
      representation->HideDirections();
    }
    if (display_hints::HasHint(proxy, "ReplaceField"))
    {
      representation->ReplaceField();
    }
  }
  proxy->UpdateVTKObjects();
}
