// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The remesher in a pipeline: parameters, data carried over, fields, errors, unusual input, abort.

#include "Checks.h"
#include "Meshes/PolyData.h"
#include "Meshes/Surfaces.h"

#include "vtkAbstractArray.h"
#include "vtkCell.h"
#include "vtkDirectionField.h"
#include "vtkFieldAlignedRemesh.h"
#include "vtkStringArray.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkLongLongArray.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace Checks;

namespace
{
double Number(vtkPolyData* mesh, const char* name)
{
  vtkDataArray* array = mesh->GetFieldData()->GetArray(name);
  return array ? array->GetTuple1(0) : std::nan("");
}

void TestParameters()
{
  vtkNew<vtkFieldAlignedRemesh> filter;
  CHECK(filter->GetElement() == vtkFieldAlignedRemesh::QUADS);
  CHECK(filter->GetNumberOfFaces() == 5000);
  CHECK(filter->GetNumberOfOutputPorts() == 3);
  filter->SetElement(7);
  CHECK(filter->GetElement() == vtkFieldAlignedRemesh::TRIANGLES);
  filter->SetSizeMode(1);
  filter->SetNumberOfFaces(0);
  CHECK(filter->GetNumberOfFaces() == 1);
  filter->SetEdgeLength(0.25);
  filter->SetSizingArray("Size");
  filter->SetRegionArray("Material");
  filter->SetConservedArray("Load");
  filter->SetGradation(1.25);
  filter->AddIrregularPairsOff();
  filter->PureQuadsOn();
  filter->SetBoundarySpacing(7);
  filter->SetSizeSource(1);
  filter->SetMaximumError(0.5);
  filter->KeepThinPartsOff();
  filter->KeepFeaturesOff();
  filter->KeepSoftFeaturesOff();
  filter->SetFeatureAngle(200.0);
  CHECK(filter->GetAlignment() == vtkFieldAlignedRemesh::SHAPE);
  filter->SetAlignment(5);
  filter->SetAlignmentStrength(2.0);
  filter->SetSingularityCost(5.0);
  filter->SetSmoothingIterations(3);
  filter->KeepStagesOff();
  filter->SetNumberOfThreads(2);
  std::ostringstream text;
  filter->Print(text);
  for (const char* line : { "Element: 1\n", "SizeMode: 1\n", "NumberOfFaces: 1\n",
         "EdgeLength: 0.25\n", "SizingArray: Size\n", "RegionArray: Material\n",
         "ConservedArray: Load\n", "Gradation: 1.25\n", "AddIrregularPairs: 0\n", "PureQuads: 1\n",
         "BoundarySpacing: 2\n", "SizeSource: 1\n", "MaximumError: 0.5\n", "KeepThinParts: 0\n",
         "KeepFeatures: 0\n", "KeepSoftFeatures: 0\n", "FeatureAngle: 180\n", "Alignment: 1\n",
         "AlignmentStrength: 1\n", "SingularityCost: 4\n", "SmoothingIterations: 3\n",
         "KeepStages: 0\n", "NumberOfThreads: 2\n" })
  {
    CHECK(text.str().find(line) != std::string::npos);
  }
}

/// Linear data stay the same where the surface is flat, and cells keep those of the cell below.
void TestDataIsCarriedOver()
{
  vtkSmartPointer<vtkPolyData> square = Meshes::ToPolyData(Meshes::Square(8));
  vtkNew<vtkDoubleArray> x;
  x->SetName("X");
  for (vtkIdType i = 0; i < square->GetNumberOfPoints(); ++i)
  {
    x->InsertNextValue(square->GetPoint(i)[0]);
  }
  square->GetPointData()->AddArray(x);
  vtkNew<vtkIntArray> cell;
  cell->SetName("Cell");
  for (vtkIdType i = 0; i < square->GetNumberOfCells(); ++i)
  {
    cell->InsertNextValue(static_cast<int>(i));
  }
  square->GetCellData()->AddArray(cell);

  vtkNew<vtkFieldAlignedRemesh> filter;
  filter->SetInputData(square);
  filter->SetNumberOfFaces(144);
  filter->Update();
  vtkPolyData* mesh = filter->GetOutput();
  CHECK(mesh->GetNumberOfCells() == 144);
  CHECK(Number(mesh, "Quads") == 144.0);
  CHECK(filter->GetOutput(1)->GetNumberOfPoints() == 0);
  vtkDataArray* carried = mesh->GetPointData()->GetArray("X");
  CHECK(carried != nullptr);
  for (vtkIdType i = 0; carried && i < mesh->GetNumberOfPoints(); ++i)
  {
    CHECK(std::abs(carried->GetTuple1(i) - mesh->GetPoint(i)[0]) < 1e-9);
  }
  CHECK(mesh->GetCellData()->GetArray("Cell") != nullptr);
  CHECK(mesh->GetCellData()->GetArray("Regular")->GetRange()[0] == 1.0);
  CHECK(mesh->GetPointData()->GetArray("VertexKind")->GetRange()[1] == 3.0);
}

/// Regions of integers, whole numbers and strings have the same borders, faces have their values,
/// and what divides no surface is refused.
void TestRegions()
{
  constexpr int cells = 10;
  vtkSmartPointer<vtkPolyData> square = Meshes::ToPolyData(Meshes::Square(cells));
  vtkNew<vtkIntArray> part;
  part->SetName("Part");
  vtkNew<vtkDoubleArray> whole;
  whole->SetName("Whole");
  vtkNew<vtkStringArray> material;
  material->SetName("Material");
  vtkNew<vtkDoubleArray> thickness;
  thickness->SetName("Thickness");
  vtkNew<vtkIntArray> number;
  number->SetName("Number");
  for (vtkIdType c = 0; c < square->GetNumberOfCells(); ++c)
  {
    double bounds[6];
    square->GetCell(c)->GetBounds(bounds);
    const int own = bounds[0] > 0.35 ? 7 : -2;
    part->InsertNextValue(own);
    whole->InsertNextValue(own);
    material->InsertNextValue(own > 0 ? "steel" : "copper");
    thickness->InsertNextValue(0.5);
    number->InsertNextValue(static_cast<int>(c));
  }
  for (vtkAbstractArray* array :
    std::initializer_list<vtkAbstractArray*>{ part, whole, material, thickness, number })
  {
    square->GetCellData()->AddArray(array);
  }
  vtkNew<vtkFieldAlignedRemesh> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(square);
  filter->SetNumberOfFaces(100);
  for (const char* name : { "Part", "Whole", "Material" })
  {
    filter->SetRegionArray(name);
    filter->Update();
    vtkPolyData* mesh = filter->GetOutput();
    CHECK(mesh->GetNumberOfCells() == 100);
    CHECK(Number(mesh, "Regions") == 2.0);
    CHECK(Number(mesh, "BordersKept") > 1.0 - 1e-12);
    CHECK(Number(mesh, "RegionsLost") == 0.0);
    CHECK(Number(mesh, "CornersMissed") == 0.0);
    CHECK(Number(mesh, "LargestAreaError") < 1e-9);
    auto* parts = vtkIntArray::SafeDownCast(mesh->GetCellData()->GetArray("Part"));
    auto* materials =
      vtkStringArray::SafeDownCast(mesh->GetCellData()->GetAbstractArray("Material"));
    CHECK(parts && materials);
    for (vtkIdType f = 0; parts && materials && f < mesh->GetNumberOfCells(); ++f)
    {
      double bounds[6];
      mesh->GetCell(f)->GetBounds(bounds);
      // Faces end at the border.
      CHECK(parts->GetValue(f) == (bounds[1] > 0.4 + 1e-6 ? 7 : -2));
      CHECK(parts->GetValue(f) == 7 ? bounds[0] > 0.4 - 1e-6 : bounds[1] < 0.4 + 1e-6);
      CHECK(materials->GetValue(f) == (parts->GetValue(f) == 7 ? "steel" : "copper"));
    }
  }
  CHECK(messages->Errors.empty());
  std::size_t errors = 0;
  for (const char* name : { "Thickness", "Number", "NoSuchArray" })
  {
    filter->SetRegionArray(name);
    filter->Update();
    CHECK(messages->Errors.size() == ++errors);
    CHECK(filter->GetOutput()->GetNumberOfCells() == 0);
  }
  filter->SetRegionArray("None");
  filter->Update();
  CHECK(messages->Errors.size() == errors);
  CHECK(filter->GetOutput()->GetFieldData()->GetArray("Regions") == nullptr);
}

/// The field that the input has is followed; one of another degree is not, which is said.
void TestFieldOfTheInput()
{
  vtkNew<vtkDirectionField> field;
  field->SetInputData(Meshes::ToPolyData(Meshes::Potato(3)));
  field->SetDegree(4);
  vtkNew<vtkFieldAlignedRemesh> filter;
  filter->SetInputConnection(field->GetOutputPort());
  filter->SetNumberOfFaces(400);
  filter->Update();
  CHECK(Number(filter->GetOutput(), "Quads") > 350.0);
  CHECK(filter->GetOutput()->GetPointData()->GetArray("Direction0") == nullptr);
  CHECK(filter->GetOutput()->GetFieldData()->GetAbstractArray("Warnings") == nullptr);

  field->SetDegree(2);
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->Update();
  CHECK(messages->Warnings.size() == 1);
  CHECK(filter->GetOutput()->GetFieldData()->GetAbstractArray("Warnings") != nullptr);
}

void TestErrorsAndUnusualInput()
{
  vtkNew<vtkFieldAlignedRemesh> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(Meshes::ToPolyData(Meshes::Cube()));
  filter->SetSizingArray("Nothing");
  filter->Update();
  CHECK(messages->Errors.size() == 1);
  CHECK(filter->GetOutput()->GetNumberOfCells() == 0);
  filter->SetSizingArray(nullptr);
  filter->SetSizeMode(vtkFieldAlignedRemesh::EDGE_LENGTH);
  filter->SetEdgeLength(0.0);
  filter->Update();
  CHECK(messages->Errors.size() == 2);
  filter->SetEdgeLength(0.25);
  filter->Update();
  CHECK(messages->Errors.size() == 2);
  CHECK(filter->GetOutput()->GetNumberOfCells() == 6 * 16);

  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  CHECK(messages->Errors.size() == 2);
  CHECK(filter->GetOutput()->GetNumberOfCells() == 0);

  // A strip of area 3.8 that has one side.
  filter->SetInputData(Meshes::ToPolyData(Meshes::MoebiusStrip(20)));
  filter->Update();
  CHECK(messages->Warnings.empty());
  const vtkIdType cells = filter->GetOutput()->GetNumberOfCells();
  CHECK(cells > 40 && cells < 90);
  vtkDataArray* euler = filter->GetOutput()->GetFieldData()->GetArray("EulerCharacteristic");
  REQUIRE(euler);
  CHECK(euler->GetComponent(0, 0) == 0.0 && euler->GetComponent(0, 1) == 0.0);
}

/// Lines by name, at places of the mesh, with the values of the regions beside them, and the same in
/// the field data of the mesh.
void TestLines()
{
  const auto square = Meshes::ToPolyData(Meshes::Square(12));
  vtkNew<vtkIntArray> number;
  number->SetName("Number");
  vtkNew<vtkStringArray> material;
  material->SetName("Material");
  for (vtkIdType c = 0; c < square->GetNumberOfCells(); ++c)
  {
    const bool isLeft = square->GetCell(c)->GetBounds()[1] < 0.51;
    number->InsertNextValue(isLeft ? 70 : 3);
    material->InsertNextValue(isLeft ? "steel" : "glass");
  }
  square->GetCellData()->AddArray(number);
  square->GetCellData()->AddArray(material);
  vtkNew<vtkFieldAlignedRemesh> filter;
  filter->SetInputData(square);
  filter->SetNumberOfFaces(100);
  for (const bool areNumbers : { true, false })
  {
    filter->SetRegionArray(areNumbers ? "Number" : "Material");
    filter->Update();
    vtkPolyData* const mesh = filter->GetOutput(0);
    vtkPolyData* const lines = filter->GetOutput(2);
    REQUIRE(lines->GetNumberOfLines() == 7 && lines->GetNumberOfCells() == 7);
    auto* const names =
      vtkStringArray::SafeDownCast(lines->GetCellData()->GetAbstractArray("ChainName"));
    vtkDataArray* const kinds = lines->GetCellData()->GetArray("ChainKind");
    vtkDataArray* const onMesh = lines->GetPointData()->GetArray("MeshPoint");
    auto* const kept =
      vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("ChainNames"));
    vtkDataArray* const offsets = mesh->GetFieldData()->GetArray("ChainOffsets");
    vtkDataArray* const points = mesh->GetFieldData()->GetArray("ChainPoints");
    REQUIRE(names && kinds && onMesh && kept && offsets && points);
    const vtkIdType border =
      names->LookupValue(areNumbers ? "Border 70/3 1" : "Border steel/glass 1");
    REQUIRE(border == 6 && kinds->GetTuple1(border) == 2.0 && kinds->GetTuple1(0) == 0.0);
    for (vtkIdType line = 0; line < 7; ++line)
    {
      CHECK(kept->GetValue(line) == names->GetValue(line));
      vtkCell* const cell = lines->GetCell(line);
      const auto first = static_cast<vtkIdType>(offsets->GetTuple1(line));
      REQUIRE(offsets->GetTuple1(line + 1) == first + cell->GetNumberOfPoints());
      for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
      {
        const auto p = static_cast<vtkIdType>(points->GetTuple1(first + i));
        CHECK(onMesh->GetTuple1(cell->GetPointId(i)) == p);
        CHECK(std::equal(mesh->GetPoint(p), mesh->GetPoint(p) + 3, cell->GetPoints()->GetPoint(i)));
        CHECK(line != border || std::abs(mesh->GetPoint(p)[0] - 0.5) < 1e-9);
      }
    }
    vtkAbstractArray* const one = lines->GetCellData()->GetAbstractArray("FirstRegion");
    vtkAbstractArray* const two = lines->GetCellData()->GetAbstractArray("SecondRegion");
    REQUIRE(one && two);
    CHECK(one->GetVariantValue(border).ToString() == (areNumbers ? "70" : "steel"));
    CHECK(two->GetVariantValue(border).ToString() == (areNumbers ? "3" : "glass"));
    CHECK(one->GetVariantValue(0).ToString() == (areNumbers ? "-1" : ""));
  }
  // Numbers that are too large for int.
  vtkNew<vtkLongLongArray> large;
  large->SetName("Large");
  for (vtkIdType c = 0; c < square->GetNumberOfCells(); ++c)
  {
    large->InsertNextValue(number->GetValue(c) == 3 ? 3 : 5000000000);
  }
  square->GetCellData()->AddArray(large);
  square->Modified();
  filter->SetRegionArray("Large");
  filter->Update();
  vtkDataArray* const beside = filter->GetOutput(2)->GetCellData()->GetArray("FirstRegion");
  REQUIRE(beside && beside->GetDataType() == VTK_LONG_LONG && beside->GetNumberOfTuples() == 7);
  CHECK(beside->GetRange()[0] == -1.0 && beside->GetRange()[1] == 5e9);
  // A mesh without lines does not keep those of the surface that it is of.
  vtkNew<vtkPolyData> again;
  again->ShallowCopy(Meshes::ToPolyData(Meshes::Potato(2)));
  again->GetFieldData()->ShallowCopy(filter->GetOutput(0)->GetFieldData());
  filter->SetInputData(again);
  filter->SetRegionArray(nullptr);
  filter->Update();
  CHECK(filter->GetOutput(2)->GetNumberOfCells() == 0);
  CHECK(filter->GetOutput(0)->GetFieldData()->GetAbstractArray("ChainNames") == nullptr);
}

/// A circle on a plate: its lines are those of the mesh while it is there, and other ones for
/// another circle, also in a group.
void TestCurves()
{
  vtkNew<vtkFieldAlignedRemesh> filter;
  filter->SetInputData(Meshes::ToPolyData(Meshes::Square(20)));
  filter->SetNumberOfFaces(400);
  filter->Update();
  CHECK(filter->GetOutput(2)->GetNumberOfCells() == 4);
  const double missed = Number(filter->GetOutput(), "Faces");
  for (const double radius : { 0.3, 0.2 })
  {
    vtkNew<vtkPolyData> circle;
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    constexpr int sides = 48;
    lines->InsertNextCell(sides + 1);
    for (int k = 0; k < sides; ++k)
    {
      const double angle = 2.0 * vtkMath::Pi() * k / sides;
      lines->InsertCellPoint(points->InsertNextPoint(
        0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle), 0.0));
    }
    lines->InsertCellPoint(0);
    circle->SetPoints(points);
    circle->SetLines(lines);
    vtkNew<vtkMultiBlockDataSet> group;
    group->SetBlock(0, circle);
    radius > 0.25 ? filter->SetCurvesData(circle) : filter->SetCurvesData(group);
    filter->Update();
    vtkPolyData* const found = filter->GetOutput(2);
    REQUIRE(found->GetNumberOfCells() == 5);
    CHECK(found->GetCellData()->GetArray("ChainKind")->GetTuple1(4) == 3.0);
    CHECK(found->GetCellData()->GetArray("CurveId")->GetTuple1(4) == 0.0);
    CHECK(found->GetCellData()->GetArray("CurveId")->GetTuple1(0) == -1.0);
    vtkPoints* const on = found->GetCell(4)->GetPoints();
    CHECK(on->GetNumberOfPoints() > 12);
    for (vtkIdType i = 0; i < on->GetNumberOfPoints(); ++i)
    {
      const double* const p = on->GetPoint(i);
      CHECK(std::abs(std::hypot(p[0] - 0.5, p[1] - 0.5) - radius) < 0.005);
    }
  }
  filter->SetInputConnection(1, nullptr);
  filter->Update();
  CHECK(filter->GetOutput(2)->GetNumberOfCells() == 4);
  CHECK(Number(filter->GetOutput(), "Faces") == missed);
}

/// The sentence names the input that is at fault.
void TestBadCurves()
{
  vtkNew<vtkPolyData> line;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  points->InsertNextPoint(0.2, 0.2, 0.0);
  points->InsertNextPoint(0.5, vtkMath::Nan(), 0.0);
  const vtkIdType ids[] = { 0, 1 };
  lines->InsertNextCell(2, ids);
  line->SetPoints(points);
  line->SetLines(lines);
  vtkNew<vtkFieldAlignedRemesh> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(Meshes::ToPolyData(Meshes::Square(4)));
  filter->SetCurvesData(line);
  filter->Update();
  REQUIRE(messages->Errors.size() == 1);
  CHECK(messages->Errors[0].find("Point 1 of the second input") != std::string::npos);
}

/// The same mesh with and without the cached stages.
void TestKeptStages()
{
  vtkNew<vtkFieldAlignedRemesh> filter;
  filter->SetInputData(Meshes::ToPolyData(Meshes::Potato(3)));
  filter->SetNumberOfFaces(300);
  filter->Update();
  filter->SetNumberOfFaces(500);
  filter->Update();
  vtkNew<vtkFieldAlignedRemesh> fresh;
  fresh->SetInputData(Meshes::ToPolyData(Meshes::Potato(3)));
  fresh->SetNumberOfFaces(500);
  fresh->KeepStagesOff();
  fresh->Update();
  CHECK(filter->GetOutput()->GetNumberOfPoints() == fresh->GetOutput()->GetNumberOfPoints());
  bool isSame = true;
  for (vtkIdType i = 0; i < fresh->GetOutput()->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      isSame = isSame && filter->GetOutput()->GetPoint(i)[c] == fresh->GetOutput()->GetPoint(i)[c];
    }
  }
  CHECK(isSame);
}

void TestAbort()
{
  vtkNew<vtkFieldAlignedRemesh> filter;
  filter->SetInputData(Meshes::ToPolyData(Meshes::Potato(3)));
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* algorithm = static_cast<vtkAlgorithm*>(caller);
      if (algorithm->GetProgress() > 0.5)
      {
        algorithm->SetAbortExecute(1);
      }
    });
  filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->Update();
  CHECK(filter->GetOutput()->GetNumberOfCells() == 0);
}
}

int TestFieldAlignedRemesh(int, char*[])
{
  TestParameters();
  TestDataIsCarriedOver();
  TestRegions();
  TestLines();
  TestCurves();
  TestBadCurves();
  TestFieldOfTheInput();
  TestErrorsAndUnusualInput();
  TestKeptStages();
  TestAbort();
  return Result();
}
