// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDirectionFieldSingularities.h"

#include "Conversion/Input/FieldArrays.h"
#include "Conversion/Input/PolyDataCheck.h"
#include "Conversion/Input/PolyDataToGuidance.h"
#include "Conversion/Output/EditedPolyData.h"
#include "Conversion/Output/FieldToPolyData.h"
#include "Conversion/Output/RefinedPolyData.h"
#include "Support/SingularityEditorCache.h"

#include <DirectionFields/PrescribedSingularities/EditedResult.h>
#include <DirectionFields/Reports/FieldSummary.h>

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkDirectionFieldSingularities);

namespace
{
using DirectionFields::WantedSingularity;

// Where the phases of the progress end: reading the inputs, the edit. The rest is writing.
constexpr double ProgressRead = 0.3;
constexpr double ProgressEdited = 0.9;
// The largest number of refinements of the surface.
constexpr int MostRefinements = 4;

using Blocks = std::vector<vtkPolyData*>;

/// The blocks of a composite dataset that are polydata, in their order; null for others.
Blocks BlocksOf(vtkCompositeDataSet* composite)
{
  Blocks blocks;
  vtkSmartPointer<vtkCompositeDataIterator> at;
  at.TakeReference(composite->NewIterator());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    blocks.push_back(vtkPolyData::SafeDownCast(at->GetCurrentDataObject()));
  }
  return blocks;
}

/// A list as the second input gives it.
vtkSmartPointer<vtkPolyData> PointsOf(const std::vector<std::array<double, 4>>& list)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> indices;
  indices->SetName(DirectionFields::ArrayNames::SingularityIndex);
  for (const std::array<double, 4>& singularity : list)
  {
    points->InsertNextPoint(singularity.data());
    indices->InsertNextValue(singularity[3]);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(indices);
  return data;
}
}

//------------------------------------------------------------------------------
vtkDirectionFieldSingularities::vtkDirectionFieldSingularities()
  : SingularityMode(REPLACE)
  , Objective(SMOOTHEST)
  , BalanceAutomatically(false)
  , RefineWhereNeeded(false)
  , KeepConstraints(true)
  , Alignment(ALIGN_NONE)
  , AlignmentStrength(0.5)
  , GuidanceVectors(nullptr)
  , GuidanceWeights(nullptr)
  , KeepStages(true)
  , Last(std::make_unique<DirectionFields::SingularityEditorCache>())
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkDirectionFieldSingularities::~vtkDirectionFieldSingularities()
{
  this->SetGuidanceVectors(nullptr);
  this->SetGuidanceWeights(nullptr);
}

//------------------------------------------------------------------------------
void vtkDirectionFieldSingularities::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SingularityMode: " << this->SingularityMode << "\n";
  os << indent << "List: " << this->List.size() << "\n";
  os << indent << "Objective: " << this->Objective << "\n";
  os << indent << "BalanceAutomatically: " << this->BalanceAutomatically << "\n";
  os << indent << "RefineWhereNeeded: " << this->RefineWhereNeeded << "\n";
  os << indent << "KeepConstraints: " << this->KeepConstraints << "\n";
  os << indent << "Alignment: " << this->Alignment << "\n";
  os << indent << "AlignmentStrength: " << this->AlignmentStrength << "\n";
  os << indent << "GuidanceVectors: " << (this->GuidanceVectors ? this->GuidanceVectors : "(none)")
     << "\n";
  os << indent << "GuidanceWeights: " << (this->GuidanceWeights ? this->GuidanceWeights : "(none)")
     << "\n";
  os << indent << "KeepStages: " << this->KeepStages << "\n";
}

//------------------------------------------------------------------------------
void vtkDirectionFieldSingularities::SetSingularitiesConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkDirectionFieldSingularities::AddSingularity(double x, double y, double z, double index)
{
  const bool isIndex = std::abs(index) <= std::numeric_limits<short>::max();
  this->List.push_back({ x, y, z, isIndex ? std::round(index) : 0.0 });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkDirectionFieldSingularities::RemoveAllSingularities()
{
  if (!this->List.empty())
  {
    this->List.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkDirectionFieldSingularities::SetSingularitiesData(vtkDataObject* points)
{
  this->SetInputData(1, points);
}

//------------------------------------------------------------------------------
int vtkDirectionFieldSingularities::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
DirectionFields::EditOptions vtkDirectionFieldSingularities::MakeOptions() const
{
  DirectionFields::EditOptions options;
  options.IsWholeList = options.KeepsUnmet = !this->List.empty();
  options.AddsToBase = this->SingularityMode == ADD && this->List.empty();
  options.Objective = static_cast<DirectionFields::RotationObjective>(this->Objective);
  options.Balances = this->BalanceAutomatically;
  options.AlignmentStrength = this->Alignment == ALIGN_NONE ? 0.0 : this->AlignmentStrength;
  return options;
}

//------------------------------------------------------------------------------
void vtkDirectionFieldSingularities::EditBlock(vtkPolyData* input,
  const std::vector<WantedSingularity>* given, const DirectionFields::Progress& progress,
  vtkPolyData* output, vtkPolyData* singularities)
{
  DirectionFields::SingularityEditorCache::Block& block =
    this->Last->Next(input, this->KeepConstraints, progress.Part(0.0, ProgressRead));
  if (!block.Editor)
  {
    DirectionFields::CopyWithoutReports(input, output);
    return;
  }
  // Without points the field has its own singularities, to which nothing is added.
  std::vector<WantedSingularity> wanted;
  if (given || this->SingularityMode == REPLACE)
  {
    wanted = given ? *given : block.Editor->GetOwnSingularities();
  }
  std::vector<std::string> warnings;
  DirectionFields::SingularityEditorCache::Block refined;
  DirectionFields::SingularityEditorCache::Block* edits = &block;
  vtkSmartPointer<vtkPolyData> surface = input;
  DirectionFields::EditedField edited = this->EditField(
    surface, *block.Editor, wanted, progress.Part(ProgressRead, ProgressEdited), warnings);
  for (int k = 0; this->RefineWhereNeeded && !edited.WrongTriangles.empty() && k < MostRefinements;
       ++k)
  {
    const DirectionFields::GivenField& base = edits->Editor->GetBase();
    surface = DirectionFields::RefinedPolyData(surface, *edits->Surface, base,
      DirectionFields::SurfaceRefinement(
        edits->Surface->Mesh, DirectionFields::TrianglesToSplit(base, edited)));
    refined = DirectionFields::SingularityEditorCache::Make(surface,
      std::make_shared<DirectionFields::TriangulatedPolyData>(
        DirectionFields::PolyDataToSurface(surface)),
      this->KeepConstraints);
    edits = &refined;
    warnings.clear();
    edited = this->EditField(
      surface, *refined.Editor, wanted, progress.Part(ProgressEdited, ProgressEdited), warnings);
  }
  if (!edits->Surface->Mesh.Ghost.empty())
  {
    warnings.emplace_back(
      "The surface is one of several pieces, and singularities of each are edited by themselves: fields do "
      "not fit together at the seams. Edit the whole surface before it is distributed.");
  }
  this->Warn(warnings);
  DirectionFields::CopyWithoutReports(surface, output);
  const DirectionFields::Result field = DirectionFields::ToResult(*edits->Editor, edited);
  DirectionFields::AddEditedField(*edits->Surface, edited, field, warnings, surface, output,
    singularities, progress.Part(ProgressEdited, 1.0));
  const std::string summary = DirectionFields::SummaryOfEdit(
    field, edited, static_cast<DirectionFields::RotationObjective>(this->Objective));
  Summarize(summary, { output, singularities });
}

//------------------------------------------------------------------------------
DirectionFields::EditedField vtkDirectionFieldSingularities::EditField(vtkPolyData* surface,
  DirectionFields::SingularityEditor& editor, const std::vector<WantedSingularity>& wanted,
  const DirectionFields::Progress& progress, std::vector<std::string>& warnings)
{
  DirectionFields::Options options;
  options.Degree = editor.GetBase().GetDegree();
  options.Alignment = static_cast<DirectionFields::Alignment>(this->Alignment);
  options.AlignmentStrength = this->AlignmentStrength;
  const DirectionFields::Guidance guidance = this->Alignment == ALIGN_POINT_VECTORS
    ? DirectionFields::PolyDataToGuidance(surface, this->GuidanceVectors, this->GuidanceWeights)
    : DirectionFields::Guidance();
  editor.SetGuidance(DirectionFields::GuidanceFor(editor, options, guidance, warnings));
  DirectionFields::EditedField edited = editor.Edit(wanted, this->MakeOptions(), progress);
  warnings.insert(warnings.end(), edited.Notes.begin(), edited.Notes.end());
  return edited;
}

//------------------------------------------------------------------------------
void vtkDirectionFieldSingularities::Execute(
  const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress)
{
  this->Last->Begin();
  const vtkSmartPointer<vtkPolyData> list = this->List.empty() ? nullptr : PointsOf(this->List);
  vtkDataObject* const points = list ? list.Get() : inputs[1];
  if (auto* const surface = vtkPolyData::SafeDownCast(inputs[0]))
  {
    DirectionFields::CheckPolyData(surface);
    const std::vector<WantedSingularity> wanted = DirectionFields::WantedSingularities(points);
    this->EditBlock(surface, points ? &wanted : nullptr, progress,
      vtkPolyData::SafeDownCast(outputs[0]), vtkPolyData::SafeDownCast(outputs[1]));
  }
  else
  {
    this->EditBlocks(vtkCompositeDataSet::SafeDownCast(inputs[0]), points, progress,
      vtkCompositeDataSet::SafeDownCast(outputs[0]), vtkCompositeDataSet::SafeDownCast(outputs[1]));
  }
  this->Last->End();
  progress.Report(1.0);
}

//------------------------------------------------------------------------------
void vtkDirectionFieldSingularities::EditBlocks(vtkCompositeDataSet* input, vtkDataObject* points,
  const DirectionFields::Progress& progress, vtkCompositeDataSet* output,
  vtkCompositeDataSet* singularities)
{
  const Blocks blocks = BlocksOf(input);
  for (vtkPolyData* const block : blocks)
  {
    if (block)
    {
      DirectionFields::CheckPolyData(block);
    }
  }
  const std::vector<std::vector<WantedSingularity>> wanted =
    DirectionFields::WantedOfBlocks(blocks, input, points);
  output->CopyStructure(input);
  singularities->CopyStructure(input);
  vtkSmartPointer<vtkCompositeDataIterator> at;
  at.TakeReference(input->NewIterator());
  std::size_t k = 0;
  const double part = 1.0 / static_cast<double>(blocks.empty() ? 1 : blocks.size());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem(), ++k)
  {
    if (!blocks[k])
    {
      continue;
    }
    vtkNew<vtkPolyData> field;
    vtkNew<vtkPolyData> singular;
    const double begin = part * static_cast<double>(k);
    this->EditBlock(blocks[k], points ? &wanted[k] : nullptr, progress.Part(begin, begin + part),
      field, singular);
    output->SetDataSet(at, field);
    singularities->SetDataSet(at, singular);
  }
}

//------------------------------------------------------------------------------
void vtkDirectionFieldSingularities::Release(bool hasFailed)
{
  if (hasFailed || !this->KeepStages)
  {
    // An edit that was stopped leaves its block intact, but a block that was not read to its end is
    // incomplete.
    this->Last->Clear();
  }
}
