// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSMDirectionFieldDisplay.h"

#include "ColorMaps.h"
#include "DisplayHints.h"
#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkSMDirectionFieldRepresentationProxy.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyListDomain.h"
#include "vtkSMSettings.h"

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
      ForNested(element, "ColorMap",
        [&](vtkPVXMLElement* map)
        {
          if (!color_maps::IsSymmetric(map))
          {
            color_maps::Give(proxy, map);
          }
        });
      ForNested(
        element, "Glyph", [&](vtkPVXMLElement* glyph) { ChooseGlyph(proxy, glyph, isFree); });
      display_hints::SetProperties(proxy, element, isFree);
    });
  if (auto* representation = vtkSMDirectionFieldRepresentationProxy::SafeDownCast(proxy))
  {
    representation->LeaveColoringOfOneValue();
    representation->GiveSymmetricColorMaps();
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
