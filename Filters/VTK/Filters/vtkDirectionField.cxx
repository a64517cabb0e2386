// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDirectionField.h"

#include "Conversion/Input/PolyDataCheck.h"
#include "Conversion/Input/PolyDataToGuidance.h"
#include "Conversion/Output/CellDirections.h"
#include "Conversion/Output/FieldToPolyData.h"
#include "Conversion/Output/SingularityPoints.h"
#include "Support/AlgorithmProgress.h"
#include "Support/DefaultThreads.h"
#include "Support/DirectionFieldCache.h"
#include "Support/FilterRun.h"
#include "Support/Summary.h"
#include "Support/Threads.h"
#include "Support/Warnings.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <exception>
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
  this->Degree = defaults.Degree;
  this->EnergyBias = defaults.EnergyBias;
  this->Tolerance = defaults.Tolerance;
  this->MaximumIterations = defaults.MaximumIterations;
  this->Solver = static_cast<int>(defaults.Solver);
  this->NumberOfThreads = defaults.NumberOfThreads;
  this->KeepStages = true;
  this->MergePoints = static_cast<int>(defaults.MergePoints);
  this->IntrinsicDelaunay = defaults.IntrinsicDelaunay;
  this->CellDirections = false;
  this->UnitLength = defaults.UnitLength;
  this->SingularityCost = defaults.SingularityCost;
  this->Alignment = static_cast<int>(defaults.Alignment);
  this->CurvatureDirection = static_cast<int>(defaults.CurvatureDirection);
  this->CurvatureScale = defaults.CurvatureScale;
  this->AlignmentStrength = defaults.AlignmentStrength;
  this->UseShift = defaults.UseShift;
  this->Shift = defaults.Shift;
  this->GuidanceVectors = nullptr;
  this->GuidanceWeights = nullptr;
  this->ConstrainBoundary = defaults.ConstrainBoundary;
  this->ConstrainSharpEdges = defaults.ConstrainSharpEdges;
  this->FeatureAngle = defaults.FeatureAngle;
  this->MinimumFeatureLength = defaults.MinimumFeatureLength;
  this->ConstrainCurvature = defaults.ConstrainCurvature;
  this->CurvatureTolerance = defaults.CurvatureTolerance;
  this->ConsistencyAngle = defaults.ConsistencyAngle;
  this->DropConstraintsAtSingularities = defaults.DropConstraintsAtSingularities;
  this->ConstrainGuidance = defaults.ConstrainGuidance;
  this->ConstraintSolver = static_cast<int>(defaults.ConstraintSolver);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkDirectionField::~vtkDirectionField()
{
  this->SetGuidanceVectors(nullptr);
  this->SetGuidanceWeights(nullptr);
}

//------------------------------------------------------------------------------
void vtkDirectionField::ReleaseStages()
{
  this->Last = std::make_unique<DirectionFields::DirectionFieldCache>();
}

//------------------------------------------------------------------------------
void vtkDirectionField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Degree: " << this->Degree << "\n";
  os << indent << "EnergyBias: " << this->EnergyBias << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "Solver: " << this->Solver << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "KeepStages: " << this->KeepStages << "\n";
  os << indent << "MergePoints: " << this->MergePoints << "\n";
  os << indent << "IntrinsicDelaunay: " << this->IntrinsicDelaunay << "\n";
  os << indent << "CellDirections: " << this->CellDirections << "\n";
  os << indent << "UnitLength: " << this->UnitLength << "\n";
  os << indent << "SingularityCost: " << this->SingularityCost << "\n";
  os << indent << "Alignment: " << this->Alignment << "\n";
  os << indent << "CurvatureDirection: " << this->CurvatureDirection << "\n";
  os << indent << "CurvatureScale: " << this->CurvatureScale << "\n";
  os << indent << "AlignmentStrength: " << this->AlignmentStrength << "\n";
  os << indent << "UseShift: " << this->UseShift << "\n";
  os << indent << "Shift: " << this->Shift << "\n";
  os << indent << "GuidanceVectors: " << (this->GuidanceVectors ? this->GuidanceVectors : "(none)")
     << "\n";
  os << indent << "GuidanceWeights: " << (this->GuidanceWeights ? this->GuidanceWeights : "(none)")
     << "\n";
  os << indent << "ConstrainBoundary: " << this->ConstrainBoundary << "\n";
  os << indent << "ConstrainSharpEdges: " << this->ConstrainSharpEdges << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MinimumFeatureLength: " << this->MinimumFeatureLength << "\n";
  os << indent << "ConstrainCurvature: " << this->ConstrainCurvature << "\n";
  os << indent << "CurvatureTolerance: " << this->CurvatureTolerance << "\n";
  os << indent << "ConsistencyAngle: " << this->ConsistencyAngle << "\n";
  os << indent << "DropConstraintsAtSingularities: " << this->DropConstraintsAtSingularities
     << "\n";
  os << indent << "ConstrainGuidance: " << this->ConstrainGuidance << "\n";
  os << indent << "ConstraintSolver: " << this->ConstraintSolver << "\n";
}

//------------------------------------------------------------------------------
DirectionFields::Options vtkDirectionField::MakeOptions() const
{
  DirectionFields::Options options;
  options.Degree = this->Degree;
  options.EnergyBias = this->EnergyBias;
  options.Tolerance = this->Tolerance;
  options.MaximumIterations = this->MaximumIterations;
  options.Solver = static_cast<DirectionFields::Solver>(this->Solver);
  options.NumberOfThreads =
    this->NumberOfThreads > 0 ? this->NumberOfThreads : DirectionFields::DefaultThreads();
  options.MergePoints = static_cast<DirectionFields::MergePoints>(this->MergePoints);
  options.IntrinsicDelaunay = this->IntrinsicDelaunay;
  options.UnitLength = this->UnitLength;
  options.SingularityCost = this->SingularityCost;
  options.Alignment = static_cast<DirectionFields::Alignment>(this->Alignment);
  options.CurvatureDirection =
    static_cast<DirectionFields::CurvatureDirection>(this->CurvatureDirection);
  options.CurvatureScale = this->CurvatureScale;
  options.AlignmentStrength = this->AlignmentStrength;
  options.UseShift = this->UseShift;
  options.Shift = this->Shift;
  options.ConstrainBoundary = this->ConstrainBoundary;
  options.ConstrainSharpEdges = this->ConstrainSharpEdges;
  options.FeatureAngle = this->FeatureAngle;
  options.MinimumFeatureLength = this->MinimumFeatureLength;
  options.ConstrainCurvature = this->ConstrainCurvature;
  options.CurvatureTolerance = this->CurvatureTolerance;
  options.ConsistencyAngle = this->ConsistencyAngle;
  options.DropConstraintsAtSingularities = this->DropConstraintsAtSingularities;
  options.ConstrainGuidance = this->ConstrainGuidance;
  options.ConstraintSolver = static_cast<DirectionFields::ConstraintSolver>(this->ConstraintSolver);
  return options;
}

//------------------------------------------------------------------------------
DirectionFields::Guidance vtkDirectionField::ReadGuidance(vtkPolyData* input)
{
  // Arrays that nothing asks for may be missing.
  if (this->Alignment == ALIGN_POINT_VECTORS || this->ConstrainGuidance)
  {
    return DirectionFields::PolyDataToGuidance(input, this->GuidanceVectors, this->GuidanceWeights);
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
  const DirectionFields::ProgressFunction progress =
    DirectionFields::ReportTo(this, ProgressRead, ProgressSolved);
  DirectionFields::Result field = this->KeepStages
    ? solver.Compute(options, guidance, progress)
    : std::move(solver).Compute(options, guidance, progress);
  if (!field.Aborted)
  {
    figures = DirectionFields::FiguresOf(surface, field.SingularityIndex);
  }
  return field;
}

//------------------------------------------------------------------------------
void vtkDirectionField::ComputeOutputs(
  vtkInformation* request, vtkPolyData* input, vtkPolyData* output, vtkPolyData* singularities)
{
  const DirectionFields::Options options = this->MakeOptions();
  DirectionFields::Threads threads(options.NumberOfThreads);
  const DirectionFields::Threads::Scope scope(threads);
  const DirectionFields::ProgressFunction report = DirectionFields::ReportTo(this);
  const DirectionFields::Progress progress(report);

  this->ReadTogether(
    [&]
    {
      DirectionFields::CheckPolyData(input);
      this->Last->SetInput(input, TimeOf(request, input), progress.Part(0.0, ProgressRead));
    });
  DirectionFields::SurfaceFigures figures;
  const DirectionFields::Result field =
    this->ComputeField(input, this->Last->GetSurface().Mesh, options, figures);
  if (field.Aborted || DirectionFields::IsAborted(this))
  {
    throw DirectionFields::Stopped();
  }
  this->Last->SetField(field);
  const std::vector<std::string> warnings = DirectionFields::Warnings(field, options);
  for (const std::string& warning : this->IsSpeaker() ? warnings : std::vector<std::string>{})
  {
    vtkWarningMacro(<< warning);
  }

  const DirectionFields::TriangulatedPolyData& surface = this->Last->GetSurface();
  output->ShallowCopy(input);
  const int type = this->TypeOfArrays(input);
  DirectionFields::AddFieldArrays(surface, field, type, output, progress.Part(ProgressSolved, 1.0));
  if (this->CellDirections)
  {
    DirectionFields::AddCellDirections(output);
  }
  DirectionFields::AddReport(field.Repaired, warnings, output->GetFieldData());
  DirectionFields::MakeSingularPoints(surface, field, figures, type, singularities);
  const std::string summary = DirectionFields::Summary(figures, field, options);
  for (vtkPolyData* const data : { output, singularities })
  {
    DirectionFields::AddSummary(summary, data->GetFieldData());
  }
  this->UpdateProgress(1.0);
}

//------------------------------------------------------------------------------
int vtkDirectionField::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* singularities = vtkPolyData::GetData(outputVector, 1);
  if (!input || !output || !singularities)
  {
    return 0;
  }
  std::string error;
  const bool isRight =
    this->Compute(outputVector->GetInformationObject(0), input, output, singularities, error) ||
    error.empty();
  if (!isRight)
  {
    vtkErrorMacro(<< error);
  }
  return isRight ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkDirectionField::Compute(vtkInformation* request, vtkPolyData* input, vtkPolyData* output,
  vtkPolyData* singularities, std::string& error)
{
  bool isComplete = false;
  error.clear();
  DirectionFields::RunFilter(
    [&]
    {
      this->ComputeOutputs(request, input, output, singularities);
      isComplete = true;
    },
    { output, singularities }, error);
  if (!this->KeepStages)
  {
    this->ReleaseStages();
  }
  return isComplete;
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
void vtkDirectionField::CheckInput(vtkPolyData* input)
{
  DirectionFields::CheckPolyData(input);
}

//------------------------------------------------------------------------------
void vtkDirectionField::RemoveField(vtkPolyData* output)
{
  DirectionFields::RemoveFieldArrays(output);
}

//------------------------------------------------------------------------------
bool vtkDirectionField::IsStopped()
{
  return DirectionFields::IsAborted(this);
}
