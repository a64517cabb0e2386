// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPDirectionFieldReader.h"

#include "vtkObjectFactory.h"

using DirectionFields::Parallel::OtherInput;
using DirectionFields::Parallel::OutputKind;

vtkStandardNewMacro(vtkPDirectionFieldReader);

//------------------------------------------------------------------------------
vtkPDirectionFieldReader::vtkPDirectionFieldReader()
  : vtkPDirectionFieldFilter({ OtherInput::None, { OutputKind::Surface, OutputKind::OfCells } })
{
}
