// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDirectionField.h"

#include "Conversion/Input/FieldArrays.h"
#include "Conversion/Input/PolyDataCheck.h"
#include "Conversion/Input/PolyDataToGuidance.h"
#include "Conversion/Output/CellDirections.h"
#include "Conversion/Output/FieldToPolyData.h"
#include "Conversion/Output/SingularityPoints.h"
#include "Conversion/Tensors/TensorArrays.h"
#include "Support/AlgorithmProgress.h"
#include "Support/DirectionFieldCache.h"

#include <DirectionFields/Guidance/SurfaceTensors.h>
#include <DirectionFields/OptionTable.h>
#include <DirectionFields/Reports/FieldSummary.h>
#include <DirectionFields/Reports/FieldWarnings.h>

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkDirectionField);

namespace
{
// Where the phases of the progress end: reading the input, solving. The rest is writing the arrays.
constexpr double ProgressRead = 0.05;
constexpr double ProgressSolved = 0.9;

/// The field where there is no triangle: zero at every point.
DirectionFields::Result ZeroField(int degree, size_t points)
{
  DirectionFields::Result field;
  field.Degree = degree;
  field.Representation.assign(points, DirectionFields::Complex(0.0));
  field.Normal.assign(points, DirectionFields::Vector3::Zero());
  field.XAxis.assign(points, DirectionFields::Vector3::Zero());
  return field;
}

/// Whether curves guide other blocks of the input, but not this one: the guidance that was chosen
/// is zero there, which is no mistake.
bool IsGuidedElsewhere(vtkPolyData* input, const DirectionFields::Guidance& guidance)
{
  return input->GetFieldData()->HasArray(DirectionFields::ArrayNames::GuidedElsewhere) &&
    std::all_of(guidance.Vectors.begin(), guidance.Vectors.end(),
      [](const DirectionFields::Vector3& vector)
      { return vector == DirectionFields::Vector3::Zero(); });
}

/// The time of the input, if it is one of a series.
std::optional<double> TimeOf(vtkInformation* request, vtkPolyData* input)
{
  if (request->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()))
  {
    return request->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
  }
  if (input->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
  {
    return input->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP());
  }
  return {};
}
}

//------------------------------------------------------------------------------
vtkDirectionField::vtkDirectionField()
  : Last(std::make_unique<DirectionFields::DirectionFieldCache>())
{
  const DirectionFields::Options defaults;
#define TAKE_DEFAULT(name, ...) this->name = static_cast<decltype(this->name)>(defaults.name);
  DIRECTIONFIELDS_OPTIONS(TAKE_DEFAULT, TAKE_DEFAULT, TAKE_DEFAULT)
#undef TAKE_DEFAULT
  this->KeepStages = true;
  this->CellDirections = false;
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkDirectionField::~vtkDirectionField() = default;

//------------------------------------------------------------------------------
void vtkDirectionField::ReleaseStages()
{
  this->Last = std::make_unique<DirectionFields::DirectionFieldCache>();
}

//------------------------------------------------------------------------------
void vtkDirectionField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
#define PRINT(name, ...) os << indent << #name ": " << this->name << "\n";
  DIRECTIONFIELDS_OPTIONS(PRINT, PRINT, PRINT)
#undef PRINT
  os << indent << "KeepStages: " << this->KeepStages << "\n";
  os << indent << "CellDirections: " << this->CellDirections << "\n";
  os << indent << "GuidanceVectors: " << (this->GuidanceVectors ? this->GuidanceVectors : "(none)")
     << "\n";
  os << indent << "GuidanceWeights: " << (this->GuidanceWeights ? this->GuidanceWeights : "(none)")
     << "\n";
  os << indent
     << "GuidanceStrengths: " << (this->GuidanceStrengths ? this->GuidanceStrengths : "(none)")
     << "\n";
}

//------------------------------------------------------------------------------
DirectionFields::Options vtkDirectionField::MakeOptions() const
{
  DirectionFields::Options options;
#define HAND_ON(name, ...) options.name = static_cast<decltype(options.name)>(this->name);
  DIRECTIONFIELDS_OPTIONS(HAND_ON, HAND_ON, HAND_ON)
#undef HAND_ON
  options.NumberOfThreads = this->ThreadsToUse();
  if (this->Alignment == ALIGN_TENSOR)
  {
    // Tensors are no guidance of the options: DirectionField::FollowTensors takes them.
    options.Alignment = DirectionFields::Alignment::None;
    options.AlignmentStrength = this->TensorStrength;
  }
  return options;
}

//------------------------------------------------------------------------------
DirectionFields::Guidance vtkDirectionField::ReadGuidance(vtkPolyData* input)
{
  // Arrays that nothing asks for may be missing.
  if (this->Alignment == ALIGN_POINT_VECTORS || this->ConstrainGuidance)
  {
    DirectionFields::Guidance guidance =
      DirectionFields::PolyDataToGuidance(input, this->GuidanceVectors, this->GuidanceWeights);
    if (this->ConstrainGuidance)
    {
      guidance.Strengths =
        DirectionFields::PointValues(input, this->GuidanceStrengths, "Guidance Strengths");
    }
    return guidance;
  }
  return {};
}

//------------------------------------------------------------------------------
DirectionFields::Result vtkDirectionField::ComputeField(vtkPolyData* input,
  const DirectionFields::Surface& surface, const DirectionFields::Options& options,
  DirectionFields::SurfaceFigures& figures)
{
  if (surface.Triangles.empty())
  {
    return ZeroField(options.Degree, surface.Points.size());
  }
  const DirectionFields::Guidance guidance = this->ReadGuidance(input);
  DirectionFields::DirectionField& solver = this->Last->GetSolver();
  if (this->Alignment == ALIGN_TENSOR)
  {
    solver.FollowTensors(
      this->ReadTensors(input, this->Last->GetSurface()), this->MakeTensorOptions());
  }
  else
  {
    solver.FollowNoTensors();
  }
  DirectionFields::Options followed = options;
  if (IsGuidedElsewhere(input, guidance))
  {
    followed.ConstrainGuidance = false;
    followed.Alignment = options.Alignment == DirectionFields::Alignment::PointVectors
      ? DirectionFields::Alignment::None
      : options.Alignment;
  }
  const DirectionFields::ProgressFunction progress =
    DirectionFields::ReportTo(this, ProgressRead, ProgressSolved);
  DirectionFields::Result field = this->KeepStages
    ? solver.Compute(followed, guidance, progress)
    : std::move(solver).Compute(followed, guidance, progress);
  if (!field.Aborted)
  {
    figures = DirectionFields::FiguresOf(surface, field.SingularityIndex);
  }
  return field;
}

//------------------------------------------------------------------------------
bool vtkDirectionField::IsNextStep() const
{
  return this->Last->IsNextStep();
}

//------------------------------------------------------------------------------
DirectionFields::Guidance vtkDirectionField::PreviousField(bool isNextStep, int degree)
{
  DirectionFields::Guidance previous;
  previous.Vectors = this->Last->GetPrevious(isNextStep, degree);
  return previous;
}

//------------------------------------------------------------------------------
void vtkDirectionField::Execute(
  const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress)
{
  auto* const input = vtkPolyData::SafeDownCast(inputs[0]);
  auto* const output = vtkPolyData::SafeDownCast(outputs[0]);
  auto* const singularities = vtkPolyData::SafeDownCast(outputs[1]);
  const DirectionFields::Options options = this->MakeOptions();
  this->ReadTogether(
    [&]
    {
      DirectionFields::CheckPolyData(input);
      this->Last->SetInput(
        input, TimeOf(this->GetOutputInformation(0), input), progress.Part(0.0, ProgressRead));
    });
  DirectionFields::SurfaceFigures figures;
  const DirectionFields::Result field =
    this->ComputeField(input, this->Last->GetSurface().Mesh, options, figures);
  this->ThrowIfStopped(field.Aborted);
  this->Last->SetField(field);
  const std::vector<std::string> warnings = DirectionFields::Warnings(field, options);
  if (this->IsSpeaker())
  {
    this->Warn(warnings);
  }

  const DirectionFields::TriangulatedPolyData& surface = this->Last->GetSurface();
  DirectionFields::CopyWithoutReports(input, output);
  const int type = this->TypeOfArrays(input);
  DirectionFields::AddFieldArrays(surface, field, type, output, progress.Part(ProgressSolved, 1.0));
  const bool hasTensors = this->Alignment == ALIGN_TENSOR && !surface.Mesh.Triangles.empty();
  const auto tensors = hasTensors ? this->Last->GetSolver().GetTensorGuidance() : nullptr;
  if (tensors)
  {
    DirectionFields::AddTensorArrays(*tensors, type, output);
  }
  if (this->CellDirections)
  {
    DirectionFields::AddCellDirections(output);
  }
  DirectionFields::AddReport(field.Repaired, warnings, output->GetFieldData());
  DirectionFields::MakeSingularPoints(surface, field, figures, type, singularities);
  std::string summary = DirectionFields::Summary(figures, field, options);
  if (tensors)
  {
    summary += DirectionFields::DescribeTensors(
      *tensors, this->GetTensorArrayName(), figures, options.Degree);
  }
  if (this->Alignment != ALIGN_POINT_VECTORS && !this->ConstrainGuidance &&
    input->GetPointData()->HasArray(DirectionFields::ArrayNames::GuidanceVectors))
  {
    summary += ", guidance is there but not used (Alignment, Constrain Guidance)";
  }
  Summarize(summary, { output, singularities });
}

//------------------------------------------------------------------------------
int vtkDirectionField::ThreadsToUse() const
{
  return this->NumberOfThreads > 0 ? this->NumberOfThreads : this->Superclass::ThreadsToUse();
}

//------------------------------------------------------------------------------
void vtkDirectionField::Release(bool)
{
  if (!this->KeepStages)
  {
    this->ReleaseStages();
  }
}

//------------------------------------------------------------------------------
int vtkDirectionField::TypeOfArrays(vtkPolyData* input) const
{
  return input->GetPoints() ? input->GetPoints()->GetDataType() : VTK_FLOAT;
}

//------------------------------------------------------------------------------
void vtkDirectionField::ReadTogether(const std::function<void()>& read)
{
  read();
}

//------------------------------------------------------------------------------
void vtkDirectionField::RemoveField(vtkPolyData* output)
{
  DirectionFields::RemoveFieldArrays(output);
}
