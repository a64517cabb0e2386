// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkCompareDirectionFields.h"

#include "Conversion/Input/PolyDataCheck.h"
#include "Conversion/Input/PolyDataToField.h"
#include "Conversion/Input/PolyDataToSurface.h"
#include "Conversion/Output/ComparisonToPolyData.h"
#include "Conversion/Output/FieldToPolyData.h"

#include <DirectionFields/Progress.h>
#include <DirectionFields/Reports/FieldSummary.h>

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <locale>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkCompareDirectionFields);

namespace
{
// Where the phases of the progress end: reading the inputs, comparing the directions. The rest is
// matching.
constexpr double ProgressRead = 0.2;
constexpr double ProgressCompared = 0.5;
/// How far points of the same surface may be apart that two programs have written, relative to its
/// size.
constexpr double SamePlace = 1e-4;

/// Throws std::invalid_argument where two surfaces are not the same.
void RequireSame(const DirectionFields::Surface& one, const DirectionFields::Surface& other)
{
  if (one.Points.size() != other.Points.size() || one.Triangles != other.Triangles)
  {
    throw std::invalid_argument("The two inputs have different points or cells (" +
      std::to_string(one.Points.size()) + " and " + std::to_string(other.Points.size()) +
      " points, " + std::to_string(one.Triangles.size()) + " and " +
      std::to_string(other.Triangles.size()) +
      " triangles). Compare two fields on the same surface.");
  }
  Eigen::AlignedBox3d box;
  double farthest = 0.0;
  for (const DirectionFields::Triangle& triangle : one.Triangles)
  {
    for (const DirectionFields::Index i : triangle)
    {
      box.extend(one.Points[i]);
      farthest = std::max(farthest, (one.Points[i] - other.Points[i]).norm());
    }
  }
  if (farthest > SamePlace * box.diagonal().norm())
  {
    std::ostringstream distance;
    distance.imbue(std::locale::classic());
    distance << farthest;
    throw std::invalid_argument("Points of the two inputs are up to " + distance.str() +
      " apart. Compare two fields on the same surface.");
  }
}
}

//------------------------------------------------------------------------------
vtkCompareDirectionFields::vtkCompareDirectionFields()
  : MatchSingularities(true)
  , DivergenceAndCurl(false)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkCompareDirectionFields::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MatchSingularities: " << this->MatchSingularities << "\n";
  os << indent << "DivergenceAndCurl: " << this->DivergenceAndCurl << "\n";
}

//------------------------------------------------------------------------------
void vtkCompareDirectionFields::SetOtherConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkCompareDirectionFields::SetOtherData(vtkDataObject* field)
{
  this->SetInputData(1, field);
}

//------------------------------------------------------------------------------
int vtkCompareDirectionFields::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkCompareDirectionFields::Compare(vtkPolyData* input, vtkPolyData* other,
  const DirectionFields::Progress& progress, vtkPolyData* output, vtkPolyData* matches)
{
  DirectionFields::CheckPolyData(input);
  DirectionFields::CheckPolyData(other);
  DirectionFields::CopyWithoutReports(input, output);
  if (input->GetNumberOfPoints() == 0 && other->GetNumberOfPoints() == 0)
  {
    return;
  }
  const DirectionFields::PointDirections first = DirectionFields::RequireDirections(input);
  const DirectionFields::PointDirections second = DirectionFields::RequireDirections(other);
  if (first.Degree != second.Degree)
  {
    throw std::invalid_argument("The fields have different degrees, " +
      std::to_string(first.Degree) + " and " + std::to_string(second.Degree) +
      ". Only fields of the same degree can be compared.");
  }
  const DirectionFields::TriangulatedPolyData surface =
    DirectionFields::PolyDataToSurface(input, progress.Part(0.0, 0.5 * ProgressRead));
  RequireSame(surface.Mesh,
    DirectionFields::PolyDataToSurface(other, progress.Part(0.5 * ProgressRead, ProgressRead))
      .Mesh);
  std::optional<DirectionFields::GivenField> one(std::in_place, surface.Mesh, first);
  std::optional<DirectionFields::GivenField> two(std::in_place, surface.Mesh, second);
  if (one->GetMesh().GetNumberOfVertices() != two->GetMesh().GetNumberOfVertices())
  {
    // Points across seams are one for the one field only: they are compared apart, so that the
    // order of the inputs does not matter.
    const auto apart = std::make_shared<const DirectionFields::FieldSurface>(surface.Mesh, false);
    one.emplace(surface.Mesh, apart, first);
    two.emplace(surface.Mesh, apart, second);
  }
  const DirectionFields::GivenField& field = *one;
  const DirectionFields::FieldDifference difference =
    DirectionFields::Compare(field, first, second);
  DirectionFields::AddDifference(difference, output);
  progress.Report(ProgressCompared);
  if (this->DivergenceAndCurl)
  {
    DirectionFields::AddDerivatives(surface, DirectionFields::FieldDerivatives(field), 0, output);
    DirectionFields::AddDerivatives(surface, DirectionFields::FieldDerivatives(*two), 1, output);
  }
  std::vector<DirectionFields::ComparedSingularity> singularities;
  if (this->MatchSingularities)
  {
    singularities =
      DirectionFields::MatchSingularities(field, *two, progress.Part(ProgressCompared, 1.0));
    DirectionFields::AddMatches(surface, singularities, output, matches);
  }
  const std::string summary =
    DirectionFields::Summary(difference, this->MatchSingularities ? &singularities : nullptr);
  Summarize(summary, { output, matches });
}

//------------------------------------------------------------------------------
void vtkCompareDirectionFields::CompareBlocks(vtkCompositeDataSet* input, vtkDataObject* other,
  const DirectionFields::Progress& progress, vtkCompositeDataSet* output,
  vtkCompositeDataSet* matches)
{
  vtkSmartPointer<vtkCompositeDataIterator> at;
  at.TakeReference(input->NewIterator());
  double blocks = 0.0;
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    blocks += 1.0;
  }
  auto* const others = vtkCompositeDataSet::SafeDownCast(other);
  double done = 0.0;
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem(), done += 1.0)
  {
    auto* const block = vtkPolyData::SafeDownCast(at->GetCurrentDataObject());
    auto* const otherBlock = vtkPolyData::SafeDownCast(others ? others->GetDataSet(at) : other);
    if (!block)
    {
      continue;
    }
    if (!otherBlock)
    {
      throw std::invalid_argument(
        "The second input has no surface for a block of the first one. Give two inputs of the same structure, or a "
        "single surface as the second one.");
    }
    vtkNew<vtkPolyData> difference;
    vtkNew<vtkPolyData> blockMatches;
    this->Compare(block, otherBlock, progress.Part(done / blocks, (done + 1.0) / blocks),
      difference, blockMatches);
    output->SetDataSet(at, difference);
    matches->SetDataSet(at, blockMatches);
  }
}

//------------------------------------------------------------------------------
void vtkCompareDirectionFields::Execute(
  const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress)
{
  if (!inputs[1])
  {
    vtkWarningMacro(<< "Choose the field to compare with: it is the second input, Other, in the "
                       "dialog Change Input.");
    outputs[0]->ShallowCopy(inputs[0]);
    DirectionFields::RemoveReports(outputs[0]->GetFieldData());
    Summarize("there is no field to compare with", outputs);
    return;
  }
  if (auto* const composite = vtkCompositeDataSet::SafeDownCast(inputs[0]))
  {
    auto* const differences = vtkCompositeDataSet::SafeDownCast(outputs[0]);
    auto* const matches = vtkCompositeDataSet::SafeDownCast(outputs[1]);
    differences->CopyStructure(composite);
    matches->CopyStructure(composite);
    this->CompareBlocks(composite, inputs[1], progress, differences, matches);
    return;
  }
  auto* const surface = vtkPolyData::SafeDownCast(inputs[1]);
  if (!surface)
  {
    throw std::invalid_argument(
      "The second input is a composite dataset, the first one a single surface. Give the composite one first.");
  }
  this->Compare(vtkPolyData::SafeDownCast(inputs[0]), surface, progress,
    vtkPolyData::SafeDownCast(outputs[0]), vtkPolyData::SafeDownCast(outputs[1]));
}
