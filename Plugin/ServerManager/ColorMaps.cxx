// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColorMaps.h"

#include "DisplayHints.h"
#include "vtkNew.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSettings.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMTransferFunctionProxy.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>
#include <string>

namespace color_maps
{
namespace
{
/// How far the map was stretched last; 0 before there were values. Kept in states, too.
constexpr const char* Reach = "DirectionFieldsReach";

bool HasSetting(const std::string& key)
{
  return vtkSMSettings::GetInstance()->HasSetting(key.c_str());
}

double ReachOf(vtkSMProxy* map)
{
  std::istringstream stream(map->GetAnnotation(Reach));
  stream.imbue(std::locale::classic());
  double reach = 0.0;
  stream >> reach;
  return reach;
}

void SetReach(vtkSMProxy* map, double reach)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(std::numeric_limits<double>::max_digits10) << reach;
  map->SetAnnotation(Reach, text.str().c_str());
}

/// Whether the range of a map is still the one that it was given.
bool IsUntouched(vtkSMProxy* map, double reach)
{
  double range[2];
  return reach == 0.0 ||
    (vtkSMTransferFunctionProxy::GetRange(map, range) &&
      std::abs(range[0] + reach) < 1e-6 * reach && std::abs(range[1] - reach) < 1e-6 * reach);
}
}

//------------------------------------------------------------------------------
bool IsSymmetric(vtkPVXMLElement* element)
{
  int is = 0;
  return element->GetScalarAttribute("symmetric", &is) && is != 0;
}

//------------------------------------------------------------------------------
void Give(vtkSMProxy* display, vtkPVXMLElement* element)
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
  display_hints::SetProperties(map, element, [](const std::string&) { return true; });
  if (IsSymmetric(element))
  {
    SetReach(map, 0.0);
  }
  map->UpdateVTKObjects();
}

//------------------------------------------------------------------------------
void Stretch(vtkSMProxy* map, vtkPVArrayInformation* values)
{
  if (!map || !values || !map->HasAnnotation(Reach))
  {
    return;
  }
  const double* const range = values->GetComponentFiniteRange(0);
  const double most = std::max(std::abs(range[0]), std::abs(range[1]));
  const double reach = ReachOf(map);
  // Without values the range is upside down.
  if (range[0] > range[1] || !(most > reach) || !IsUntouched(map, reach))
  {
    return;
  }
  vtkSMTransferFunctionProxy::RescaleTransferFunction(map, -most, most);
  vtkSMTransferFunctionProxy::RescaleTransferFunction(
    vtkSMPropertyHelper(map, "ScalarOpacityFunction", /*quiet=*/true).GetAsProxy(), -most, most);
  SetReach(map, most);
}
}
