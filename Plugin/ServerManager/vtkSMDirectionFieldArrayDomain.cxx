// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSMDirectionFieldArrayDomain.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMDirectionFieldArrayDomain);

//------------------------------------------------------------------------------
vtkSMDirectionFieldArrayDomain::vtkSMDirectionFieldArrayDomain() = default;
vtkSMDirectionFieldArrayDomain::~vtkSMDirectionFieldArrayDomain() = default;

//------------------------------------------------------------------------------
void vtkSMDirectionFieldArrayDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
