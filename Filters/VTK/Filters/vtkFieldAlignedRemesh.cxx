// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkFieldAlignedRemesh.h"

#include "Conversion/Carrying/CarriedCellData.h"
#include "Conversion/Input/PolyDataCheck.h"
#include "Conversion/Input/PolyDataToField.h"
#include "Conversion/Input/PolyDataToGuidance.h"
#include "Conversion/Input/PolyDataToSurface.h"
#include "Conversion/Output/FieldToPolyData.h"
#include "Conversion/Output/RemeshToPolyData.h"
#include "Conversion/Regions/CellRegions.h"
#include "Conversion/Regions/CurveLines.h"
#include "Conversion/Regions/MeshLines.h"
#include "Support/AlgorithmProgress.h"

#include <DirectionFields/Reports/RemeshReports.h>

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkFieldAlignedRemesh);

namespace
{
// Where the phases of the progress end: reading the input, making the mesh.
constexpr double ProgressRead = 0.05;
constexpr double ProgressMade = 0.95;

std::string OrEmpty(const char* name)
{
  return name ? name : "";
}

void RoundToFloats(std::vector<DirectionFields::Vector3>& points)
{
  static_assert(sizeof(DirectionFields::Vector3) == 3 * sizeof(double));
  double* const coordinates = points.empty() ? nullptr : points.data()->data();
  // Of a cast of vectors to float and back at once GCC 12 makes nothing.
  const std::vector<float> rounded(coordinates, coordinates + 3 * points.size());
  std::copy(rounded.begin(), rounded.end(), coordinates);
}
}

/// The surface and the curves that the last mesh was made of, and its mesher, which keeps its
/// stages.
struct vtkFieldAlignedRemesh::Stages
{
  Stages(DirectionFields::TriangulatedPolyData&& surface, const DirectionFields::KeptLines& kept)
    : Surface(std::move(surface))
    , Curves(kept.Curves)
    , Points(kept.Points)
    , Mesher(
        std::make_shared<DirectionFields::Surface>(this->Surface.Mesh), this->Curves, this->Points)
  {
  }
  DirectionFields::TriangulatedPolyData Surface;
  std::vector<std::vector<DirectionFields::Vector3>> Curves;
  std::vector<DirectionFields::Vector3> Points;
  DirectionFields::Remesh Mesher;

  /// The mesh for these options, which is that of before where they are the same.
  /// @param areFloats whether its points are, so that measures of the faces are those of the output
  const DirectionFields::RemeshResult& MakeMesh(const DirectionFields::RemeshOptions& options,
    std::vector<DirectionFields::Vector3>&& directions, bool areFloats,
    const DirectionFields::ProgressFunction& progress)
  {
    const bool isSame = this->Mesh && !this->Mesh->Aborted &&
      DirectionFields::AreSame(this->Options, options) && this->Directions == directions &&
      this->AreFloats == areFloats;
    if (!isSame)
    {
      // The old one is given up first: there is no memory for both.
      this->Mesh.reset();
      this->Mesh = std::make_unique<DirectionFields::RemeshResult>(
        this->Mesher.Compute(options, directions, progress));
      this->Options = options;
      this->Directions = std::move(directions);
      this->AreFloats = areFloats;
      if (areFloats)
      {
        RoundToFloats(this->Mesh->Points);
      }
    }
    return *this->Mesh;
  }

private:
  std::unique_ptr<DirectionFields::RemeshResult> Mesh;
  DirectionFields::RemeshOptions Options;
  std::vector<DirectionFields::Vector3> Directions;
  bool AreFloats = false;
};

//------------------------------------------------------------------------------
vtkFieldAlignedRemesh::vtkFieldAlignedRemesh()
{
  const DirectionFields::RemeshOptions defaults;
  this->Element = static_cast<int>(defaults.Element);
  this->SizeMode = defaults.UseEdgeLength ? EDGE_LENGTH : FACES;
  this->NumberOfFaces = defaults.NumberOfFaces;
  this->EdgeLength = defaults.EdgeLength;
  this->SizingArray = nullptr;
  this->SizeSource = static_cast<int>(defaults.SizeSource);
  this->MaximumError = defaults.MaximumError;
  this->Gradation = defaults.Gradation;
  this->AddIrregularPairs = defaults.AddIrregularPairs;
  this->RegionArray = nullptr;
  this->ConservedArray = nullptr;
  this->PureQuads = defaults.PureQuads;
  this->BoundarySpacing = static_cast<int>(defaults.BoundarySpacing);
  this->KeepThinParts = defaults.KeepThinParts;
  this->KeepFeatures = defaults.KeepFeatures;
  this->KeepSoftFeatures = defaults.KeepSoftFeatures;
  this->FeatureAngle = defaults.FeatureAngle;
  this->Alignment = static_cast<int>(defaults.Alignment);
  this->AlignmentStrength = defaults.AlignmentStrength;
  this->SingularityCost = defaults.SingularityCost;
  this->SmoothingIterations = defaults.SmoothingIterations;
  const DirectionFields::QualityLimits limits;
  this->MinimumScaledJacobian = limits.MinimumScaledJacobian;
  this->MaximumAspectRatio = limits.MaximumAspectRatio;
  this->MaximumWarpage = limits.MaximumWarpage;
  this->KeepStages = true;
  this->NumberOfThreads = defaults.NumberOfThreads;
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
vtkFieldAlignedRemesh::~vtkFieldAlignedRemesh()
{
  this->SetSizingArray(nullptr);
  this->SetRegionArray(nullptr);
  this->SetConservedArray(nullptr);
}

//------------------------------------------------------------------------------
void vtkFieldAlignedRemesh::SetCurvesConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkFieldAlignedRemesh::SetCurvesData(vtkDataObject* curves)
{
  this->SetInputData(1, curves);
}

//------------------------------------------------------------------------------
int vtkFieldAlignedRemesh::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkFieldAlignedRemesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Element: " << this->Element << "\n";
  os << indent << "SizeMode: " << this->SizeMode << "\n";
  os << indent << "NumberOfFaces: " << this->NumberOfFaces << "\n";
  os << indent << "EdgeLength: " << this->EdgeLength << "\n";
  os << indent << "SizingArray: " << (this->SizingArray ? this->SizingArray : "(none)") << "\n";
  os << indent << "SizeSource: " << this->SizeSource << "\n";
  os << indent << "MaximumError: " << this->MaximumError << "\n";
  os << indent << "Gradation: " << this->Gradation << "\n";
  os << indent << "AddIrregularPairs: " << this->AddIrregularPairs << "\n";
  os << indent << "RegionArray: " << (this->RegionArray ? this->RegionArray : "(none)") << "\n";
  os << indent << "ConservedArray: " << (this->ConservedArray ? this->ConservedArray : "(none)")
     << "\n";
  os << indent << "PureQuads: " << this->PureQuads << "\n";
  os << indent << "BoundarySpacing: " << this->BoundarySpacing << "\n";
  os << indent << "KeepThinParts: " << this->KeepThinParts << "\n";
  os << indent << "KeepFeatures: " << this->KeepFeatures << "\n";
  os << indent << "KeepSoftFeatures: " << this->KeepSoftFeatures << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "Alignment: " << this->Alignment << "\n";
  os << indent << "AlignmentStrength: " << this->AlignmentStrength << "\n";
  os << indent << "SingularityCost: " << this->SingularityCost << "\n";
  os << indent << "SmoothingIterations: " << this->SmoothingIterations << "\n";
  os << indent << "MinimumScaledJacobian: " << this->MinimumScaledJacobian << "\n";
  os << indent << "MaximumAspectRatio: " << this->MaximumAspectRatio << "\n";
  os << indent << "MaximumWarpage: " << this->MaximumWarpage << "\n";
  os << indent << "KeepStages: " << this->KeepStages << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}

//------------------------------------------------------------------------------
DirectionFields::RemeshOptions vtkFieldAlignedRemesh::MakeOptions(
  vtkPolyData* input, const DirectionFields::TriangulatedPolyData& surface) const
{
  DirectionFields::RemeshOptions options;
  options.Element = static_cast<DirectionFields::Element>(this->Element);
  options.UseEdgeLength = this->SizeMode == EDGE_LENGTH;
  options.NumberOfFaces = this->NumberOfFaces;
  options.EdgeLength = this->EdgeLength;
  if (this->SizeSource != CURVATURE)
  {
    options.Sizing = DirectionFields::PointValues(input, this->SizingArray, "Sizing Array");
  }
  options.SizeSource = static_cast<DirectionFields::SizeSource>(this->SizeSource);
  options.MaximumError = this->MaximumError;
  options.SizingIsLength = this->SizeMode == LENGTHS_AT_POINTS;
  options.Gradation = this->Gradation;
  options.AddIrregularPairs = this->AddIrregularPairs;
  DirectionFields::CellRegions regions = DirectionFields::FindRegions(input,
    { surface.Mesh.Triangles.size(), [&](std::size_t t) { return surface.Cell(t); } },
    this->RegionArray);
  options.Regions = std::move(regions.OfFaces);
  options.RegionNames = std::move(regions.Names);
  options.PureQuads = this->PureQuads;
  options.BoundarySpacing = static_cast<DirectionFields::BoundarySpacing>(this->BoundarySpacing);
  options.KeepThinParts = this->KeepThinParts;
  options.KeepFeatures = this->KeepFeatures;
  options.KeepSoftFeatures = this->KeepSoftFeatures;
  options.FeatureAngle = this->FeatureAngle;
  options.Alignment = static_cast<DirectionFields::FieldAlignment>(this->Alignment);
  options.AlignmentStrength = this->AlignmentStrength;
  options.SingularityCost = this->SingularityCost;
  options.SmoothingIterations = this->SmoothingIterations;
  options.NumberOfThreads = this->NumberOfThreads;
  return options;
}

//------------------------------------------------------------------------------
void vtkFieldAlignedRemesh::Execute(
  const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress)
{
  auto* const input = vtkPolyData::SafeDownCast(inputs[0]);
  auto* const output = vtkPolyData::SafeDownCast(outputs[0]);
  DirectionFields::CheckPolyData(input);
  const DirectionFields::KeptLines kept = DirectionFields::LinesOf(inputs[1]);
  if (!this->Last || !DirectionFields::IsSurfaceOf(input, this->Last->Surface) ||
    this->Last->Curves != kept.Curves || this->Last->Points != kept.Points)
  {
    this->Last.reset();
    this->Last = std::make_unique<Stages>(
      DirectionFields::PolyDataToSurface(input, progress.Part(0.0, ProgressRead)), kept);
  }
  const DirectionFields::RemeshOptions options = this->MakeOptions(input, this->Last->Surface);
  const int pointType = input->GetPoints() ? input->GetPoints()->GetDataType() : VTK_FLOAT;
  const int degree = this->Element == QUADS ? 4 : 6;
  const DirectionFields::PointDirections field = DirectionFields::FindDirections(input);
  std::vector<DirectionFields::Vector3> directions;
  std::vector<std::string> warnings;
  if (field.Degree == degree)
  {
    for (vtkIdType p = 0; p < input->GetNumberOfPoints(); ++p)
    {
      directions.push_back(field.Direction(static_cast<DirectionFields::Index>(p), 0));
    }
  }
  else if (field.Degree > 0)
  {
    warnings.push_back("The direction field of the input has degree " +
      std::to_string(field.Degree) + ", but the mesh follows one of degree " +
      std::to_string(degree) +
      ", which was computed. Set Directions Per Point (Degree) of Direction " + "Field to " +
      std::to_string(degree) + " for the mesh to follow that.");
  }
  if (kept.HasFaces && kept.Curves.empty() && kept.Points.empty())
  {
    warnings.push_back("Kept Curves has faces alone, no lines or vertices: nothing of it is kept. "
                       "Feature Edges or Slice make lines of it.");
  }
  const DirectionFields::CellDataRules rules{ options.Regions, OrEmpty(this->RegionArray),
    OrEmpty(this->ConservedArray) };
  DirectionFields::CheckConserved(input, rules);
  const DirectionFields::ProgressFunction report =
    DirectionFields::ReportTo(this, ProgressRead, ProgressMade);
  const DirectionFields::RemeshResult& mesh =
    this->Last->MakeMesh(options, std::move(directions), pointType != VTK_DOUBLE,
      [&](double done)
      {
        this->SetProgressText(DirectionFields::Remesh::StepAt(done));
        return report(done);
      });
  this->SetProgressText(nullptr);
  this->ThrowIfStopped(mesh.Aborted);
  warnings.insert(warnings.end(), mesh.Notes.begin(), mesh.Notes.end());
  const DirectionFields::FaceQuality quality = DirectionFields::QualityOf(mesh.Points, mesh.Faces);
  const DirectionFields::QualityReport judged = DirectionFields::ReportQuality(
    quality, { this->MinimumScaledJacobian, this->MaximumAspectRatio, this->MaximumWarpage });
  warnings.insert(warnings.end(), judged.Sentences.begin(), judged.Sentences.end());
  DirectionFields::AddMesh(input, this->Last->Surface, mesh, output);
  const std::vector<std::string> aboutData =
    DirectionFields::CarryCellData(input, this->Last->Surface, mesh, rules, output->GetCellData());
  warnings.insert(warnings.end(), aboutData.begin(), aboutData.end());
  this->Warn(warnings);
  DirectionFields::AddQuality(quality, judged, output);
  DirectionFields::AddReport(mesh.Repaired, warnings, output->GetFieldData());
  DirectionFields::AddIrregularVertices(
    mesh, degree, pointType, vtkPolyData::SafeDownCast(outputs[1]));
  DirectionFields::KeepChains(mesh.Chains, output->GetFieldData());
  DirectionFields::KeepRegionArray(
    mesh.Regions.empty() ? std::string() : rules.RegionArray, output->GetFieldData());
  if (!kept.Points.empty())
  {
    DirectionFields::AddGivenPoints(mesh.Chains, output);
  }
  DirectionFields::AddChains(mesh.Chains, output->GetPoints(), options.RegionNames, kept,
    vtkPolyData::SafeDownCast(outputs[2]));
  const std::string summary = DirectionFields::Summary(mesh, judged);
  Summarize(summary, outputs);
}

//------------------------------------------------------------------------------
void vtkFieldAlignedRemesh::Release(bool)
{
  if (!this->KeepStages)
  {
    this->Last.reset();
  }
}

//------------------------------------------------------------------------------
const char* vtkFieldAlignedRemesh::MemoryAdvice() const
{
  return "Lower Number Of Faces or decimate the surface";
}

//------------------------------------------------------------------------------
int vtkFieldAlignedRemesh::ThreadsToUse() const
{
  return this->NumberOfThreads > 0 ? this->NumberOfThreads : this->Superclass::ThreadsToUse();
}
