// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPDirectionField.h"

#include "Distributable.h"
#include "DistributedField.h"
#include "Gathering/GatheredSurface.h"
#include "Gathering/PartsOfSurface.h"
#include "Gathering/Scattering.h"
#include "Processes.h"
#include "Running/Blocks.h"
#include "Running/GatheringWarnings.h"
#include "Running/ProgressWatch.h"
#include "SurfacePiece.h"

#include <DirectionFields/Progress.h>

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPDirectionFieldPipeline.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <exception>
#include <numeric>
#include <utility>

using DirectionFields::Parallel::AddWarning;
using DirectionFields::Parallel::DescribeLostCopies;
using DirectionFields::Parallel::GatheredSurface;
using DirectionFields::Parallel::Processes;

vtkStandardNewMacro(vtkPDirectionField);

//------------------------------------------------------------------------------
vtkPDirectionField::vtkPDirectionField()
  : Controller(nullptr)
  , Distribution(AUTOMATIC)
  , GatherLimit(20000000)
  , Together(nullptr)
  , WidestType(VTK_FLOAT)
  , SharedPoints(0)
  , Exchange(std::make_unique<DirectionFields::Parallel::PointExchange>())
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkPDirectionField::~vtkPDirectionField()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
void vtkPDirectionField::SetController(vtkMultiProcessController* controller)
{
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, controller);
  this->GetInformation()->Set(vtkPDirectionFieldPipeline::CONTROLLER(), controller);
}

//------------------------------------------------------------------------------
void vtkPDirectionField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "Distribution: " << this->Distribution << "\n";
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
void vtkPDirectionField::AddDistribution(
  int used, vtkIdType pieces, vtkIdType sharedPoints, vtkPolyData* output) const
{
  if (!this->Diagnostics)
  {
    return;
  }
  vtkNew<vtkIdTypeArray> distribution;
  distribution->SetName("Distribution");
  distribution->SetNumberOfComponents(3);
  distribution->SetComponentName(0, "Used");
  distribution->SetComponentName(1, "Pieces");
  distribution->SetComponentName(2, "SharedPoints");
  const vtkIdType values[] = { used, pieces, sharedPoints };
  distribution->InsertNextTypedTuple(values);
  output->GetFieldData()->AddArray(distribution);
}

//------------------------------------------------------------------------------
void vtkPDirectionField::ComputeWhole(Processes& processes, int process, vtkPolyData* input,
  vtkPolyData* output, vtkPolyData* singularities)
{
  DirectionFields::Parallel::ComputeOnOne(
    processes, process, this,
    [&](std::string& error) {
      return this->Compute({ input }, { output, singularities }, error);
    },
    [this] { return this->IsStopped(); });
}

//------------------------------------------------------------------------------
void vtkPDirectionField::ComputeOnOne(Processes& processes, int process, vtkPolyData* input,
  vtkPolyData* output, vtkPolyData* singularities)
{
  const bool isThere = processes.Own() == process;
  this->ComputeWhole(processes, process, input, output, singularities);
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
    this->AddDistribution(0, 1, 0, output);
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
void vtkPDirectionField::ComputePiece(
  Processes& processes, vtkPolyData* input, vtkPolyData* output, vtkPolyData* singularities)
{
  processes.Together([&] { CheckInput(input); });
  const vtkIdType polygons = input->GetNumberOfPolys() + input->GetNumberOfStrips();
  const std::vector<vtkIdType> sizes = processes.AllGather({ polygons });
  if (std::count(sizes.begin(), sizes.end(), 0) + 1 == processes.Count())
  {
    const auto largest = std::max_element(sizes.begin(), sizes.end());
    this->ComputeOnOne(
      processes, static_cast<int>(largest - sizes.begin()), input, output, singularities);
    return;
  }
  const vtkIdType all = std::accumulate(sizes.begin(), sizes.end(), vtkIdType(0));
  const bool isLarge = all > this->GatherLimit;
  std::string warning;
  if (all > 0 &&
    (this->Distribution == DISTRIBUTED || (this->Distribution == AUTOMATIC && isLarge)))
  {
    std::string reason;
    if (!DirectionFields::Parallel::CanDistribute())
    {
      reason = "this build has no PETSc; install PETSc for complex numbers "
               "(libpetsc-complex-dev) and build again with DIRECTIONFIELDS_USE_PETSC=ON";
      if (this->Distribution == DISTRIBUTED)
      {
        throw DirectionFields::Parallel::ProcessesError(
          "Set Distribution to Gather or Automatic, for " + reason + ".");
      }
    }
    else if (this->ComputeDistributed(processes, input, output, singularities, reason))
    {
      return;
    }
    warning = "The surface was gathered on one process, for " + reason + ".";
  }
  if (isLarge)
  {
    warning += (warning.empty() ? "" : " ") + DirectionFields::Parallel::DescribeLargeSurface(all);
  }
  this->ComputeGathered(processes, input, warning, output, singularities);
}

//------------------------------------------------------------------------------
bool vtkPDirectionField::ComputeDistributed(Processes& processes, vtkPolyData* input,
  vtkPolyData* output, vtkPolyData* singularities, std::string& reason)
{
  const bool isDouble =
    input->GetNumberOfPoints() > 0 && input->GetPoints()->GetDataType() == VTK_DOUBLE;
  this->WidestType = processes.Largest(isDouble ? 1 : 0) > 0 ? VTK_DOUBLE : VTK_FLOAT;
  this->Together = &processes;
  this->Reason.clear();
  bool isComplete = false;
  const auto compute = [&]
  {
    std::string error;
    isComplete = this->Compute({ input }, { output, singularities }, error);
    if (!isComplete && this->Reason.empty())
    {
      throw DirectionFields::Parallel::ProcessesError(error);
    }
  };
  try
  {
    processes.Together(compute);
  }
  catch (...)
  {
    this->Together = nullptr;
    throw;
  }
  this->Together = nullptr;
  reason = this->Reason;
  if (isComplete)
  {
    DirectionFields::Parallel::SurfacePiece piece;
    processes.Together([&] { piece = DirectionFields::Parallel::ReadPiece(input); });
    const vtkIdType lost =
      DirectionFields::Parallel::ExchangeValues(processes, *this->Exchange, piece, input, output);
    *this->Exchange = {};
    const std::vector<vtkIdType> have = processes.AllGather(
      { input->GetNumberOfPolys() + input->GetNumberOfStrips() > 0 ? vtkIdType(1) : 0 });
    this->AddDistribution(
      2, std::accumulate(have.begin(), have.end(), vtkIdType(0)), this->SharedPoints, output);
    if (lost > 0)
    {
      AddWarning(DescribeLostCopies(lost), output);
      if (processes.Own() == 0)
      {
        vtkWarningMacro(<< DescribeLostCopies(lost));
      }
    }
  }
  return isComplete;
}

//------------------------------------------------------------------------------
DirectionFields::Result vtkPDirectionField::ComputeField(vtkPolyData* input,
  const DirectionFields::Surface& surface, const DirectionFields::Options& options,
  DirectionFields::SurfaceFigures& figures)
{
  if (!this->Together)
  {
    return this->Superclass::ComputeField(input, surface, options, figures);
  }
  Processes& processes = *this->Together;
  DirectionFields::Parallel::SurfacePiece piece;
  DirectionFields::Guidance guidance;
  processes.Together(
    [&]
    {
      piece = DirectionFields::Parallel::ReadPiece(input);
      DirectionFields::Check(options);
      if (!surface.Triangles.empty())
      {
        guidance = this->ReadGuidance(input);
        DirectionFields::Check(guidance, options, surface.Points.size());
      }
    });
  this->Reason = DirectionFields::Parallel::WhyNotDistributed(options);
  if (this->Reason.empty() && this->GetAlignment() == ALIGN_TENSOR)
  {
    this->Reason = "Alignment Tensor needs the whole surface";
  }
  const bool isSoft = std::any_of(guidance.Strengths.begin(), guidance.Strengths.end(),
    [](double strength) { return !(strength >= 1.0); });
  if (processes.Largest(isSoft ? 1 : 0) > 0 && this->Reason.empty())
  {
    this->Reason = "Guidance Strengths below 1 need the whole surface";
  }
  if (this->Reason.empty() && this->GetCellDirections())
  {
    this->Reason = "Cell Directions needs the whole surface";
  }
  if (this->Reason.empty())
  {
    const bool isNextStep = processes.Largest(this->IsNextStep() ? 1 : 0) > 0;
    DirectionFields::Guidance previous;
    processes.Together([&] { previous = this->PreviousField(isNextStep, options.Degree); });
    DirectionFields::Parallel::DistributedField distributed =
      DirectionFields::Parallel::ComputeDistributed(processes, surface, piece, options, guidance,
        previous.Vectors,
        [this](double done)
        {
          this->UpdateProgress(0.05 + 0.85 * done);
          return !this->IsStopped();
        });
    this->Reason = distributed.Reason;
    if (this->Reason.empty())
    {
      this->SharedPoints = distributed.SharedPoints;
      *this->Exchange = std::move(distributed.Exchange);
      figures = distributed.Figures;
      return std::move(distributed.Field);
    }
  }
  throw DirectionFields::Stopped();
}

//------------------------------------------------------------------------------
bool vtkPDirectionField::IsSpeaker() const
{
  return !this->Together || this->Together->Own() == 0;
}

//------------------------------------------------------------------------------
int vtkPDirectionField::TypeOfArrays(vtkPolyData* input) const
{
  return this->Together ? this->WidestType : this->Superclass::TypeOfArrays(input);
}

//------------------------------------------------------------------------------
void vtkPDirectionField::ReadTogether(const std::function<void()>& read)
{
  if (!this->Together)
  {
    read();
    return;
  }
  this->Together->Together(
    [&]
    {
      try
      {
        read();
      }
      catch (const DirectionFields::Stopped&)
      {
        throw DirectionFields::Parallel::ProcessesError("");
      }
    });
}

//------------------------------------------------------------------------------
void vtkPDirectionField::ComputeGathered(Processes& processes, vtkPolyData* input,
  const std::string& warning, vtkPolyData* output, vtkPolyData* singularities)
{
  std::vector<std::string> arrays;
  for (const char* const name :
    { this->GetGuidanceVectors(), this->GetGuidanceWeights(), this->GetGuidanceStrengths() })
  {
    const bool isAsked = name == this->GetGuidanceStrengths()
      ? this->GetConstrainGuidance()
      : this->GetAlignment() == ALIGN_POINT_VECTORS || this->GetConstrainGuidance();
    if (name && isAsked)
    {
      arrays.emplace_back(name);
    }
  }
  std::vector<std::string> cellArrays;
  if (this->GetAlignment() == ALIGN_TENSOR)
  {
    (this->AreTensorsOfCells() ? cellArrays : arrays).push_back(this->GetTensorArrayName());
  }
  const GatheredSurface gathered =
    DirectionFields::Parallel::GatherSurface(processes, input, arrays, cellArrays);
  const bool isThere = gathered.Surface != nullptr;
  std::vector<std::string> warnings;
  if (isThere && !warning.empty())
  {
    warnings.push_back(warning);
  }
  if (gathered.LostCopies > 0)
  {
    warnings.push_back(DescribeLostCopies(gathered.LostCopies));
  }
  for (const std::string& one : warnings)
  {
    vtkWarningMacro(<< one);
  }
  vtkNew<vtkPolyData> whole;
  vtkNew<vtkPolyData> wholeSingularities;
  this->ComputeWhole(processes, gathered.Process, gathered.Surface, whole, wholeSingularities);
  if (isThere)
  {
    this->AddDistribution(1, gathered.Pieces, gathered.SharedPoints, whole);
    for (const std::string& one : warnings)
    {
      AddWarning(one, whole);
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
        { this->ComputePiece(processes, piece, outputs[0], outputs[1]); });
    },
    { output, singularities });
}
