// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Polydata that contradicts itself, as that of a damaged file may: an error that says what is wrong,
// from both filters, and nothing else.

#include "Checks.h"

#include "vtkDirectionField.h"
#include "vtkDirectionFieldGlyphs.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <functional>
#include <initializer_list>

using namespace Checks;

namespace
{
using Words = std::initializer_list<const char*>;
using Damage = std::function<void(vtkPolyData*)>;

/// A pebble with its field.
vtkSmartPointer<vtkPolyData> Sound()
{
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(PolyMeshes::Pebble(1));
  filter->Update();
  auto field = vtkSmartPointer<vtkPolyData>::New();
  field->DeepCopy(filter->GetOutput());
  return field;
}

template <typename FilterT>
void CheckError(vtkPolyData* mesh, Words words)
{
  vtkNew<FilterT> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(mesh);
  filter->Update();
  CHECK(messages->IsOneError(words));
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    CHECK(filter->GetOutput(port)->GetNumberOfPoints() == 0);
    CHECK(filter->GetOutput(port)->GetPointData()->GetNumberOfArrays() == 0);
  }
  // The filter works as before after the error.
  filter->SetInputData(Sound());
  filter->Update();
  CHECK(messages->Errors.size() == 1);
  CHECK(filter->GetOutput()->GetNumberOfCells() > 0);
}

void TestError(const Damage& damage, Words words)
{
  auto mesh = Sound();
  damage(mesh);
  CheckError<vtkDirectionField>(mesh, words);
  CheckError<vtkDirectionFieldGlyphs>(mesh, words);
}

template <typename ArrayT>
vtkSmartPointer<ArrayT> Integers(const std::vector<int>& values)
{
  auto array = vtkSmartPointer<ArrayT>::New();
  for (const int value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

/// Cells with whatever offsets.
template <typename ArrayT>
vtkSmartPointer<vtkCellArray> CellsOf(
  const std::vector<int>& offsets, const std::vector<int>& corners)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(Integers<ArrayT>(offsets), Integers<ArrayT>(corners));
  return cells;
}

template <typename ArrayT>
void TestOffsets()
{
  const std::vector<int> corners = { 0, 1, 2, 3, 4, 5, 6, 7, 8 };
  const auto polys = [&](const std::vector<int>& offsets)
  { return [=](vtkPolyData* mesh) { mesh->SetPolys(CellsOf<ArrayT>(offsets, corners)); }; };
  TestError(polys({ 0, 6, 3, 9 }), { "offsets of the polygons", "3 follows 6", "anew" });
  TestError(polys({ 0, 3, -3, 9 }), { "offsets of the polygons", "-3 follows 3" });
  TestError(polys({ 0, 1000000000, 6, 9 }), { "6 follows 1000000000" });
  TestError(polys({ 3, 6, 9 }), { "from 3 to 9", "9 corners" });
  TestError(polys({ 0, 3, 6, 9, 12 }), { "from 0 to 12", "9 corners" });
  TestError(polys({ 0, 3, 6 }), { "from 0 to 6", "9 corners" });
  TestError(polys({}), { "polygons", "there are none" });
  const auto bad = [&] { return CellsOf<ArrayT>({ 0, 6, 3, 9 }, corners); };
  TestError([&](vtkPolyData* mesh) { mesh->SetStrips(bad()); }, { "offsets of the strips" });
  TestError([&](vtkPolyData* mesh) { mesh->SetLines(bad()); }, { "offsets of the lines" });
  TestError([&](vtkPolyData* mesh) { mesh->SetVerts(bad()); }, { "offsets of the vertices" });
}

/// Points that are not there are refused wherever they are used.
void TestCorners()
{
  const auto cells = [](const std::vector<int>& offsets, const std::vector<int>& corners)
  { return CellsOf<vtkTypeInt64Array>(offsets, corners); };
  TestError(
    [&](vtkPolyData* mesh) {
      mesh->SetVerts(cells({ 0, 1, 2 }, { 0, 42 }));
    },
    { "Cell 1 uses point 42", "42 points" });
  TestError(
    [&](vtkPolyData* mesh) {
      mesh->SetLines(cells({ 0, 2 }, { 0, -1 }));
    },
    { "Cell 0 uses point -1" });
  // Polygons and strips without triangles, and cells between which others are empty.
  TestError(
    [&](vtkPolyData* mesh) {
      mesh->SetPolys(cells({ 0, 3, 5 }, { 0, 1, 2, 0, 77 }));
    },
    { "Cell 1 uses point 77" });
  TestError(
    [&](vtkPolyData* mesh)
    {
      mesh->SetStrips(cells({ 0, 2 }, { 99, 0 }));
      mesh->GetCellData()->Initialize();
    },
    { "Cell 80 uses point 99" });
  TestError(
    [&](vtkPolyData* mesh) {
      mesh->SetPolys(cells({ 0, 0, 3, 3, 3, 5 }, { 0, 1, 2, 3, 50 }));
    },
    { "Cell 4 uses point 50" });
  TestError(
    [&](vtkPolyData* mesh)
    {
      mesh->SetPolys(cells({ 0, 3, 6 }, { 0, 1, 2, 0, 1, 50 }));
      mesh->GetCellData()->Initialize();
      auto ghosts = Integers<vtkUnsignedCharArray>({ 0, vtkDataSetAttributes::HIDDENCELL });
      ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
      mesh->GetCellData()->AddArray(ghosts);
    },
    { "Cell 1 uses point 50" });
  TestError(
    [&](vtkPolyData* mesh)
    {
      mesh->SetPoints(vtkNew<vtkPoints>());
      mesh->GetPointData()->Initialize();
    },
    { "Cell 0 uses point", "0 points" });
}

void TestArrays()
{
  const auto array = [](const char* name, vtkIdType tuples, int components)
  {
    auto doubles = vtkSmartPointer<vtkDoubleArray>::New();
    doubles->SetName(name);
    doubles->SetNumberOfComponents(components);
    doubles->SetNumberOfTuples(tuples);
    doubles->Fill(1.0);
    return doubles;
  };
  TestError([&](vtkPolyData* mesh) { mesh->GetPointData()->AddArray(array("mine", 41, 2)); },
    { "point array \"mine\" has 41 tuples", "42 points", "Remove it" });
  TestError([&](vtkPolyData* mesh) { mesh->GetCellData()->AddArray(array("mine", 79, 1)); },
    { "cell array \"mine\" has 79 tuples", "80 cells" });
  TestError([&](vtkPolyData* mesh) { mesh->GetPointData()->AddArray(array("Direction0", 7, 3)); },
    { "point array \"Direction0\" has 7 tuples" });
  TestError(
    [&](vtkPolyData* mesh)
    {
      vtkNew<vtkStringArray> names;
      names->InsertNextValue("one");
      mesh->GetPointData()->AddArray(names);
    },
    { "point array \"\" has 1 tuples" });
  const char* ghosts = vtkDataSetAttributes::GhostArrayName();
  TestError([&](vtkPolyData* mesh) { mesh->GetPointData()->AddArray(array(ghosts, 42, 1)); },
    { "point array \"vtkGhostType\"", "unsigned char" });
  TestError(
    [&](vtkPolyData* mesh)
    {
      vtkNew<vtkUnsignedCharArray> pairs;
      pairs->SetName(ghosts);
      pairs->SetNumberOfComponents(2);
      pairs->SetNumberOfTuples(80);
      mesh->GetCellData()->AddArray(pairs);
    },
    { "cell array \"vtkGhostType\"", "one component" });

  // The glyphs need the field's arrays as the field filter has made them.
  for (const char* name : { "Direction1", "RepresentationMagnitude" })
  {
    auto mesh = Sound();
    mesh->GetPointData()->AddArray(array(name, 42, 2));
    CheckError<vtkDirectionFieldGlyphs>(mesh, { name, "component" });
  }
}

/// Odd but harmless data is no error: too many tuples, field data of any kind, cells without corners.
void TestHarmless()
{
  auto mesh = Sound();
  vtkNew<vtkDoubleArray> longer;
  longer->SetName("longer");
  longer->SetNumberOfTuples(1000);
  longer->Fill(std::nan(""));
  mesh->GetPointData()->AddArray(longer);
  mesh->GetFieldData()->AddArray(longer);
  vtkNew<vtkStringArray> nameless;
  mesh->GetFieldData()->AddArray(nameless);
  vtkNew<vtkStringArray> mine;
  mine->SetName("Eigenvalue");
  mine->InsertNextValue("none");
  mesh->GetFieldData()->AddArray(mine);
  mesh->SetLines(CellsOf<vtkTypeInt32Array>({ 0, 0, 0 }, {}));
  mesh->GetCellData()->Initialize();
  vtkNew<vtkDirectionField> filter;
  vtkNew<vtkDirectionFieldGlyphs> glyphs;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  messages->Observe(glyphs);
  filter->SetInputData(mesh);
  glyphs->SetInputConnection(filter->GetOutputPort());
  glyphs->Update();
  CHECK(messages->IsEmpty());
  CHECK(FieldValue(filter->GetOutput(), "IndexSum") == 8);
  CHECK(glyphs->GetOutput()->GetNumberOfCells() > 0);
}
}

int TestDirectionFieldDamaged(int, char*[])
{
  TestOffsets<vtkTypeInt32Array>();
  TestOffsets<vtkTypeInt64Array>();
  TestCorners();
  TestArrays();
  TestHarmless();
  return Result();
}
