// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Too little memory, wherever it is noticed: for each filter one allocation after another fails, and
// all that are too large where there is less room than it needs. That is one error, which says so, and outputs are empty;
// or the result is the same as with enough memory, where what could not be had was not needed. The
// same filter works again afterwards.

#include "Cxx/FilterOutputs.h"
#include "FailingAllocations.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkSMPTools.h"

#include <cstdlib>
#include <functional>
#include <string>

using namespace Checks;

namespace
{
enum class Way
{
  /// An allocation fails, and those after it do not.
  One,
  /// There is a limit to the memory.
  Limit
};

using Pointer = vtkSmartPointer<vtkPolyDataAlgorithm>;

struct Case
{
  const char* Name;
  std::function<Pointer()> Make;
  std::vector<vtkSmartPointer<vtkPolyData>> Inputs;
};

Pointer FilterOf(const Case& one)
{
  const Pointer filter = one.Make();
  for (std::size_t port = 0; port < one.Inputs.size(); ++port)
  {
    filter->SetInputDataObject(static_cast<int>(port), one.Inputs[port]);
  }
  return filter;
}

/// Executes a filter without the pipeline around it, which is VTK's and knows nothing of memory.
/// @param least the allocation that fails, or the memory that there is
/// @return how many allocations were counted, or the memory that was needed
long long Execute(vtkPolyDataAlgorithm* filter, Way way, long long least)
{
  filter->UpdateDataObject();
  vtkNew<vtkInformation> request;
  request->Set(vtkDemandDrivenPipeline::REQUEST_DATA());
  vtkExecutive* const executive = filter->GetExecutive();
  vtkInformationVector** const inputs = executive->GetInputInformation();
  vtkInformationVector* const outputs = executive->GetOutputInformation();
  way == Way::One ? FailAllocation(least, 64) : LimitAllocations(least);
  filter->ProcessRequest(request, inputs, outputs);
  return StopFailingAllocations();
}

std::string Text(vtkPolyDataAlgorithm* filter)
{
  std::string text;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkPolyData* const output = filter->GetOutput(port);
    text += std::to_string(output->GetNumberOfPoints()) + " points, " +
      std::to_string(output->GetNumberOfCells()) + " cells, " +
      std::to_string(output->GetPointData()->GetNumberOfArrays() +
        output->GetCellData()->GetNumberOfArrays() + output->GetFieldData()->GetNumberOfArrays()) +
      " arrays; ";
  }
  return text;
}

bool IsEmpty(vtkPolyDataAlgorithm* filter)
{
  return Text(filter).find_first_of("123456789") == std::string::npos;
}

/// Executes a filter with too little memory. @return whether there was an error
bool TestFailure(const Case& one, const std::string& wanted, Way way, long long least)
{
  const Pointer filter = FilterOf(one);
  vtkNew<Messages> messages;
  messages->Observe(filter);
  Execute(filter, way, least);
  const bool hasError = !messages->Errors.empty();
  const bool isRight = hasError ? messages->Errors.size() == 1 &&
      messages->Errors[0].find("there is too little memory") != std::string::npos && IsEmpty(filter)
                                : Text(filter) == wanted;
  if (!isRight)
  {
    std::cerr << one.Name << (way == Way::One ? ", allocation " : ", bytes ") << least << ": "
              << (hasError ? messages->Errors.front() : "no error") << ", " << Text(filter)
              << "instead of " << wanted << std::endl;
  }
  CHECK(isRight);
  // With memory it works again.
  messages->Errors.clear();
  filter->Modified();
  Execute(filter, way, -1);
  CHECK(messages->Errors.empty());
  CHECK(Text(filter) == wanted);
  return hasError;
}

void TestCase(const Case& one, long long most)
{
  for (const Way way : { Way::One, Way::Limit })
  {
    const Pointer filter = FilterOf(one);
    vtkNew<Messages> unheard;
    unheard->Observe(filter);
    const long long needed = Execute(filter, way, -1);
    const std::string wanted = Text(filter);
    CHECK(!IsEmpty(filter));
    CHECK(needed > 10);
    long long errors = 0;
    long long tried = 0;
    // All of them, or as many as there is time for.
    const double step = std::max(1.0, static_cast<double>(needed) / most);
    for (double at = 0.0; at < needed; at += step)
    {
      ++tried;
      errors += TestFailure(one, wanted, way, static_cast<long long>(at)) ? 1 : 0;
    }
    std::cout << one.Name << ": " << errors << " errors for " << tried << " of " << needed
              << (way == Way::One ? " allocations" : " bytes") << std::endl;
    // What can be done without is rare.
    CHECK(2 * errors >= tried);
  }
}

std::vector<Case> Cases()
{
  const auto mesh = FilterOutputs::Sized(1.0);
  const auto cross = FilterOutputs::Field(mesh, 4);
  const auto lines = FilterOutputs::Field(mesh, 2);
  const auto other = FilterOutputs::Field(PolyMeshes::Pebble(2, VTK_DOUBLE), 4);
  vtkNew<vtkDirectionFieldStreamlines> curves;
  curves->SetSeedType(vtkDirectionFieldStreamlines::SINGULARITIES);
  curves->SetMaximumStreamlineLength(1.0);
  curves->SetInputData(cross);
  curves->Update();
  const auto field = [](int alignment, bool hasUnitLength)
  {
    return [=]
    {
      auto filter = vtkSmartPointer<vtkDirectionField>::New();
      filter->SetNumberOfThreads(2);
      filter->SetAlignment(alignment);
      filter->SetUnitLength(hasUnitLength);
      filter->SetConstrainSharpEdges(hasUnitLength);
      return filter;
    };
  };
  return {
    { "field", field(vtkDirectionField::ALIGN_PRINCIPAL_CURVATURE, false), { mesh } },
    { "unit length", field(vtkDirectionField::ALIGN_NONE, true), { mesh } },
    { "glyphs", [] { return vtkSmartPointer<vtkDirectionFieldGlyphs>::New(); }, { cross } },
    { "lines",
      []
      {
        auto filter = vtkSmartPointer<vtkDirectionFieldStreamlines>::New();
        filter->SetSeparatingDistance(0.2);
        return filter;
      },
      { cross } },
    { "stripes",
      []
      {
        auto filter = vtkSmartPointer<vtkStripePattern>::New();
        filter->SetSpacing(0.3);
        return filter;
      },
      { lines } },
    { "singularities", [] { return vtkSmartPointer<vtkDirectionFieldSingularities>::New(); },
      { cross } },
    { "comparison", [] { return vtkSmartPointer<vtkCompareDirectionFields>::New(); },
      { cross, other } },
    { "guidance", [] { return vtkSmartPointer<vtkGuidanceCurves>::New(); },
      { mesh, curves->GetOutput() } },
    { "remesh",
      []
      {
        auto filter = vtkSmartPointer<vtkFieldAlignedRemesh>::New();
        filter->SetNumberOfFaces(60);
        filter->SetNumberOfThreads(2);
        return filter;
      },
      { cross } },
  };
}
}

int main(int argc, char* argv[])
{
  if (!HasFailingAllocations())
  {
    std::cout << "skipped: this system's memory cannot be made to fail" << std::endl;
    return EXIT_SUCCESS;
  }
  const long long most = argc > 1 ? std::atoll(argv[1]) : 10;
  vtkSMPTools::Initialize(2);
  for (const Case& one : Cases())
  {
    if (argc < 3 || one.Name == std::string(argv[2]))
    {
      TestCase(one, most);
    }
  }
  return Result();
}
