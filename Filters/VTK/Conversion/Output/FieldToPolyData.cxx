// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Output/FieldToPolyData.h"

#include "Conversion/Input/FieldArrays.h"
#include "Conversion/Input/SplitPolyData.h"
#include "Conversion/Tensors/TensorArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace DirectionFields
{
namespace
{
/// The largest degree, hence the most directions that an earlier run can have left.
constexpr int MostDirections = 16;
/// Points whose directions stay in the cache.
constexpr Index FewPoints = 256;
/// The field data of all filters that are figures of the computation.
constexpr const char* ReportNames[] = { "Eigenvalue", "Residual", "Iterations", "SolverUsed",
  "EulerCharacteristic", "IndexSum", "Lambda", "SmoothnessEnergy", "SystemResidual", "UnitEnergy",
  "CancelledPairs", "UnitSteps", ArrayNames::Repairs, "Distribution", "RotationEnergy",
  "MaximumRotation", "WrongTriangles", "TurningNumbers", "SeparatingDistance", "Spacing",
  "LineOffset", "Misfit", "BranchPoints", "NumberOfGlyphs", "Faces", "Quads", "Triangles",
  "IrregularVertices", "KeptVertices", "FlippedTriangles", "TurnedFaces", "EdgeLength",
  "MaximumDistance", "MaximumDistanceToMesh", "Regions", "RegionsLost", "BordersKept",
  "CornersMissed", "LargestAreaError", "LeastScaledJacobian", "MeanScaledJacobian",
  "LargestAspectRatio", "LargestWarpage", "FailedFaces", "Pass", "EdgesAsWanted", "ErrorOfSizes",
  "BoundaryPoints", "BoundaryPointsKept", "BoundaryUnevenness", "MeanAngleDifference",
  "MaximumAngleDifference", "MatchedSingularities", "MeanMatchDistance", "MaximumMatchDistance" };

/// Adds an array of vectors over the points; where there are none, removes one that an earlier run
/// left in the input.
template <typename ArrayT>
void AddVectors(const char* name, const std::vector<Vector3>& vectors, vtkPointData* data)
{
  data->RemoveArray(name);
  if (!vectors.empty())
  {
    data->AddArray(MakeVectors<ArrayT>(name, vectors));
  }
}

/// The same for numbers.
template <typename ArrayT, typename Value>
void AddScalars(const char* name, const std::vector<Value>& values, vtkPointData* data)
{
  data->RemoveArray(name);
  if (!values.empty())
  {
    data->AddArray(MakeScalars<ArrayT>(name, values));
  }
}

template <typename ArrayT>
void AddCurvature(const CurvatureReport& curvature, vtkPointData* data)
{
  AddVectors<ArrayT>(ArrayNames::PrincipalDirection0, curvature.PrincipalDirection0, data);
  AddVectors<ArrayT>(ArrayNames::PrincipalDirection1, curvature.PrincipalDirection1, data);
  AddScalars<ArrayT>(ArrayNames::MeanCurvature, curvature.Mean, data);
  AddScalars<ArrayT>(ArrayNames::GaussianCurvature, curvature.Gaussian, data);
}

/// Writes the directions and the moduli of u at all points.
/// @param directions for each k the tuples of the k-th directions
template <typename Value>
void WriteDirections(const Result& field, const std::vector<Value*>& directions, Value* moduli)
{
  ForEachPieceOfTuples(field.Representation.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Vector3> vectors(FewPoints * directions.size());
      const auto pieceEnd = static_cast<Index>(end);
      for (auto first = static_cast<Index>(begin); first < pieceEnd; first += FewPoints)
      {
        const Index last = std::min(pieceEnd, first + FewPoints);
        field.Directions(first, last, vectors.data());
        const Vector3* vector = vectors.data();
        for (Index i = first; i < last; ++i)
        {
          moduli[i] = static_cast<Value>(std::sqrt(std::norm(field.Representation[i])));
          for (Value* const tuples : directions)
          {
            WriteVector(*vector++, tuples, i);
          }
        }
      }
    });
}

/// Adds the field's point data. Throws Stopped.
template <typename ArrayT>
void AddPointArrays(const Result& field, vtkPointData* data, const Progress& progress)
{
  using Value = typename ArrayT::ValueType;
  const std::size_t points = field.Representation.size();
  auto magnitude = MakeArray<ArrayT>(ArrayNames::RepresentationMagnitude, 1, points);
  data->AddArray(magnitude);
  AddScalars<ArrayT>(ArrayNames::EnergyDensity, field.EnergyDensity, data);
  AddVectors<ArrayT>(ArrayNames::ConstraintDirection, field.ConstraintDirection, data);
  const CurvatureReport none;
  AddCurvature<ArrayT>(field.Curvature ? *field.Curvature : none, data);
  std::vector<Value*> directions;
  for (int k = 0; k < field.Degree; ++k)
  {
    auto array = MakeArray<ArrayT>(ArrayNames::Direction(k).c_str(), 3, points);
    directions.push_back(array->GetPointer(0));
    data->AddArray(array);
  }
  progress.Report(0.5);
  WriteDirections(field, directions, magnitude->GetPointer(0));
  // Arrays that an earlier run of higher degree left in the input are no part of this field.
  for (int k = field.Degree; k < MostDirections; ++k)
  {
    data->RemoveArray(ArrayNames::Direction(k).c_str());
  }
  data->SetActiveVectors(ArrayNames::Direction(0).c_str());
}

/// Sets the field's arrays to zero at some points.
void ClearField(const std::vector<vtkIdType>& points, int degree, vtkPointData* data)
{
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* array = data->GetArray(k);
    if (!array || !ArrayNames::IsOfTheField(array->GetName(), degree))
    {
      continue;
    }
    for (const vtkIdType point : points)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        array->SetComponent(point, c, 0.0);
      }
    }
  }
}

void AddCellArrays(const TriangulatedPolyData& input, const Result& field, vtkPolyData* output)
{
  auto index = MakeArray<vtkIntArray>(
    ArrayNames::SingularityIndex, 1, static_cast<std::size_t>(output->GetNumberOfCells()));
  int* const indices = index->GetPointer(0);
  const std::vector<int>& given = field.SingularityIndex;
  if (input.CellOfTriangle.empty() && input.FirstCell == 0 &&
    given.size() == static_cast<std::size_t>(output->GetNumberOfCells()))
  {
    ForEachPieceOfTuples(given.size(),
      [&](std::size_t begin, std::size_t end)
      { std::copy(given.data() + begin, given.data() + end, indices + begin); });
  }
  else
  {
    index->FillValue(0);
    for (std::size_t t = 0; t < given.size(); ++t)
    {
      indices[input.Cell(t)] += given[t];
    }
  }
  output->GetCellData()->AddArray(index);
}

template <typename ArrayT, typename Member>
void AddComponentArray(
  const char* name, const Result& field, Member ComponentReport::*member, vtkFieldData* data)
{
  auto array = MakeArray<ArrayT>(name, 1, field.Components.size());
  for (std::size_t c = 0; c < field.Components.size(); ++c)
  {
    array->SetValue(static_cast<vtkIdType>(c),
      static_cast<typename ArrayT::ValueType>(field.Components[c].*member));
  }
  data->AddArray(array);
}

/// Adds the figures of fields of unit length; removes an earlier filter's where there are none.
void AddUnitArrays(const Result& field, vtkFieldData* data)
{
  if (!field.UnitLength)
  {
    for (const char* name : { "UnitEnergy", "CancelledPairs", "UnitSteps" })
    {
      data->RemoveArray(name);
    }
    return;
  }
  auto energy = MakeArray<vtkDoubleArray>("UnitEnergy", 2, field.Components.size());
  energy->SetComponentName(0, "Before");
  energy->SetComponentName(1, "After");
  for (std::size_t c = 0; c < field.Components.size(); ++c)
  {
    energy->SetTuple2(static_cast<vtkIdType>(c), field.Components[c].UnitEnergyBefore,
      field.Components[c].UnitEnergyAfter);
  }
  data->AddArray(energy);
  AddComponentArray<vtkIntArray>("CancelledPairs", field, &ComponentReport::CancelledPairs, data);
  AddComponentArray<vtkIntArray>("UnitSteps", field, &ComponentReport::UnitSteps, data);
}

/// Adds an array of one text a tuple.
void AddTexts(const char* name, const std::vector<std::string>& texts, vtkFieldData* data)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& text : texts)
  {
    array->InsertNextValue(text);
  }
  data->AddArray(array);
}

/// Adds the figures of how the components' fields were computed.
void AddComponentArrays(const Result& field, vtkFieldData* data)
{
  AddComponentArray<vtkDoubleArray>("Eigenvalue", field, &ComponentReport::Eigenvalue, data);
  AddComponentArray<vtkDoubleArray>("Residual", field, &ComponentReport::Residual, data);
  AddComponentArray<vtkIntArray>("Iterations", field, &ComponentReport::Iterations, data);
  AddComponentArray<vtkIntArray>("SolverUsed", field, &ComponentReport::SolverUsed, data);
  AddComponentArray<vtkDoubleArray>("Lambda", field, &ComponentReport::Lambda, data);
  AddComponentArray<vtkDoubleArray>(
    "SmoothnessEnergy", field, &ComponentReport::SmoothnessEnergy, data);
  AddComponentArray<vtkDoubleArray>(
    "SystemResidual", field, &ComponentReport::SystemResidual, data);
  AddUnitArrays(field, data);
}

/// Adds the arrays of the field itself.
void AddFieldOfType(const TriangulatedPolyData& input, const Result& field, int type,
  vtkPolyData* output, const Progress& progress)
{
  output->GetPointData()->RemoveArray(ArrayNames::OriginalPointIds);
  const std::vector<vtkIdType> unused = SplitPolyData(input, field, output);
  vtkPointData* data = output->GetPointData();
  AddScalars<vtkIntArray>(ArrayNames::ConstraintKind, field.Constraint, data);
  if (type == VTK_DOUBLE)
  {
    AddPointArrays<vtkDoubleArray>(field, data, progress);
  }
  else
  {
    AddPointArrays<vtkFloatArray>(field, data, progress);
  }
  // Where a cell was torn apart, some of its points are in no cell: they show no direction.
  ClearField(unused, field.Degree, data);
  AddCellArrays(input, field, output);
  // An earlier filter's reports about its field do not hold for this one.
  for (int k = 0; k < MostDirections; ++k)
  {
    output->GetCellData()->RemoveArray(ArrayNames::Direction(k).c_str());
  }
  data->RemoveArray(ArrayNames::FaceSingularityIndex);
  for (const char* name : { "Eigenvalue", "Residual", "Iterations", "SolverUsed", "Lambda",
         "SmoothnessEnergy", "SystemResidual", "UnitEnergy", "CancelledPairs", "UnitSteps" })
  {
    output->GetFieldData()->RemoveArray(name);
  }
  AddComponentArray<vtkIntArray>(
    "EulerCharacteristic", field, &ComponentReport::EulerCharacteristic, output->GetFieldData());
  AddComponentArray<vtkIntArray>(
    "IndexSum", field, &ComponentReport::IndexSum, output->GetFieldData());
}
}

void AddGivenField(const TriangulatedPolyData& input, const Result& field, vtkPolyData* output,
  const Progress& progress)
{
  AddFieldOfType(input, field, output->GetPoints() ? output->GetPoints()->GetDataType() : VTK_FLOAT,
    output, progress);
}

void AddFieldArrays(const TriangulatedPolyData& input, const Result& field, int type,
  vtkPolyData* output, const Progress& progress)
{
  RemoveTensorArrays(output->GetPointData());
  AddFieldOfType(input, field, type, output, progress);
  AddComponentArrays(field, output->GetFieldData());
}

void RemoveFieldArrays(vtkPolyData* output)
{
  for (int k = 0; k < MostDirections; ++k)
  {
    output->GetPointData()->RemoveArray(ArrayNames::Direction(k).c_str());
    output->GetCellData()->RemoveArray(ArrayNames::Direction(k).c_str());
  }
  for (const char* name :
    { ArrayNames::RepresentationMagnitude, ArrayNames::EnergyDensity, ArrayNames::ConstraintKind,
      ArrayNames::ConstraintDirection, ArrayNames::PrincipalDirection0,
      ArrayNames::PrincipalDirection1, ArrayNames::MeanCurvature, ArrayNames::GaussianCurvature,
      ArrayNames::OriginalPointIds, ArrayNames::FaceSingularityIndex })
  {
    output->GetPointData()->RemoveArray(name);
  }
  RemoveTensorArrays(output->GetPointData());
  output->GetCellData()->RemoveArray(ArrayNames::SingularityIndex);
  for (const char* name :
    { "Eigenvalue", "Residual", "Iterations", "SolverUsed", "EulerCharacteristic", "IndexSum",
      "Lambda", "SmoothnessEnergy", "SystemResidual", "UnitEnergy", "CancelledPairs", "UnitSteps",
      ArrayNames::Repairs, ArrayNames::Warnings, ArrayNames::Summary, "Distribution" })
  {
    output->GetFieldData()->RemoveArray(name);
  }
}

void AddReport(
  const Repairs& repaired, const std::vector<std::string>& warnings, vtkFieldData* data)
{
  const std::pair<const char*, Index> counts[] = {
    { "CollapsedTriangles", repaired.CollapsedTriangles },
    { "DuplicateTriangles", repaired.DuplicateTriangles },
    { "ReversedTriangles", repaired.ReversedTriangles },
    { "DegenerateTriangles", repaired.DegenerateTriangles },
    { "NonManifoldEdges", repaired.NonManifoldEdges },
    { "NonManifoldPoints", repaired.NonManifoldPoints },
    { "NonOrientableComponents", repaired.NonOrientableComponents },
    { "MergedPoints", repaired.MergedPoints },
  };
  auto repairs =
    MakeArray<vtkIntArray>(ArrayNames::Repairs, static_cast<int>(std::size(counts)), 1);
  for (std::size_t k = 0; k < std::size(counts); ++k)
  {
    repairs->SetComponentName(static_cast<vtkIdType>(k), counts[k].first);
    repairs->SetTypedComponent(0, static_cast<int>(k), counts[k].second);
  }
  data->AddArray(repairs);

  data->RemoveArray(ArrayNames::Warnings);
  if (!warnings.empty())
  {
    AddTexts(ArrayNames::Warnings, warnings, data);
  }
}

void AddSummary(const std::string& summary, vtkFieldData* data)
{
  AddTexts(ArrayNames::Summary, { summary }, data);
}

void RemoveReports(vtkFieldData* data)
{
  if (data && data->HasArray(ArrayNames::Summary))
  {
    for (const char* const name : ReportNames)
    {
      data->RemoveArray(name);
    }
    data->RemoveArray(ArrayNames::Warnings);
    data->RemoveArray(ArrayNames::GuidedElsewhere);
    data->RemoveArray(ArrayNames::Summary);
  }
}

void RemoveDiagnostics(vtkFieldData* input, vtkFieldData* output)
{
  for (const char* const name : ReportNames)
  {
    vtkAbstractArray* const array = output->GetAbstractArray(name);
    if (array && (!input || input->GetAbstractArray(name) != array))
    {
      output->RemoveArray(name);
    }
  }
}

void CopyWithoutReports(vtkPolyData* input, vtkPolyData* output)
{
  output->ShallowCopy(input);
  RemoveReports(output->GetFieldData());
}
}
