// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPCompareDirectionFields.h"

#include "vtkObjectFactory.h"

using DirectionFields::Parallel::OtherInput;
using DirectionFields::Parallel::OutputKind;

vtkStandardNewMacro(vtkPCompareDirectionFields);

//------------------------------------------------------------------------------
vtkPCompareDirectionFields::vtkPCompareDirectionFields()
  : vtkPDirectionFieldFilter(
      { OtherInput::Surface, { OutputKind::Surface, OutputKind::OfItself }, true })
{
}
