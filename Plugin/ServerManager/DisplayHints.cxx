// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DisplayHints.h"

#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMStringVectorProperty.h"
#include "vtkSMVectorProperty.h"

#include <locale>
#include <sstream>
#include <utility>
#include <vector>

namespace display_hints
{
//------------------------------------------------------------------------------
void ForNested(vtkPVXMLElement* element, const std::string& name,
  const std::function<void(vtkPVXMLElement*)>& visit)
{
  for (unsigned int i = 0; i < element->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* nested = element->GetNestedElement(i);
    if (nested->GetName() && nested->GetName() == name)
    {
      visit(nested);
    }
  }
}

namespace
{
/// The hints of the filter that a display shows, or null, and the port of it.
std::pair<vtkPVXMLElement*, int> HintsOf(vtkSMProxy* display)
{
  vtkSMPropertyHelper input(display, "Input", /*quiet=*/true);
  vtkSMProxy* filter = input.GetNumberOfElements() == 1 ? input.GetAsProxy() : nullptr;
  return { filter ? filter->GetHints() : nullptr,
    filter ? static_cast<int>(input.GetOutputPort()) : 0 };
}

/// Numbers of the XML have a decimal point, whatever the user's numbers have.
double Number(const std::string& text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double number = 0.0;
  stream >> number;
  return number;
}
}

//------------------------------------------------------------------------------
bool HasHint(vtkSMProxy* display, const std::string& name)
{
  vtkPVXMLElement* const hints = HintsOf(display).first;
  return hints && hints->FindNestedElementByName(name.c_str());
}

//------------------------------------------------------------------------------
void ForDisplay(vtkSMProxy* display, const std::function<void(vtkPVXMLElement*)>& visit)
{
  const auto [hints, port] = HintsOf(display);
  if (!hints)
  {
    return;
  }
  ForNested(hints, "DirectionFieldDisplay",
    [&, port = port](vtkPVXMLElement* element)
    {
      int of = 0;
      if (!element->GetScalarAttribute("port", &of) || of == port)
      {
        visit(element);
      }
    });
}

//------------------------------------------------------------------------------
void SetProperties(vtkSMProxy* proxy, vtkPVXMLElement* element,
  const std::function<bool(const std::string&)>& isFree)
{
  ForNested(element, "Property",
    [&](vtkPVXMLElement* nested)
    {
      const char* name = nested->GetAttributeOrEmpty("name");
      auto* property = vtkSMVectorProperty::SafeDownCast(proxy->GetProperty(name));
      if (!property || !isFree(name))
      {
        return;
      }
      // With a semicolon after the last one too, so that it may be empty.
      std::vector<std::string> values;
      std::istringstream stream(std::string(nested->GetAttributeOrEmpty("values")) + ';');
      for (std::string value; std::getline(stream, value, ';');)
      {
        values.push_back(value);
      }
      vtkSMPropertyHelper helper(property);
      const bool isText = vtkSMStringVectorProperty::SafeDownCast(property) != nullptr;
      helper.SetNumberOfElements(static_cast<unsigned int>(values.size()));
      for (unsigned int i = 0; i < values.size(); ++i)
      {
        if (isText)
        {
          helper.Set(i, values[i].c_str());
        }
        else
        {
          helper.Set(i, Number(values[i]));
        }
      }
      // Else a value that is the default as it stands would give way to that of the domains.
      property->Modified();
    });
}
}
