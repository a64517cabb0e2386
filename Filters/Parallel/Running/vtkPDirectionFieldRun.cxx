// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPDirectionFieldRun.h"

#include "Gathering/GatheredData.h"
#include "Gathering/PartsOfSurface.h"
#include "Gathering/Scattering.h"
#include "Gathering/SplitPiece.h"
#include "Processes.h"
#include "Running/Blocks.h"
#include "Running/GatheringWarnings.h"
#include "Running/ProgressWatch.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <utility>

namespace DirectionFields::Parallel
{
namespace
{
/// Takes the arrays away that the filter has taken away on the whole surface.
void RemoveLostArrays(
  Processes& processes, const GatheredSurface& gathered, vtkPolyData* whole, vtkPolyData* output)
{
  vtkMultiProcessStream stream;
  if (processes.Own() == gathered.Process)
  {
    const auto write = [&stream](vtkDataSetAttributes* before, vtkDataSetAttributes* after)
    {
      std::vector<std::string> names;
      for (int k = 0; k < before->GetNumberOfArrays(); ++k)
      {
        const char* const name = before->GetArrayName(k);
        if (name && !after->HasArray(name))
        {
          names.emplace_back(name);
        }
      }
      stream << static_cast<int>(names.size());
      for (const std::string& name : names)
      {
        stream << name;
      }
    };
    write(gathered.Surface->GetPointData(), whole->GetPointData());
    write(gathered.Surface->GetCellData(), whole->GetCellData());
  }
  processes.GetController()->Broadcast(stream, gathered.Process);
  for (vtkDataSetAttributes* const data :
    { static_cast<vtkDataSetAttributes*>(output->GetPointData()),
      static_cast<vtkDataSetAttributes*>(output->GetCellData()) })
  {
    int count = 0;
    stream >> count;
    for (; count > 0; --count)
    {
      std::string name;
      stream >> name;
      data->RemoveArray(name.c_str());
    }
  }
}

/// Leaves an output on its process; the others get its arrays without values, and its field data.
void LeaveOnOne(Processes& processes, int process, vtkPolyData* whole, vtkPolyData* output)
{
  if (processes.Own() == process)
  {
    output->ShallowCopy(whole);
  }
  AddMissingArrays(processes, process, output, output);
  BroadcastFieldData(processes, process, output->GetFieldData(), output->GetFieldData());
}

bool HasCellsOf(vtkPolyData* output, vtkPolyData* surface)
{
  return output->GetNumberOfPolys() == surface->GetNumberOfPolys() &&
    output->GetNumberOfStrips() == surface->GetNumberOfStrips() &&
    (output->GetNumberOfPoints() == surface->GetNumberOfPoints() || IsSplit(output));
}
}

GatheringRun::GatheringRun(vtkAlgorithm* filter, PortKinds ports)
  : Filter(filter)
  , Ports(std::move(ports))
{
}

GatheringRun::~GatheringRun()
{
  if (this->Controller)
  {
    this->Controller->UnRegister(nullptr);
  }
}

void GatheringRun::SetController(vtkMultiProcessController* controller)
{
  if (controller == this->Controller)
  {
    return;
  }
  if (controller)
  {
    controller->Register(nullptr);
  }
  if (this->Controller)
  {
    this->Controller->UnRegister(nullptr);
  }
  this->Controller = controller;
}

bool GatheringRun::HasSeveralProcesses() const
{
  return this->Controller && this->Controller->GetNumberOfProcesses() > 1;
}

bool GatheringRun::SetGatherLimit(vtkIdType limit)
{
  const vtkIdType before = this->GatherLimit;
  this->GatherLimit = std::max<vtkIdType>(0, std::min<vtkIdType>(limit, LargestGatherLimit));
  return this->GatherLimit != before;
}

void GatheringRun::FillInputPort(int port, vtkInformation* info)
{
  if (port == 0)
  {
    AcceptBlocks(info);
    return;
  }
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
}

bool GatheringRun::HasSurfaceOutput() const
{
  return std::count(this->Ports.Outputs.begin(), this->Ports.Outputs.end(), OutputKind::Surface) >
    0;
}

void GatheringRun::Warn(const WholeSurface& whole, const std::vector<vtkPolyData*>& wholes) const
{
  const GatheredSurface& gathered = whole.Gathered;
  std::vector<std::string> warnings;
  if (gathered.Cells > this->GatherLimit)
  {
    warnings.push_back(DescribeLargeSurface(gathered.Cells));
  }
  if (gathered.LostCopies > 0 && this->HasSurfaceOutput())
  {
    warnings.push_back(DescribeLostCopies(gathered.LostCopies));
  }
  for (const std::string& warning : warnings)
  {
    vtkWarningWithObjectMacro(this->Filter, << warning);
    for (vtkPolyData* const output : wholes)
    {
      AddWarning(warning, output);
    }
  }
}

void GatheringRun::Deliver(Processes& processes, const WholeSurface& whole, vtkPolyData* piece,
  const std::vector<vtkPolyData*>& wholes, const std::vector<vtkPolyData*>& outputs) const
{
  const GatheredSurface& gathered = whole.Gathered;
  const bool isThere = processes.Own() == gathered.Process;
  bool areCellsKept = false;
  for (std::size_t k = 0; k < outputs.size(); ++k)
  {
    const OutputKind kind = this->Ports.Outputs[k];
    if (kind == OutputKind::Surface)
    {
      areCellsKept =
        processes.Largest(isThere && HasCellsOf(wholes[k], gathered.Surface) ? 1 : 0) > 0;
      if (areCellsKept && !(whole.IsInPlace && isThere))
      {
        outputs[k]->ShallowCopy(piece);
        outputs[k]->GetFieldData()->Initialize();
      }
    }
    const bool goesBack = kind == OutputKind::Surface && areCellsKept;
    const bool hasCells = kind == OutputKind::OfCells && areCellsKept && !whole.IsInPlace &&
      processes.Largest(isThere && wholes[k]->GetPointData()->HasArray("CellId") ? 1 : 0) > 0;
    if (goesBack)
    {
      vtkNew<vtkPolyData> unused;
      vtkPolyData* const target = whole.IsInPlace && isThere ? unused.Get() : outputs[k];
      RemoveLostArrays(processes, gathered, wholes[k], target);
      ScatterData(processes, gathered, isThere ? wholes[k] : nullptr, target);
      if (whole.IsInPlace && isThere)
      {
        outputs[k]->ShallowCopy(wholes[k]);
      }
    }
    else if (hasCells || (kind == OutputKind::OfPoints && !whole.IsInPlace))
    {
      ScatterParts(processes, gathered, hasCells ? PartsBelongTo::Cells : PartsBelongTo::Points,
        isThere ? wholes[k] : nullptr, outputs[k]);
    }
    else
    {
      LeaveOnOne(processes, gathered.Process, wholes[k], outputs[k]);
    }
  }
}

void GatheringRun::RunOnPiece(Processes& processes, const FilterWork& work, vtkPolyData* piece,
  vtkDataObject* other, const std::vector<vtkPolyData*>& outputs) const
{
  processes.Together([&] { work.Check(piece); });
  const WholeSurface whole = GatherWhole(processes, piece);
  const int process = whole.Gathered.Process;
  const bool isThere = processes.Own() == process;
  std::vector<vtkDataObject*> inputs(1, whole.Gathered.Surface);
  vtkSmartPointer<vtkPolyData> others;
  if (this->Ports.Other != OtherInput::None)
  {
    if (processes.Largest(other ? 1 : 0) > 0 && this->Ports.Other == OtherInput::Parts)
    {
      others = GatherParts(processes, other, process);
    }
    else if (processes.Largest(other ? 1 : 0) > 0)
    {
      vtkNew<vtkPolyData> none;
      auto* const given = vtkPolyData::SafeDownCast(other);
      vtkPolyData* const otherPiece = given ? given : none.Get();
      processes.Together([&] { work.Check(otherPiece); });
      others = GatherWhole(processes, otherPiece, process).Gathered.Surface;
    }
    inputs.push_back(others);
  }
  std::vector<vtkSmartPointer<vtkPolyData>> made;
  std::vector<vtkPolyData*> wholes;
  std::vector<vtkDataObject*> objects;
  for (std::size_t k = 0; k < outputs.size(); ++k)
  {
    made.push_back(vtkSmartPointer<vtkPolyData>::New());
    wholes.push_back(made.back());
    objects.push_back(made.back());
    if (isThere)
    {
      // As pipelines do.
      made.back()->GetFieldData()->PassData(whole.Gathered.Surface->GetFieldData());
    }
  }
  ComputeOnOne(
    processes, process, this->Filter,
    [&](std::string& error) { return work.Compute(inputs, objects, error); }, work.IsStopped);
  if (isThere && !whole.IsInPlace)
  {
    this->Warn(whole, wholes);
  }
  this->Deliver(processes, whole, piece, wholes, outputs);
}

int GatheringRun::Execute(
  const FilterWork& work, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* const other =
    this->Ports.Other == OtherInput::None ? nullptr : vtkDataObject::GetData(inputVector[1]);
  std::vector<vtkDataObject*> outputs;
  for (std::size_t k = 0; k < this->Ports.Outputs.size(); ++k)
  {
    outputs.push_back(vtkDataObject::GetData(outputVector, static_cast<int>(k)));
  }
  Processes processes(this->Controller);
  const auto run = [&]
  {
    const bool hasBlocks = vtkCompositeDataSet::SafeDownCast(other) != nullptr;
    if (processes.Largest(hasBlocks && this->Ports.OtherBelongsToBlocks ? 1 : 0) > 0)
    {
      throw ProcessesError("The second input is a composite dataset, which this filter does not "
                           "divide among several processes. Give a single dataset there, as Merge "
                           "Blocks makes it, or execute the filter on one process.");
    }
    ForEachSurface(processes, input, outputs,
      [&](vtkPolyData* piece, const std::vector<vtkPolyData*>& ofPiece)
      { this->RunOnPiece(processes, work, piece, other, ofPiece); });
  };
  const int result = RunTogether(this->Filter, run, {});
  for (std::size_t k = 0; result == 0 && k < outputs.size(); ++k)
  {
    outputs[k]->Initialize();
  }
  return result;
}
}
