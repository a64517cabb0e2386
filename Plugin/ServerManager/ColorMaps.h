// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The color maps that the hints of a filter name; see vtkSMDirectionFieldDisplay.
 */

#ifndef ColorMaps_h
#define ColorMaps_h

#include "vtkSMProxy.h"

class vtkPVArrayInformation;
class vtkPVXMLElement;

namespace color_maps
{
/// Gives the array that an element ColorMap names its map in the session of a display, unless it
/// has one, or the user has saved one for it.
void Give(vtkSMProxy* display, vtkPVXMLElement* element);

bool IsSymmetric(vtkPVXMLElement* element);

/// Stretches a map that is symmetric to both sides of 0 as far as the values reach; later no less
/// far, so that the steps of a time series compare. Another map, and one to which the user has given
/// a range, stays.
void Stretch(vtkSMProxy* map, vtkPVArrayInformation* values);
}

#endif
