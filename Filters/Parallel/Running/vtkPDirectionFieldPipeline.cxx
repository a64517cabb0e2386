// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPDirectionFieldPipeline.h"

#include "Processes.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkPDirectionFieldPipeline);
vtkInformationKeyMacro(vtkPDirectionFieldPipeline, CONTROLLER, ObjectBase);

//------------------------------------------------------------------------------
void vtkPDirectionFieldPipeline::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
int vtkPDirectionFieldPipeline::Agree(vtkExecutive* pipeline, vtkInformation* request, int result)
{
  // The passes of an update that can fail: who fails in one of them makes none of the later ones.
  const bool isPassOfUpdate = request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()) ||
    request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()) ||
    request->Has(vtkDemandDrivenPipeline::REQUEST_DATA());
  if (!isPassOfUpdate)
  {
    return result;
  }
  vtkAlgorithm* const filter = pipeline->GetAlgorithm();
  auto* const controller =
    vtkMultiProcessController::SafeDownCast(filter->GetInformation()->Get(CONTROLLER()));
  if (!controller || controller->GetNumberOfProcesses() < 2)
  {
    return result;
  }
  DirectionFields::Parallel::Processes processes(controller);
  const std::vector<vtkIdType> results = processes.AllGather({ result });
  const auto failed = std::find(results.begin(), results.end(), 0);
  if (failed == results.end())
  {
    return result;
  }
  vtkErrorWithObjectMacro(
    filter, << "What this filter needs has failed on process " << failed - results.begin()
            << ", hence no process executes it. See the errors of the filters before it.");
  return 0;
}

//------------------------------------------------------------------------------
int vtkPDirectionFieldPipeline::ForwardUpstream(vtkInformation* request)
{
  return Agree(this, request, this->Superclass::ForwardUpstream(request));
}
