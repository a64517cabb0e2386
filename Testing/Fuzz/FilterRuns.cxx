// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterRuns.h"

#include "Cxx/Checks.h"

#include "vtkCellArray.h"
#include "vtkDirectionField.h"
#include "vtkFieldAlignedRemesh.h"
#include "vtkSMPTools.h"

#include <cstddef>

namespace FilterRuns
{
namespace
{
MeshPointer CopyOf(vtkPolyData* mesh)
{
  MeshPointer copy;
  if (mesh)
  {
    copy = MeshPointer::New();
    copy->DeepCopy(mesh);
  }
  return copy;
}

bool IsSame(vtkFieldData* one, vtkFieldData* other)
{
  return (one->GetNumberOfArrays() == 0 && other->GetNumberOfArrays() == 0) ||
    Checks::IsSame(one, other);
}

bool IsSame(vtkCellArray* one, vtkCellArray* other)
{
  return one->GetNumberOfCells() == other->GetNumberOfCells() &&
    Checks::IsSame(one->GetOffsetsArray(), other->GetOffsetsArray()) &&
    Checks::IsSame(one->GetConnectivityArray(), other->GetConnectivityArray());
}

bool IsSame(vtkPolyData* one, vtkPolyData* other)
{
  if (!one || !other || one->GetNumberOfPoints() != other->GetNumberOfPoints())
  {
    return one == other;
  }
  return (one->GetNumberOfPoints() == 0 ||
           Checks::IsSame(one->GetPoints()->GetData(), other->GetPoints()->GetData())) &&
    IsSame(one->GetVerts(), other->GetVerts()) && IsSame(one->GetLines(), other->GetLines()) &&
    IsSame(one->GetPolys(), other->GetPolys()) && IsSame(one->GetStrips(), other->GetStrips()) &&
    IsSame(one->GetPointData(), other->GetPointData()) &&
    IsSame(one->GetCellData(), other->GetCellData()) &&
    IsSame(one->GetFieldData(), other->GetFieldData());
}

bool IsEmpty(vtkPolyData* output)
{
  return output->GetNumberOfPoints() == 0 && output->GetNumberOfCells() == 0 &&
    output->GetPointData()->GetNumberOfArrays() == 0 &&
    output->GetCellData()->GetNumberOfArrays() == 0 &&
    output->GetFieldData()->GetNumberOfArrays() == 0;
}

bool IsFinite(vtkDataArray* array)
{
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      if (!std::isfinite(array->GetComponent(i, c)))
      {
        return false;
      }
    }
  }
  return true;
}

/// Whether NaN says in an array that there is no number: directions that cannot be compared,
/// singularities without a match, and the middle of a singularity.
bool MayBeNaN(const std::string& name)
{
  return name == "AngleDifference" || name == "MatchDistance" || name.rfind("Divergence", 0) == 0 ||
    name.rfind("Curl", 0) == 0;
}

/// The first array with a number that is not finite, unless the input has one of that name.
std::string NotFinite(vtkFieldData* data, vtkFieldData* input)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    auto* const array = vtkDataArray::SafeDownCast(data->GetAbstractArray(i));
    const char* name = array ? array->GetName() : nullptr;
    if (name && !input->HasArray(name) && !MayBeNaN(name) && !IsFinite(array))
    {
      return std::string(name) + " is not finite";
    }
  }
  return "";
}

std::string NotFinite(vtkPolyData* output, vtkPolyData* input)
{
  std::string flaw = NotFinite(output->GetPointData(), input->GetPointData());
  flaw = flaw.empty() ? NotFinite(output->GetCellData(), input->GetCellData()) : flaw;
  flaw = flaw.empty() ? NotFinite(output->GetFieldData(), input->GetFieldData()) : flaw;
  // Points that no cell has are handed on, wherever they are.
  if (flaw.empty() && output->GetPoints() && !IsFinite(output->GetPoints()->GetData()) &&
    (!input->GetPoints() || IsFinite(input->GetPoints()->GetData())))
  {
    flaw = "a point is nowhere";
  }
  return flaw;
}

void Run(vtkPolyDataAlgorithm* filter, const std::vector<MeshPointer>& inputs, int threads)
{
  vtkSMPTools::Initialize(threads);
  if (auto* const field = vtkDirectionField::SafeDownCast(filter))
  {
    field->SetNumberOfThreads(threads);
  }
  if (auto* const remesh = vtkFieldAlignedRemesh::SafeDownCast(filter))
  {
    remesh->SetNumberOfThreads(threads);
  }
  for (std::size_t port = 0; port < inputs.size(); ++port)
  {
    filter->SetInputDataObject(static_cast<int>(port), inputs[port]);
  }
  filter->Update();
}

/// What differs from an earlier execution.
std::string Difference(
  vtkPolyDataAlgorithm* filter, const Checks::Messages& messages, const Outcome& outcome)
{
  const std::string error = messages.Errors.empty() ? "" : messages.Errors.front();
  if (error != outcome.Error)
  {
    return "an error \"" + error + "\" instead of \"" + outcome.Error + "\"";
  }
  for (std::size_t port = 0; port < outcome.Outputs.size(); ++port)
  {
    if (!IsSame(filter->GetOutput(static_cast<int>(port)), outcome.Outputs[port]))
    {
      return "another output of " + std::string(filter->GetClassName());
    }
  }
  return "";
}

/// The sentence of an error, without the object's address before it.
std::string Sentence(const std::string& error)
{
  const std::size_t end = error.find("): ");
  return end == std::string::npos ? error : error.substr(end + 3);
}
}

Outcome Execute(const Filter& filter)
{
  std::vector<MeshPointer> copies;
  for (const MeshPointer& input : filter.Inputs)
  {
    copies.push_back(CopyOf(input));
  }
  const auto fresh = filter.Make();
  vtkNew<Checks::Messages> messages;
  messages->Observe(fresh);
  Run(fresh, filter.Inputs, 1);
  Outcome outcome;
  outcome.Error = messages->Errors.empty() ? "" : Sentence(messages->Errors.front());
  const std::string name = fresh->GetClassName();
  for (std::size_t i = 0; i < copies.size(); ++i)
  {
    outcome.Flaw = outcome.Flaw.empty() && !IsSame(filter.Inputs[i].Get(), copies[i].Get())
      ? "the input of " + name + " is not as before"
      : outcome.Flaw;
  }
  for (int port = 0; port < fresh->GetNumberOfOutputPorts(); ++port)
  {
    vtkPolyData* const output = fresh->GetOutput(port);
    outcome.Outputs.push_back(CopyOf(output));
    if (outcome.Flaw.empty() && !messages->Errors.empty())
    {
      outcome.Flaw =
        messages->Errors.size() == 1 && IsEmpty(output) ? "" : "an error, and an output of " + name;
    }
    else if (outcome.Flaw.empty())
    {
      const std::string flaw = NotFinite(output, copies[0]);
      outcome.Flaw = flaw.empty() ? "" : name + ": " + flaw;
    }
  }
  return outcome;
}

std::string FlawOfSecondUse(const Filter& filter, const Outcome& outcome)
{
  const auto used = filter.Make();
  vtkNew<Checks::Messages> before;
  before->Observe(used);
  // An icosahedron has no directions: some filters have an error then.
  std::vector<MeshPointer> others(filter.Inputs.size());
  others[0] = PolyMeshes::Icosphere(0);
  Run(used, others, 1);
  // Changed and changed back, so that what the filter keeps is of no use.
  Run(used, filter.Inputs, 1);
  before->Errors.clear();
  used->Modified();
  Run(used, filter.Inputs, 1);
  for (std::string& error : before->Errors)
  {
    error = Sentence(error);
  }
  const std::string flaw = Difference(used, *before, outcome);
  return flaw.empty() ? "" : "used again: " + flaw;
}

std::string FlawOnTwoThreads(const Filter& filter, const Outcome& outcome)
{
  const auto fresh = filter.Make();
  vtkNew<Checks::Messages> messages;
  messages->Observe(fresh);
  Run(fresh, filter.Inputs, 2);
  for (std::string& error : messages->Errors)
  {
    error = Sentence(error);
  }
  const std::string flaw = Difference(fresh, *messages, outcome);
  return flaw.empty() ? "" : "on two threads: " + flaw;
}
}
