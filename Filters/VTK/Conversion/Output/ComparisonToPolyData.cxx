// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Output/ComparisonToPolyData.h"

#include "Conversion/Input/FieldArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>

namespace DirectionFields
{
namespace
{
void AddNumber(const char* name, double number, vtkFieldData* data)
{
  auto array = MakeArray<vtkDoubleArray>(name, 1, 1);
  array->SetValue(0, number);
  data->AddArray(array);
}

/// Values over triangles as an array over cells.
vtkNew<vtkDoubleArray> OverCells(const TriangulatedPolyData& surface,
  const std::vector<double>& values, const std::string& name, vtkIdType cells)
{
  auto array = MakeArray<vtkDoubleArray>(name.c_str(), 1, static_cast<std::size_t>(cells));
  array->FillValue(0.0);
  std::vector<int> triangles(static_cast<std::size_t>(cells), 0);
  for (std::size_t t = 0; t < values.size(); ++t)
  {
    const vtkIdType cell = surface.Cell(t);
    array->SetValue(cell, array->GetValue(cell) + values[t]);
    ++triangles[static_cast<std::size_t>(cell)];
  }
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    array->SetValue(
      cell, array->GetValue(cell) / std::max(1, triangles[static_cast<std::size_t>(cell)]));
  }
  return array;
}
}

void AddDifference(const FieldDifference& difference, vtkPolyData* output)
{
  output->GetPointData()->SetScalars(
    MakeScalars<vtkDoubleArray>("AngleDifference", difference.Angle));
  AddNumber("MeanAngleDifference", difference.Mean, output->GetFieldData());
  AddNumber("MaximumAngleDifference", difference.Maximum, output->GetFieldData());
}

void AddDerivatives(const TriangulatedPolyData& surface, const FieldDerivatives& derivatives,
  int number, vtkPolyData* output)
{
  const std::string end = std::to_string(number);
  const vtkIdType cells = output->GetNumberOfCells();
  vtkCellData* data = output->GetCellData();
  data->AddArray(OverCells(surface, derivatives.Divergence, "Divergence" + end, cells));
  data->AddArray(OverCells(surface, derivatives.Curl, "Curl" + end, cells));
}

void AddMatches(const TriangulatedPolyData& surface,
  const std::vector<ComparedSingularity>& singularities, vtkPolyData* output, vtkPolyData* matches)
{
  const std::size_t size = singularities.size();
  vtkNew<vtkPoints> points;
  points->SetDataType(output->GetPoints() && output->GetPoints()->GetDataType() == VTK_DOUBLE
      ? VTK_DOUBLE
      : VTK_FLOAT);
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkCellArray> lines;
  auto field = MakeArray<vtkIntArray>("Field", 1, size);
  auto index = MakeArray<vtkIntArray>(ArrayNames::SingularityIndex, 1, size);
  auto match = MakeArray<vtkIdTypeArray>("Match", 1, size);
  auto distance = MakeArray<vtkDoubleArray>("MatchDistance", 1, size);
  auto cell = MakeArray<vtkIdTypeArray>("CellId", 1, size);
  RequireMemoryToGrow((sizeof(double[3]) + 5 * sizeof(vtkIdType)) * size);
  int matched = 0;
  int alone[2] = { 0, 0 };
  double sum = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < size; ++i)
  {
    const ComparedSingularity& at = singularities[i];
    const auto id = points->InsertNextPoint(at.Position.data());
    verts->InsertNextCell(1, &id);
    field->SetValue(id, at.Field);
    index->SetValue(id, at.SingularityIndex);
    match->SetValue(id, at.Match);
    distance->SetValue(id, at.Distance);
    cell->SetValue(id, surface.Cell(static_cast<std::size_t>(at.Triangle)));
    if (at.Match == None)
    {
      ++alone[at.Field];
    }
    else if (at.Field == 0)
    {
      ++matched;
      sum += at.Distance;
      largest = std::max(largest, at.Distance);
      const vtkIdType ends[2] = { id, at.Match };
      lines->InsertNextCell(2, ends);
    }
  }
  matches->SetPoints(points);
  matches->SetVerts(verts);
  matches->SetLines(lines);
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{
         field.Get(), index.Get(), match.Get(), distance.Get(), cell.Get() })
  {
    matches->GetPointData()->AddArray(array);
  }
  auto counts = MakeArray<vtkIntArray>("MatchedSingularities", 3, 1);
  counts->SetComponentName(0, "Matched");
  counts->SetComponentName(1, "OnlyInFirst");
  counts->SetComponentName(2, "OnlyInSecond");
  counts->SetTypedComponent(0, 0, matched);
  counts->SetTypedComponent(0, 1, alone[0]);
  counts->SetTypedComponent(0, 2, alone[1]);
  output->GetFieldData()->AddArray(counts);
  AddNumber("MeanMatchDistance", matched > 0 ? sum / matched : 0.0, output->GetFieldData());
  AddNumber("MaximumMatchDistance", largest, output->GetFieldData());
}
}
