// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPGuidanceCurves.h"

#include "vtkObjectFactory.h"

using DirectionFields::Parallel::OtherInput;
using DirectionFields::Parallel::OutputKind;

vtkStandardNewMacro(vtkPGuidanceCurves);

//------------------------------------------------------------------------------
vtkPGuidanceCurves::vtkPGuidanceCurves()
  : vtkPDirectionFieldFilter({ OtherInput::Parts, { OutputKind::Surface, OutputKind::OfItself } })
{
}
