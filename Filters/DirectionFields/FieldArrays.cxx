// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FieldArrays.h"

namespace DirectionFields
{
namespace ArrayNames
{
std::string Direction(int k)
{
  return "Direction" + std::to_string(k);
}

bool IsOfTheField(const char* name, int degree)
{
  const std::string wanted = name ? name : "";
  for (int k = 0; k < degree; ++k)
  {
    if (wanted == Direction(k))
    {
      return true;
    }
  }
  return wanted == RepresentationMagnitude || wanted == EnergyDensity ||
    wanted == ConstraintDirection || wanted == ConstraintKind || wanted == PrincipalDirection0 ||
    wanted == PrincipalDirection1;
}
}
}
