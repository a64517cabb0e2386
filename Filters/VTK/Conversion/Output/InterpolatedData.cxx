// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Output/InterpolatedData.h"

#include "Conversion/Input/FieldArrays.h"

#include "vtkDataSetAttributes.h"

#include <string>

namespace DirectionFields
{
void DropWhatIsNotToInterpolate(vtkDataSetAttributes* data)
{
  for (int k = data->GetNumberOfArrays() - 1; k >= 0; --k)
  {
    const char* name = data->GetArrayName(k);
    if (name &&
      (ArrayNames::IsOfTheField(name, 16) || name == std::string(ArrayNames::OriginalPointIds) ||
        name == std::string(vtkDataSetAttributes::GhostArrayName())))
    {
      data->RemoveArray(k);
    }
  }
}
}
