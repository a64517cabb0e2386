// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPStripePattern.h"

#include "vtkObjectFactory.h"

using DirectionFields::Parallel::OtherInput;
using DirectionFields::Parallel::OutputKind;

vtkStandardNewMacro(vtkPStripePattern);

//------------------------------------------------------------------------------
vtkPStripePattern::vtkPStripePattern()
  : vtkPDirectionFieldFilter(
      { OtherInput::None, { OutputKind::OfItself, OutputKind::OfItself, OutputKind::OfItself } })
{
}
