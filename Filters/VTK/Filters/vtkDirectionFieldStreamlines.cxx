// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDirectionFieldStreamlines.h"

#include "Conversion/Input/PolyDataCheck.h"
#include "Conversion/Input/PolyDataToField.h"
#include "Conversion/Input/PolyDataToSurface.h"
#include "Conversion/Output/StreamlinesToPolyData.h"
#include "Support/AlgorithmProgress.h"

#include <DirectionFields/Reports/DrawingReports.h>

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkDirectionFieldStreamlines);

namespace
{
// Where the phases of the progress end: reading the input, tracing the lines.
constexpr double ProgressRead = 0.2;
constexpr double ProgressTraced = 0.95;
}

//------------------------------------------------------------------------------
vtkDirectionFieldStreamlines::vtkDirectionFieldStreamlines()
{
  const DirectionFields::StreamlineOptions defaults;
  this->SeedType = static_cast<int>(defaults.Seeds);
  this->SeparatingDistance = defaults.Spacing;
  this->SeparatingDistanceRatio = defaults.Ratio;
  this->MaximumStreamlineLength = defaults.MaximumLength;
  this->MinimumStreamlineLength = defaults.MinimumLength;
  this->StopAtCrossings = defaults.StopAtCrossings;
  this->IntegrationDirection = static_cast<int>(defaults.Direction);
  this->MaximumNumberOfLines = defaults.MaximumNumber;
  this->Offset = defaults.Offset;
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkDirectionFieldStreamlines::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SeedType: " << this->SeedType << "\n";
  os << indent << "SeparatingDistance: " << this->SeparatingDistance << "\n";
  os << indent << "SeparatingDistanceRatio: " << this->SeparatingDistanceRatio << "\n";
  os << indent << "MaximumStreamlineLength: " << this->MaximumStreamlineLength << "\n";
  os << indent << "MinimumStreamlineLength: " << this->MinimumStreamlineLength << "\n";
  os << indent << "StopAtCrossings: " << this->StopAtCrossings << "\n";
  os << indent << "IntegrationDirection: " << this->IntegrationDirection << "\n";
  os << indent << "MaximumNumberOfLines: " << this->MaximumNumberOfLines << "\n";
  os << indent << "Offset: " << this->Offset << "\n";
}

//------------------------------------------------------------------------------
void vtkDirectionFieldStreamlines::SetSeedSourceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
int vtkDirectionFieldStreamlines::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
DirectionFields::StreamlineOptions vtkDirectionFieldStreamlines::MakeOptions() const
{
  DirectionFields::StreamlineOptions options;
  options.Seeds = static_cast<DirectionFields::SeedType>(this->SeedType);
  options.Spacing = this->SeparatingDistance;
  options.Ratio = this->SeparatingDistanceRatio;
  options.MaximumLength = this->MaximumStreamlineLength;
  options.MinimumLength = this->MinimumStreamlineLength;
  options.StopAtCrossings = this->StopAtCrossings;
  options.Direction =
    static_cast<DirectionFields::IntegrationDirection>(this->IntegrationDirection);
  options.MaximumNumber = this->MaximumNumberOfLines;
  options.Offset = this->Offset;
  return options;
}

//------------------------------------------------------------------------------
void vtkDirectionFieldStreamlines::Execute(
  const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress)
{
  auto* const input = vtkPolyData::SafeDownCast(inputs[0]);
  auto* const seeds = vtkPointSet::SafeDownCast(inputs[1]);
  DirectionFields::CheckPolyData(input);
  if (input->GetNumberOfPoints() == 0)
  {
    // Nothing to follow, but cells without points are an error.
    DirectionFields::PolyDataToSurface(input);
    return;
  }
  if (this->SeedType == POINTS && !seeds)
  {
    throw std::invalid_argument("Lines from points need points: give a second input (Seed Source), "
                                "or choose another Seed Type.");
  }
  const DirectionFields::PointDirections directions = DirectionFields::RequireDirections(input);
  const DirectionFields::TriangulatedPolyData surface =
    DirectionFields::PolyDataToSurface(input, progress.Part(0.0, 0.5 * ProgressRead));
  const DirectionFields::GivenField field(surface.Mesh, directions);
  progress.Report(ProgressRead);
  const DirectionFields::StreamlineOptions options = this->MakeOptions();
  const DirectionFields::Streamlines traced = DirectionFields::TraceStreamlines(field, directions,
    this->SeedType == POINTS ? DirectionFields::NearestPlaces(surface.Mesh, seeds)
                             : std::vector<DirectionFields::StreamlineSeed>(),
    options, DirectionFields::ReportTo(this, ProgressRead, ProgressTraced));
  this->ThrowIfStopped(traced.Aborted);
  this->Warn(DirectionFields::Warnings(traced, options));
  const int type = input->GetPoints()->GetDataType();
  DirectionFields::AddLines(traced, type, this->Diagnostics, vtkPolyData::SafeDownCast(outputs[0]));
  DirectionFields::AddTensorValues(traced, surface, input, vtkPolyData::SafeDownCast(outputs[0]));
  DirectionFields::AddNodes(
    traced, field.GetDegree(), surface, type, vtkPolyData::SafeDownCast(outputs[1]));
  const std::string summary = DirectionFields::Summary(traced, options.Seeds);
  Summarize(summary, outputs);
}

//------------------------------------------------------------------------------
const char* vtkDirectionFieldStreamlines::MemoryAdvice() const
{
  return "Raise Spacing, lower Maximum Streamline Length, or decimate the surface";
}
