// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPVDirectionFieldPipeline.h"

#include "vtkPDirectionFieldPipeline.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVDirectionFieldPipeline);

//------------------------------------------------------------------------------
void vtkPVDirectionFieldPipeline::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
int vtkPVDirectionFieldPipeline::ForwardUpstream(vtkInformation* request)
{
  return vtkPDirectionFieldPipeline::Agree(
    this, request, this->Superclass::ForwardUpstream(request));
}
