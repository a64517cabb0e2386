// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPDirectionFieldWriter.h"

#include "Processes.h"

#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPDirectionFieldPipeline.h"
#include "vtkPGatheredSurface.h"
#include "vtkPolyData.h"

#include <exception>
#include <string>

using DirectionFields::Parallel::Processes;
using DirectionFields::Parallel::ProcessesError;

vtkStandardNewMacro(vtkPDirectionFieldWriter);

//------------------------------------------------------------------------------
vtkPDirectionFieldWriter::vtkPDirectionFieldWriter()
  : Gather(vtkPGatheredSurface::New())
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkPDirectionFieldWriter::~vtkPDirectionFieldWriter()
{
  this->Gather->Delete();
}

//------------------------------------------------------------------------------
void vtkPDirectionFieldWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->GetController() << "\n";
  os << indent << "GatherLimit: " << this->GetGatherLimit() << "\n";
}

//------------------------------------------------------------------------------
void vtkPDirectionFieldWriter::SetController(vtkMultiProcessController* controller)
{
  this->Gather->SetController(controller);
  this->GetInformation()->Set(vtkPDirectionFieldPipeline::CONTROLLER(), controller);
  this->Modified();
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkPDirectionFieldWriter::GetController()
{
  return this->Gather->GetController();
}

//------------------------------------------------------------------------------
void vtkPDirectionFieldWriter::SetGatherLimit(vtkIdType limit)
{
  this->Gather->SetGatherLimit(limit);
  this->Modified();
}

//------------------------------------------------------------------------------
vtkIdType vtkPDirectionFieldWriter::GetGatherLimit()
{
  return this->Gather->GetGatherLimit();
}

//------------------------------------------------------------------------------
vtkIdType vtkPDirectionFieldWriter::GetGatherLimitMinValue()
{
  return this->Gather->GetGatherLimitMinValue();
}

//------------------------------------------------------------------------------
vtkIdType vtkPDirectionFieldWriter::GetGatherLimitMaxValue()
{
  return this->Gather->GetGatherLimitMaxValue();
}

//------------------------------------------------------------------------------
bool vtkPDirectionFieldWriter::HasSeveralProcesses()
{
  return this->GetController() && this->GetController()->GetNumberOfProcesses() > 1;
}

//------------------------------------------------------------------------------
vtkExecutive* vtkPDirectionFieldWriter::CreateDefaultExecutive()
{
  return vtkPDirectionFieldPipeline::New();
}

//------------------------------------------------------------------------------
int vtkPDirectionFieldWriter::FillInputPortInformation(int port, vtkInformation* info)
{
  const int isFilled = this->Superclass::FillInputPortInformation(port, info);
  if (this->HasSeveralProcesses())
  {
    // As a whole: the pipeline would call for each block that a process has, and processes that
    // have fewer blocks would be waited for.
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  }
  return isFilled;
}

//------------------------------------------------------------------------------
void vtkPDirectionFieldWriter::WriteData()
{
  if (!this->HasSeveralProcesses())
  {
    this->Superclass::WriteData();
    return;
  }
  Processes processes(this->GetController());
  std::string error;
  try
  {
    this->WriteGathered(processes);
    return;
  }
  catch (const std::exception& exception)
  {
    error = exception.what();
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
  }
  this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
}

//------------------------------------------------------------------------------
void vtkPDirectionFieldWriter::WriteGathered(Processes& processes)
{
  vtkNew<vtkPolyData> piece;
  processes.Together(
    [&]
    {
      if (!this->GetInput())
      {
        throw ProcessesError("The input is no vtkPolyData on this process. Give a single dataset "
                             "on each, as Merge Blocks makes it of a composite one.");
      }
      piece->ShallowCopy(this->GetInput());
    });
  this->Gather->SetInputData(piece);
  const bool isGathered = this->Gather->GetExecutive()->Update() != 0;
  vtkNew<vtkPolyData> whole;
  whole->ShallowCopy(this->Gather->GetOutput());
  this->Gather->SetInputData(nullptr);
  this->Gather->GetOutput()->Initialize();
  if (!isGathered)
  {
    // It has said why, on all processes.
    throw ProcessesError("");
  }
  const bool isHere = whole->GetNumberOfCells() > 0;
  const bool isNowhere = processes.Largest(isHere ? 1 : 0) == 0;
  processes.Together(
    [&]
    {
      const bool writes = isHere || (isNowhere && processes.Own() == 0);
      const std::string error = writes ? this->WriteSurface(whole) : std::string();
      if (!error.empty())
      {
        throw ProcessesError(error);
      }
    });
}
