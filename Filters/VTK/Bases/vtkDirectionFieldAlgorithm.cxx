// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDirectionFieldAlgorithm.h"

#include "Conversion/Input/PolyDataCheck.h"
#include "Conversion/Output/FieldToPolyData.h"
#include "Support/AlgorithmProgress.h"
#include "Support/ArrayRanges.h"
#include "Support/DefaultThreads.h"

#include <DirectionFields/Progress.h>
#include <DirectionFields/Support/Threads.h>

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <exception>
#include <functional>
#include <new>

namespace
{
constexpr const char* TooLittleMemory = ": there is too little memory.";

/// Calls visit with an output, and with each of its blocks where it is composite.
void ForEachPart(vtkDataObject* output, const std::function<void(vtkDataObject*)>& visit)
{
  if (auto* const composite = vtkCompositeDataSet::SafeDownCast(output))
  {
    const auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    {
      visit(at->GetCurrentDataObject());
    }
  }
  visit(output);
}
}

//------------------------------------------------------------------------------
void vtkDirectionFieldAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Diagnostics: " << this->Diagnostics << "\n";
}

//------------------------------------------------------------------------------
void vtkDirectionFieldAlgorithm::Release(bool) {}

//------------------------------------------------------------------------------
int vtkDirectionFieldAlgorithm::ThreadsToUse() const
{
  return DirectionFields::DefaultThreads();
}

//------------------------------------------------------------------------------
const char* vtkDirectionFieldAlgorithm::MemoryAdvice() const
{
  return "Decimate the surface or process it in parts";
}

//------------------------------------------------------------------------------
void vtkDirectionFieldAlgorithm::CheckInput(vtkPolyData* input)
{
  DirectionFields::CheckPolyData(input);
}

//------------------------------------------------------------------------------
bool vtkDirectionFieldAlgorithm::IsStopped()
{
  return DirectionFields::IsAborted(this);
}

//------------------------------------------------------------------------------
void vtkDirectionFieldAlgorithm::ThrowIfStopped(bool wasAborted)
{
  if (wasAborted || this->IsStopped())
  {
    throw DirectionFields::Stopped();
  }
}

//------------------------------------------------------------------------------
void vtkDirectionFieldAlgorithm::Warn(const std::vector<std::string>& warnings)
{
  for (const std::string& warning : warnings)
  {
    vtkWarningMacro(<< warning);
  }
}

//------------------------------------------------------------------------------
void vtkDirectionFieldAlgorithm::Summarize(const std::string& summary, const Ports& outputs)
{
  for (vtkDataObject* const output : outputs)
  {
    DirectionFields::AddSummary(summary, output->GetFieldData());
  }
}

//------------------------------------------------------------------------------
int vtkDirectionFieldAlgorithm::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (!this->TakesBlocks())
  {
    return this->Superclass::FillOutputPortInformation(port, info);
  }
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkDirectionFieldAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->TakesBlocks() || !request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->Superclass::ProcessRequest(request, inputVector, outputVector);
  }
  auto* const composite = vtkCompositeDataSet::SafeDownCast(vtkDataObject::GetData(inputVector[0]));
  const std::string wanted = composite ? composite->GetClassName() : "vtkPolyData";
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject* const now = vtkDataObject::GetData(outputVector, port);
    if (!now || now->GetClassName() != wanted)
    {
      outputVector->GetInformationObject(port)->Set(vtkDataObject::DATA_OBJECT(),
        vtkSmartPointer<vtkDataObject>::Take(
          composite ? static_cast<vtkDataObject*>(composite->NewInstance()) : vtkPolyData::New()));
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkDirectionFieldAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  std::string error;
  try
  {
    Ports inputs;
    for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
    {
      inputs.push_back(vtkDataObject::GetData(inputVector[port]));
      if (!inputs.back() && !this->GetInputPortInformation(port)->Has(INPUT_IS_OPTIONAL()))
      {
        return 0;
      }
    }
    Ports outputs;
    for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
    {
      outputs.push_back(vtkDataObject::GetData(outputVector, port));
      if (!outputs.back())
      {
        return 0;
      }
    }
    if (this->Compute(inputs, outputs, error) || error.empty())
    {
      return 1;
    }
  }
  catch (const std::bad_alloc&)
  {
    // Even the lists of inputs and outputs had no room.
    for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
    {
      vtkDataObject::GetData(outputVector, port)->Initialize();
    }
    error = std::string(this->MemoryAdvice()) + TooLittleMemory;
  }
  vtkErrorMacro(<< error);
  return 0;
}

//------------------------------------------------------------------------------
bool vtkDirectionFieldAlgorithm::Compute(
  const Ports& inputs, const Ports& outputs, std::string& error)
{
  bool isComplete = false;
  error.clear();
  try
  {
    for (vtkDataObject* const output : outputs)
    {
      // The pipeline has passed the field data of the first input on.
      DirectionFields::RemoveReports(output->GetFieldData());
    }
    DirectionFields::Threads threads(this->ThreadsToUse());
    const DirectionFields::Threads::Scope scope(threads);
    const DirectionFields::ProgressFunction report = DirectionFields::ReportTo(this);
    if (inputs[0]->IsA("vtkPolyData") || inputs[0]->IsA("vtkCompositeDataSet"))
    {
      this->Execute(inputs, outputs, DirectionFields::Progress(report));
    }
    else
    {
      // A group may have blocks of other kinds, with which the pipeline calls all the same.
      this->Warn({ std::string("Put Extract Surface before this filter: a ") +
        inputs[0]->GetClassName() + " is no surface, and is left out." });
    }
    for (vtkDataObject* const output : outputs)
    {
      if (!output->IsA("vtkCompositeDataSet") && !output->GetFieldData()->HasArray("Summary"))
      {
        Summarize("nothing, for there is no surface", { output });
      }
    }
    for (vtkDataObject* const output : this->Diagnostics ? Ports() : outputs)
    {
      ForEachPart(output,
        [&](vtkDataObject* part)
        { DirectionFields::RemoveDiagnostics(inputs[0]->GetFieldData(), part->GetFieldData()); });
    }
    for (vtkDataObject* const output : outputs)
    {
      ForEachPart(output, DirectionFields::KeepRanges);
    }
    this->UpdateProgress(1.0);
    isComplete = true;
  }
  catch (const DirectionFields::Stopped&)
  {
  }
  catch (const std::bad_alloc&)
  {
    error = std::string(this->MemoryAdvice()) + TooLittleMemory;
  }
  catch (const std::exception& exception)
  {
    error = exception.what();
  }
  for (vtkDataObject* const output : isComplete ? Ports() : outputs)
  {
    output->Initialize();
  }
  this->Release(!error.empty());
  return isComplete;
}
