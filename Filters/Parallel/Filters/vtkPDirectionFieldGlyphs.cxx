// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPDirectionFieldGlyphs.h"

#include "vtkObjectFactory.h"

using DirectionFields::Parallel::OtherInput;
using DirectionFields::Parallel::OutputKind;

vtkStandardNewMacro(vtkPDirectionFieldGlyphs);

//------------------------------------------------------------------------------
vtkPDirectionFieldGlyphs::vtkPDirectionFieldGlyphs()
  : vtkPDirectionFieldFilter({ OtherInput::None, { OutputKind::OfPoints } })
{
}
