// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPFieldAlignedRemesh.h"

#include "vtkObjectFactory.h"

using DirectionFields::Parallel::OtherInput;
using DirectionFields::Parallel::OutputKind;

vtkStandardNewMacro(vtkPFieldAlignedRemesh);

//------------------------------------------------------------------------------
vtkPFieldAlignedRemesh::vtkPFieldAlignedRemesh()
  : vtkPDirectionFieldFilter(
      { OtherInput::Parts, { OutputKind::OfItself, OutputKind::OfItself, OutputKind::OfItself } })
{
}
