// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPDirectionFieldStreamlines.h"

#include "vtkObjectFactory.h"

using DirectionFields::Parallel::OtherInput;
using DirectionFields::Parallel::OutputKind;

vtkStandardNewMacro(vtkPDirectionFieldStreamlines);

//------------------------------------------------------------------------------
vtkPDirectionFieldStreamlines::vtkPDirectionFieldStreamlines()
  : vtkPDirectionFieldFilter({ OtherInput::Parts, { OutputKind::OfItself, OutputKind::OfItself } })
{
}
