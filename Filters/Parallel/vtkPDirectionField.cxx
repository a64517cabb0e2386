// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPDirectionField.h"

#include "Blocks.h"
#include "GatheredSurface.h"
#include "PartsOfSurface.h"
#include "Processes.h"
#include "ProgressWatch.h"
#include "Scattering.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPDirectionFieldPipeline.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <exception>

using DirectionFields::Parallel::GatheredSurface;
using DirectionFields::Parallel::Processes;

vtkStandardNewMacro(vtkPDirectionField);

//------------------------------------------------------------------------------
vtkPDirectionField::vtkPDirectionField()
  : Controller(nullptr)
  , GatherLimit(20000000)
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkPDirectionField::~vtkPDirectionField()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
vtkCxxSetObjectMacro(vtkPDirectionField, Controller, vtkMultiProcessController);

//------------------------------------------------------------------------------
void vtkPDirectionField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "GatherLimit: " << this->GatherLimit << "\n";
}

//------------------------------------------------------------------------------
bool vtkPDirectionField::HasSeveralProcesses() const
{
  return this->Controller && this->Controller->GetNumberOfProcesses() > 1;
}

//------------------------------------------------------------------------------
vtkExecutive* vtkPDirectionField::CreateDefaultExecutive()
{
  return vtkPDirectionFieldPipeline::New();
}

//------------------------------------------------------------------------------
int vtkPDirectionField::FillInputPortInformation(int port, vtkInformation* info)
{
  if (!this->HasSeveralProcesses())
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  DirectionFields::Parallel::AcceptBlocks(info);
  return 1;
}

//------------------------------------------------------------------------------
int vtkPDirectionField::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (!this->HasSeveralProcesses())
  {
    return this->Superclass::FillOutputPortInformation(port, info);
  }
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkPDirectionField::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->HasSeveralProcesses() && request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    DirectionFields::Parallel::MakeOutputs(inputVector[0], outputVector);
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
void vtkPDirectionField::AddDistribution(
  int used, const GatheredSurface& gathered, vtkPolyData* output) const
{
  vtkNew<vtkIdTypeArray> distribution;
  distribution->SetName("Distribution");
  distribution->SetNumberOfComponents(3);
  distribution->SetComponentName(0, "Used");
  distribution->SetComponentName(1, "Pieces");
  distribution->SetComponentName(2, "SharedPoints");
  const vtkIdType values[] = { used, gathered.Pieces, gathered.SharedPoints };
  distribution->InsertNextTypedTuple(values);
  output->GetFieldData()->AddArray(distribution);
}

//------------------------------------------------------------------------------
void vtkPDirectionField::ComputeWhole(Processes& processes, int process, vtkInformation* request,
  vtkPolyData* input, vtkPolyData* output, vtkPolyData* singularities)
{
  DirectionFields::Parallel::ComputeOnOne(
    processes, process, this,
    [&](std::string& error) { return this->Compute(request, input, output, singularities, error); },
    [this] { return this->IsStopped(); });
}

//------------------------------------------------------------------------------
void vtkPDirectionField::ComputeOnOne(Processes& processes, int process, vtkInformation* request,
  vtkPolyData* input, vtkPolyData* output, vtkPolyData* singularities)
{
  const bool isThere = processes.Own() == process;
  this->ComputeWhole(processes, process, request, input, output, singularities);
  // The others have no polygons, but arrays of the same names as the surface.
  GatheredSurface gathered;
  gathered.Process = process;
  gathered.Pieces = 1;
  gathered.FirstPointOf.assign(static_cast<std::size_t>(processes.Count()) + 1, 0);
  gathered.FirstCellOf = gathered.FirstPointOf;
  gathered.OwnPointsOf.assign(static_cast<std::size_t>(processes.Count()), 0);
  gathered.OwnCellsOf = gathered.OwnPointsOf;
  vtkNew<vtkPolyData> other;
  other->ShallowCopy(input);
  RemoveField(other);
  if (isThere)
  {
    gathered.Surface = input;
    this->AddDistribution(0, gathered, output);
  }
  DirectionFields::Parallel::ScatterData(processes, gathered, isThere ? output : nullptr, other);
  if (!isThere)
  {
    output->ShallowCopy(other);
  }
  DirectionFields::Parallel::AddMissingArrays(processes, process, singularities, singularities);
  DirectionFields::Parallel::BroadcastFieldData(
    processes, process, singularities->GetFieldData(), singularities->GetFieldData());
}

//------------------------------------------------------------------------------
void vtkPDirectionField::ComputePiece(Processes& processes, vtkInformation* request,
  vtkPolyData* input, vtkPolyData* output, vtkPolyData* singularities)
{
  processes.Together([&] { CheckInput(input); });
  const vtkIdType polygons = input->GetNumberOfPolys() + input->GetNumberOfStrips();
  const std::vector<vtkIdType> sizes = processes.AllGather({ polygons });
  if (std::count(sizes.begin(), sizes.end(), 0) + 1 == processes.Count())
  {
    const auto largest = std::max_element(sizes.begin(), sizes.end());
    this->ComputeOnOne(
      processes, static_cast<int>(largest - sizes.begin()), request, input, output, singularities);
    return;
  }
  std::vector<std::string> arrays;
  for (const char* const name : { this->GetGuidanceVectors(), this->GetGuidanceWeights() })
  {
    const bool isAsked =
      this->GetAlignment() == ALIGN_POINT_VECTORS || this->GetConstrainGuidance();
    if (name && isAsked)
    {
      arrays.emplace_back(name);
    }
  }
  const GatheredSurface gathered =
    DirectionFields::Parallel::GatherSurface(processes, input, arrays);
  const bool isThere = gathered.Surface != nullptr;
  std::string warning;
  if (isThere && gathered.Cells > this->GatherLimit)
  {
    warning = "The surface has " + std::to_string(gathered.Cells) +
      " polygons, more than GatherLimit. All of them are on process " +
      std::to_string(gathered.Process) + " now, which takes about " +
      std::to_string(std::max<vtkIdType>(1, gathered.Cells * 67 / 100000000)) +
      " GB there. Decimate the surface where that is too much.";
    vtkWarningMacro(<< warning);
  }
  vtkNew<vtkPolyData> whole;
  vtkNew<vtkPolyData> wholeSingularities;
  this->ComputeWhole(
    processes, gathered.Process, request, gathered.Surface, whole, wholeSingularities);
  if (isThere)
  {
    this->AddDistribution(1, gathered, whole);
    if (!warning.empty())
    {
      vtkSmartPointer<vtkStringArray> warnings =
        vtkStringArray::SafeDownCast(whole->GetFieldData()->GetAbstractArray("Warnings"));
      if (!warnings)
      {
        warnings = vtkSmartPointer<vtkStringArray>::New();
        warnings->SetName("Warnings");
        whole->GetFieldData()->AddArray(warnings);
      }
      warnings->InsertNextValue(warning);
    }
  }
  output->ShallowCopy(input);
  RemoveField(output);
  DirectionFields::Parallel::ScatterData(
    processes, gathered, isThere ? whole.Get() : nullptr, output);
  DirectionFields::Parallel::ScatterParts(processes, gathered,
    DirectionFields::Parallel::PartsBelongTo::Cells, isThere ? wholeSingularities.Get() : nullptr,
    singularities);
}

//------------------------------------------------------------------------------
int vtkPDirectionField::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->HasSeveralProcesses())
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  vtkDataObject* const output = vtkDataObject::GetData(outputVector, 0);
  vtkDataObject* const singularities = vtkDataObject::GetData(outputVector, 1);
  Processes processes(this->Controller);
  return DirectionFields::Parallel::RunTogether(this,
    [&]
    {
      DirectionFields::Parallel::ForEachSurface(processes, vtkDataObject::GetData(inputVector[0]),
        { output, singularities },
        [&](vtkPolyData* piece, const std::vector<vtkPolyData*>& outputs)
        {
          this->ComputePiece(
            processes, outputVector->GetInformationObject(0), piece, outputs[0], outputs[1]);
        });
    },
    { output, singularities });
}
