// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPDirectionFieldGlyphs.h"

#include "Gathering/GatheredSurface.h"
#include "Gathering/PartsOfSurface.h"
#include "Gathering/Scattering.h"
#include "Processes.h"
#include "Running/Blocks.h"
#include "Running/ProgressWatch.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPDirectionFieldPipeline.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>
#include <vector>

using DirectionFields::Parallel::GatheredSurface;
using DirectionFields::Parallel::Processes;

vtkStandardNewMacro(vtkPDirectionFieldGlyphs);

//------------------------------------------------------------------------------
vtkPDirectionFieldGlyphs::vtkPDirectionFieldGlyphs()
  : Controller(nullptr)
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkPDirectionFieldGlyphs::~vtkPDirectionFieldGlyphs()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
void vtkPDirectionFieldGlyphs::SetController(vtkMultiProcessController* controller)
{
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, controller);
  this->GetInformation()->Set(vtkPDirectionFieldPipeline::CONTROLLER(), controller);
}

//------------------------------------------------------------------------------
void vtkPDirectionFieldGlyphs::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
}

//------------------------------------------------------------------------------
bool vtkPDirectionFieldGlyphs::HasSeveralProcesses() const
{
  return this->Controller && this->Controller->GetNumberOfProcesses() > 1;
}

//------------------------------------------------------------------------------
vtkExecutive* vtkPDirectionFieldGlyphs::CreateDefaultExecutive()
{
  return vtkPDirectionFieldPipeline::New();
}

//------------------------------------------------------------------------------
int vtkPDirectionFieldGlyphs::FillInputPortInformation(int port, vtkInformation* info)
{
  if (!this->HasSeveralProcesses())
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  DirectionFields::Parallel::AcceptBlocks(info);
  return 1;
}

//------------------------------------------------------------------------------
void vtkPDirectionFieldGlyphs::DrawPiece(
  Processes& processes, vtkPolyData* input, vtkPolyData* output)
{
  constexpr int mostDirections = 16;
  processes.Together([&] { CheckInput(input); });
  const auto draw = [&](int process, vtkPolyData* surface, vtkPolyData* glyphs)
  {
    DirectionFields::Parallel::ComputeOnOne(
      processes, process, this,
      [&](std::string& error) { return this->Compute({ surface }, { glyphs }, error); },
      [this] { return this->IsStopped(); });
  };
  const std::vector<vtkIdType> sizes =
    processes.AllGather({ input->GetNumberOfPolys() + input->GetNumberOfStrips() });
  if (std::count(sizes.begin(), sizes.end(), 0) + 1 == processes.Count())
  {
    const int process =
      static_cast<int>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
    draw(process, input, output);
    DirectionFields::Parallel::AddMissingArrays(processes, process, output, output);
    DirectionFields::Parallel::BroadcastFieldData(
      processes, process, output->GetFieldData(), output->GetFieldData());
    return;
  }
  std::vector<std::string> arrays = { "RepresentationMagnitude" };
  for (int k = 0; k < mostDirections; ++k)
  {
    arrays.push_back("Direction" + std::to_string(k));
  }
  const GatheredSurface gathered =
    DirectionFields::Parallel::GatherSurface(processes, input, arrays);
  vtkNew<vtkPolyData> whole;
  draw(gathered.Process, gathered.Surface, whole);
  DirectionFields::Parallel::ScatterParts(processes, gathered,
    DirectionFields::Parallel::PartsBelongTo::Points, gathered.Surface ? whole.Get() : nullptr,
    output);
}

//------------------------------------------------------------------------------
int vtkPDirectionFieldGlyphs::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->HasSeveralProcesses())
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  vtkDataObject* const output = vtkDataObject::GetData(outputVector, 0);
  Processes processes(this->Controller);
  return DirectionFields::Parallel::RunTogether(this,
    [&]
    {
      DirectionFields::Parallel::ForEachSurface(processes, vtkDataObject::GetData(inputVector[0]),
        { output },
        [&](vtkPolyData* piece, const std::vector<vtkPolyData*>& outputs)
        { this->DrawPiece(processes, piece, outputs[0]); });
    },
    { output });
}
