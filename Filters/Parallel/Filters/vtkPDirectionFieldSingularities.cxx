// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPDirectionFieldSingularities.h"

#include "vtkObjectFactory.h"

using DirectionFields::Parallel::OtherInput;
using DirectionFields::Parallel::OutputKind;

vtkStandardNewMacro(vtkPDirectionFieldSingularities);

//------------------------------------------------------------------------------
vtkPDirectionFieldSingularities::vtkPDirectionFieldSingularities()
  : vtkPDirectionFieldFilter(
      { OtherInput::Parts, { OutputKind::Surface, OutputKind::OfCells }, true })
{
}
