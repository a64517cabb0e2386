// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSMDirectionFieldRepresentationProxy.h"

#include "ColorMaps.h"
#include "DisplayHints.h"
#include "vtkCaptionedRepresentation.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVGeneralSettings.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionProxy.h"
#include "vtkSMViewProxy.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSMDirectionFieldRepresentationProxy);

namespace
{
constexpr const char* DirectionFieldType = "Direction Field";

/// The first input of a display or a filter; null for none.
vtkSMProxy* InputOf(vtkSMProxy* proxy)
{
  const bool has = proxy && proxy->GetProperty("Input");
  return has && vtkSMPropertyHelper(proxy, "Input").GetNumberOfElements() > 0
    ? vtkSMPropertyHelper(proxy, "Input").GetAsProxy()
    : nullptr;
}

/// What is known of the data that a display shows; null where there are none.
vtkPVDataInformation* DataOf(vtkSMProxy* display)
{
  const vtkSMPropertyHelper input(display, "Input", /*quiet=*/true);
  auto* producer =
    vtkSMSourceProxy::SafeDownCast(input.GetNumberOfElements() > 0 ? input.GetAsProxy() : nullptr);
  return producer ? producer->GetDataInformation(input.GetOutputPort()) : nullptr;
}

bool HasPoints(vtkSMProxy* display)
{
  vtkPVDataInformation* const data = DataOf(display);
  return data && data->GetNumberOfPoints() > 0;
}

/// A line as several that end before the legend begins in a view of 600 pixels, as those of the
/// button's summary do. Only a single word may be longer.
std::string Wrapped(const std::string& line)
{
  constexpr std::size_t width = 56;
  std::istringstream words(line);
  std::string text;
  std::size_t length = 0;
  for (std::string word; words >> word;)
  {
    const bool isFirst = text.empty();
    const bool fits = length + 1 + word.size() <= width;
    text += (isFirst ? "" : fits ? " " : "\n") + word;
    length = isFirst || !fits ? word.size() : length + 1 + word.size();
  }
  return text;
}

/// The summaries of all blocks and, below them, the warnings. Those of one block on several processes
/// are the same, and are there once.
std::vector<std::string> CaptionOf(vtkPVDataInformation* data)
{
  std::vector<std::string> lines;
  for (const auto& [array, prefix] : { std::pair<const char*, const char*>{ "Summary", "" },
         std::pair<const char*, const char*>{ "Warnings", "Warning: " } })
  {
    vtkPVArrayInformation* const words =
      data ? data->GetArrayInformation(array, vtkDataObject::FIELD) : nullptr;
    for (int i = 0; words && i < words->GetNumberOfStringValues(); ++i)
    {
      const std::string line = Wrapped(prefix + std::string(words->GetStringValue(i)));
      if (data->IsCompositeDataSet() || std::find(lines.begin(), lines.end(), line) == lines.end())
      {
        lines.push_back(line);
      }
    }
  }
  return lines;
}

/// Whether a view shows points with the colors of a map.
bool ShowsColorsOf(vtkSMProxy* map, vtkSMProxy* view)
{
  const vtkSMPropertyHelper shown(view, "Representations", /*quiet=*/true);
  for (unsigned int i = 0; i < shown.GetNumberOfElements(); ++i)
  {
    auto* const display = vtkSMPVRepresentationProxy::SafeDownCast(shown.GetAsProxy(i));
    if (display && vtkSMPropertyHelper(display, "Visibility", /*quiet=*/true).GetAsInt() != 0 &&
      display->GetUsingScalarColoring() && HasPoints(display) &&
      vtkSMPropertyHelper(display, "LookupTable", /*quiet=*/true).GetAsProxy() == map)
    {
      return true;
    }
  }
  return false;
}

/// Whether ParaView colors a display by an array when nobody chooses: the scalars of the data, or the
/// array by which the input of the filter is shown in the same view.
bool IsParaViewsChoice(
  vtkSMProxy* display, vtkSMProxy* view, int association, const std::string& name)
{
  vtkPVDataInformation* const data = DataOf(display);
  vtkPVDataSetAttributesInformation* const arrays =
    data ? data->GetAttributeInformation(association) : nullptr;
  vtkPVArrayInformation* const scalars =
    arrays ? arrays->GetAttributeInformation(vtkDataSetAttributes::SCALARS) : nullptr;
  if (scalars && scalars->GetName() && name == scalars->GetName())
  {
    return true;
  }
  vtkSMProxy* const source = InputOf(InputOf(display));
  const vtkSMPropertyHelper shown(view, "Representations", /*quiet=*/true);
  for (unsigned int i = 0; source && i < shown.GetNumberOfElements(); ++i)
  {
    auto* const other = vtkSMPVRepresentationProxy::SafeDownCast(shown.GetAsProxy(i));
    if (other && InputOf(other) == source && other->GetUsingScalarColoring())
    {
      const vtkSMPropertyHelper coloring(other, "ColorArrayName");
      const char* const array = coloring.GetInputArrayNameToProcess();
      if (array && name == array && coloring.GetInputArrayAssociation() == association)
      {
        return true;
      }
    }
  }
  return false;
}

/// Whether the picture of a field has a filter of this name: the line that sums the field up, and its
/// smooth surface, whose filter has had several names.
bool IsOfPicture(const std::string& name)
{
  return name == "PythonAnnotation" || name == "ShadedSurface" || name == "PPolyDataNormals" ||
    name == "PolyDataNormals" || name == "SurfaceNormals";
}

/// Hides the legend of a display if no other one shows points with its colors.
void HideUnusedLegend(vtkSMProxy* display, vtkSMProxy* view)
{
  vtkSMProxy* const map = vtkSMPropertyHelper(display, "LookupTable", /*quiet=*/true).GetAsProxy();
  vtkSMProxy* const legend =
    map ? vtkSMTransferFunctionProxy::FindScalarBarRepresentation(map, view) : nullptr;
  if (legend && !ShowsColorsOf(map, view))
  {
    vtkSMPropertyHelper(legend, "Visibility").Set(0);
    legend->UpdateVTKObjects();
  }
}
}

//------------------------------------------------------------------------------
vtkSMDirectionFieldRepresentationProxy::vtkSMDirectionFieldRepresentationProxy() = default;
vtkSMDirectionFieldRepresentationProxy::~vtkSMDirectionFieldRepresentationProxy() = default;

//------------------------------------------------------------------------------
void vtkSMDirectionFieldRepresentationProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
int vtkSMDirectionFieldRepresentationProxy::CreateSubProxiesAndProperties(
  vtkSMSessionProxyManager* manager, vtkPVXMLElement* element)
{
  // An XML cannot name another proxy for a sub-proxy of the one that it is based on. ParaView
  // does not promise that the element is a copy, hence it is left as it was.
  constexpr const char* own = "SurfaceOfDirectionField";
  constexpr const char* base = "SurfaceRepresentation";
  vtkPVXMLElement* surface = nullptr;
  display_hints::ForNested(element, "SubProxy",
    [&](vtkPVXMLElement* nested)
    {
      vtkPVXMLElement* const proxy = nested->FindNestedElementByName("Proxy");
      const bool isSurface = proxy && std::string(base) == proxy->GetAttributeOrEmpty("proxyname");
      surface = isSurface ? proxy : surface;
    });
  if (surface)
  {
    surface->SetAttribute("proxyname", own);
  }
  const int made = this->Superclass::CreateSubProxiesAndProperties(manager, element);
  if (surface)
  {
    surface->SetAttribute("proxyname", base);
  }
  return made;
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

//------------------------------------------------------------------------------
vtkPVArrayInformation* vtkSMDirectionFieldRepresentationProxy::FindArray(
  int association, const std::string& name)
{
  const vtkSMPropertyHelper input(this, "Input");
  auto* producer = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  return producer ? producer->GetDataInformation(input.GetOutputPort())
                      ->GetArrayInformation(name.c_str(), association)
                  : nullptr;
}

//------------------------------------------------------------------------------
void vtkSMDirectionFieldRepresentationProxy::ColorWhereThereAreValues()
{
  this->AwaitedArray.clear();
  if (!this->GetUsingScalarColoring())
  {
    return;
  }
  vtkSMPropertyHelper coloring(this, "ColorArrayName");
  const char* name = coloring.GetInputArrayNameToProcess();
  const int association = coloring.GetInputArrayAssociation();
  if (name && !this->FindArray(association, name))
  {
    this->AwaitedArray = name;
    this->AwaitedAssociation = association;
    coloring.SetInputArrayToProcess(association, "");
  }
}

//------------------------------------------------------------------------------
void vtkSMDirectionFieldRepresentationProxy::LeaveOneValue(vtkSMProxy* view)
{
  vtkSMPropertyHelper coloring(this, "ColorArrayName");
  const int association = coloring.GetInputArrayAssociation();
  const char* name = coloring.GetInputArrayNameToProcess();
  vtkPVArrayInformation* const array = name ? this->FindArray(association, name) : nullptr;
  bool isHinted = false;
  display_hints::ForDisplay(this,
    [&](vtkPVXMLElement* element)
    {
      display_hints::ForNested(element, "ColorMap",
        [&](vtkPVXMLElement* map) {
          isHinted =
            isHinted || (name && std::strcmp(map->GetAttributeOrEmpty("array"), name) == 0);
        });
    });
  if (array && !isHinted && array->GetNumberOfComponents() == 1 &&
    IsParaViewsChoice(this, view, association, name))
  {
    const double* const range = array->GetComponentRange(0);
    // What is interpolated, as the value of a contour, differs by rounding.
    const double rounding = 1e-6 * std::max(std::abs(range[0]), std::abs(range[1]));
    if (range[1] - range[0] <= rounding)
    {
      coloring.SetInputArrayToProcess(association, "");
      this->UpdateVTKObjects();
      HideUnusedLegend(this, view);
    }
  }
}

//------------------------------------------------------------------------------
void vtkSMDirectionFieldRepresentationProxy::ViewUpdated(vtkSMProxy* view)
{
  this->Superclass::ViewUpdated(view);
  if (this->HidesDirections)
  {
    this->HidesDirections = false;
    this->HideDirectionsIn(view);
  }
  if (this->LeavesOneValue && this->GetUsingScalarColoring())
  {
    this->LeaveOneValue(view);
  }
  this->LeavesOneValue = false;
  this->GiveSymmetricColorMaps();
  if (!this->AwaitedArray.empty())
  {
    this->ColorAwaited(view);
  }
  else if (this->GetUsingScalarColoring())
  {
    this->LeaveVanished(view);
  }
  if (this->GetUsingScalarColoring())
  {
    const vtkSMPropertyHelper coloring(this, "ColorArrayName");
    color_maps::Stretch(vtkSMPropertyHelper(this, "LookupTable", /*quiet=*/true).GetAsProxy(),
      this->FindArray(coloring.GetInputArrayAssociation(), coloring.GetInputArrayNameToProcess()));
  }
  this->HideEmptyLegend(view);
  this->WriteCaption();
}

//------------------------------------------------------------------------------
void vtkSMDirectionFieldRepresentationProxy::WriteCaption()
{
  if (auto* const display = vtkCaptionedRepresentation::SafeDownCast(this->GetClientSideObject()))
  {
    display->SetSummary(CaptionOf(DataOf(this)));
  }
}

//------------------------------------------------------------------------------
void vtkSMDirectionFieldRepresentationProxy::ForSymmetricColorMaps(
  const std::function<void(const std::string&, vtkPVXMLElement*)>& visit)
{
  display_hints::ForDisplay(this,
    [&](vtkPVXMLElement* element)
    {
      display_hints::ForNested(element, "ColorMap",
        [&](vtkPVXMLElement* map)
        {
          if (color_maps::IsSymmetric(map))
          {
            visit(map->GetAttributeOrEmpty("array"), map);
          }
        });
    });
}

//------------------------------------------------------------------------------
void vtkSMDirectionFieldRepresentationProxy::GiveSymmetricColorMaps()
{
  this->ForSymmetricColorMaps(
    [&](const std::string& array, vtkPVXMLElement* map)
    {
      if (this->FindArray(vtkDataObject::POINT, array) ||
        this->FindArray(vtkDataObject::CELL, array))
      {
        color_maps::Give(this, map);
      }
    });
}

//------------------------------------------------------------------------------
void vtkSMDirectionFieldRepresentationProxy::LeaveVanished(vtkSMProxy* view)
{
  const vtkSMPropertyHelper coloring(this, "ColorArrayName");
  const std::string name = coloring.GetInputArrayNameToProcess();
  bool isHinted = false;
  this->ForSymmetricColorMaps(
    [&](const std::string& array, vtkPVXMLElement*) { isHinted = isHinted || array == name; });
  // Without points there are no arrays either, which is as it should be.
  if (isHinted && HasPoints(this) && !this->FindArray(coloring.GetInputArrayAssociation(), name))
  {
    this->ColorWhereThereAreValues();
    this->UpdateVTKObjects();
    HideUnusedLegend(this, view);
  }
}

//------------------------------------------------------------------------------
void vtkSMDirectionFieldRepresentationProxy::HideEmptyLegend(vtkSMProxy* view)
{
  // The data of a hidden display need not be there yet when a state has been loaded: the legend is
  // that of another one then.
  if (vtkSMPropertyHelper(this, "Visibility", /*quiet=*/true).GetAsInt() == 0)
  {
    return;
  }
  bool hasLegend = false;
  display_hints::ForDisplay(this,
    [&](vtkPVXMLElement* element)
    { hasLegend = hasLegend || element->FindNestedElementByName("Legend"); });
  vtkSMProxy* const map =
    hasLegend ? vtkSMPropertyHelper(this, "LookupTable", /*quiet=*/true).GetAsProxy() : nullptr;
  vtkSMProxy* const legend =
    map ? vtkSMTransferFunctionProxy::FindScalarBarRepresentation(map, view) : nullptr;
  if (!legend)
  {
    return;
  }
  const bool isVisible = vtkSMPropertyHelper(legend, "Visibility").GetAsInt() != 0;
  const bool isNeeded = ShowsColorsOf(map, view);
  // One that the user hides stays hidden.
  if (isVisible != isNeeded && (isVisible ? !HasPoints(this) : this->HasHiddenLegend))
  {
    this->HasHiddenLegend = isVisible;
    vtkSMPropertyHelper(legend, "Visibility").Set(isNeeded ? 1 : 0);
    legend->UpdateVTKObjects();
  }
}

//------------------------------------------------------------------------------
void vtkSMDirectionFieldRepresentationProxy::HideDirectionsIn(vtkSMProxy* view)
{
  vtkSMProxy* const own = InputOf(this);
  vtkSMProxy* const field = InputOf(own);
  const vtkSMPropertyHelper shown(view, "Representations", /*quiet=*/true);
  bool hasChanged = false;
  for (unsigned int i = 0; field && i < shown.GetNumberOfElements(); ++i)
  {
    vtkSMProxy* const display = shown.GetAsProxy(i);
    vtkSMProxy* const source = InputOf(display);
    const std::string name = source ? source->GetXMLName() : "";
    const bool isOfField = source && source != own && InputOf(source) == field;
    if ((isOfField && name == "DirectionFieldGlyphs") ||
      (this->ReplacesField && (source == field || (isOfField && IsOfPicture(name)))))
    {
      vtkSMPropertyHelper(display, "Visibility").Set(0);
      HideUnusedLegend(display, view);
    }
    else if (source == field &&
      std::string(DirectionFieldType) ==
        vtkSMPropertyHelper(display, "Representation", /*quiet=*/true).GetAsString())
    {
      vtkSMPropertyHelper(display, "Representation").Set("Surface");
    }
    else
    {
      continue;
    }
    display->UpdateVTKObjects();
    hasChanged = true;
  }
  if (auto* const all = vtkSMViewProxy::SafeDownCast(hasChanged ? view : nullptr))
  {
    // The surface has not been prepared for the representation that shows it now.
    all->Update();
  }
}

//------------------------------------------------------------------------------
void vtkSMDirectionFieldRepresentationProxy::ColorAwaited(vtkSMProxy* view)
{
  const bool isColored = this->GetUsingScalarColoring();
  if (!isColored && !this->FindArray(this->AwaitedAssociation, this->AwaitedArray))
  {
    return;
  }
  const std::string array = this->AwaitedArray;
  this->AwaitedArray.clear();
  if (!isColored && this->SetScalarColoring(array.c_str(), this->AwaitedAssociation))
  {
    this->UpdateVTKObjects();
    if (vtkPVGeneralSettings::GetInstance()->GetScalarBarMode() ==
      vtkPVGeneralSettings::AUTOMATICALLY_SHOW_AND_HIDE_SCALAR_BARS)
    {
      this->SetScalarBarVisibility(view, true);
    }
  }
}

#if !__has_include("vtkSMColorMapEditorHelper.h")
//------------------------------------------------------------------------------
bool vtkSMDirectionFieldRepresentationProxy::RescaleTransferFunctionToDataRange(
  vtkPVArrayInformation* info, bool extend, bool force)
{
  return info && this->Superclass::RescaleTransferFunctionToDataRange(info, extend, force);
}
#endif
