// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPGatheredSurface.h"

#include "vtkDataObject.h"
#include "vtkObjectFactory.h"

using DirectionFields::Parallel::OtherInput;
using DirectionFields::Parallel::OutputKind;

vtkStandardNewMacro(vtkPGatheredSurface);

//------------------------------------------------------------------------------
vtkPGatheredSurface::vtkPGatheredSurface()
  : vtkPDirectionFieldFilter({ OtherInput::None, { OutputKind::OfItself } })
{
}

//------------------------------------------------------------------------------
void vtkPGatheredSurface::Execute(
  const Ports& inputs, const Ports& outputs, const DirectionFields::Progress&)
{
  outputs[0]->ShallowCopy(inputs[0]);
}
