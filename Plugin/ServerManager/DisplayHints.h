// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads the hints of a filter about the look of its output; see vtkSMDirectionFieldDisplay.
 */

#ifndef DisplayHints_h
#define DisplayHints_h

#include <functional>
#include <string>

class vtkPVXMLElement;
class vtkSMProxy;

namespace display_hints
{
/// Calls `visit` with the nested elements of a name.
void ForNested(vtkPVXMLElement* element, const std::string& name,
  const std::function<void(vtkPVXMLElement*)>& visit);

/// Calls `visit` with the elements DirectionFieldDisplay for the output that a display shows.
void ForDisplay(vtkSMProxy* display, const std::function<void(vtkPVXMLElement*)>& visit);

/// Whether the filter that a display shows has a hint of a name.
bool HasHint(vtkSMProxy* display, const std::string& name);

/// Gives a proxy the properties that an element names and for which `isFree` is true. Other
/// versions of ParaView may lack one; then the display looks a little different.
void SetProperties(vtkSMProxy* proxy, vtkPVXMLElement* element,
  const std::function<bool(const std::string&)>& isFree);
}

#endif
