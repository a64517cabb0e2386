// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which side of a surface the glyphs are on, and that their places are kept as long as it stays.

#include "Checks.h"
#include "Fields.h"

#include "vtkDirectionField.h"
#include "vtkDirectionFieldGlyphs.h"

#include "vtkCallbackCommand.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

using namespace Checks;

namespace
{
PolyMeshes::Mesh InsideOut(vtkPolyData* mesh)
{
  auto turned = PolyMeshes::Mesh::New();
  turned->DeepCopy(mesh);
  turned->GetPolys()->Initialize();
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < mesh->GetPolys()->GetNumberOfCells(); ++i)
  {
    mesh->GetPolys()->GetCellAtId(i, ids);
    turned->GetPolys()->InsertNextCell(ids->GetNumberOfIds());
    for (vtkIdType k = ids->GetNumberOfIds(); k-- > 0;)
    {
      turned->GetPolys()->InsertCellPoint(ids->GetId(k));
    }
  }
  return turned;
}

bool IsSameOutput(vtkPolyData* one, vtkPolyData* other)
{
  return one && other && IsSame(one->GetPoints()->GetData(), other->GetPoints()->GetData()) &&
    IsSame(one->GetPointData(), other->GetPointData()) &&
    IsSame(one->GetCellData(), other->GetCellData()) &&
    IsSame(one->GetFieldData(), other->GetFieldData());
}

/// The filter's output is that of a new filter.
bool IsRight(vtkDirectionFieldGlyphs* filter, vtkPolyData* field)
{
  vtkNew<vtkDirectionFieldGlyphs> fresh;
  fresh->SetInputData(field);
  fresh->SetMaximumNumberOfGlyphs(filter->GetMaximumNumberOfGlyphs());
  fresh->SetGlyphMode(filter->GetGlyphMode());
  fresh->SetSide(filter->GetSide());
  fresh->Update();
  return IsSameOutput(filter->GetOutput(), fresh->GetOutput());
}

/// Tells whether places were sought: the search reports its progress, from 0.2 to 0.7.
class Search
{
public:
  explicit Search(vtkAlgorithm* algorithm)
  {
    this->Record->SetClientData(this);
    this->Record->SetCallback(
      [](vtkObject*, unsigned long, void* client, void* progress)
      {
        auto* self = static_cast<Search*>(client);
        const double part = *static_cast<double*>(progress);
        ++self->AllReports;
        self->Reports += part > 0.2 && part < 0.68 ? 1 : 0;
      });
    algorithm->AddObserver(vtkCommand::ProgressEvent, this->Record);
  }

  /// Whether there was one since the last question.
  bool Was()
  {
    const bool was = this->Reports > 0;
    this->Reports = 0;
    return was;
  }

  /// All reports since the last question. Of a composite input each block has a part of the range, so that
  /// only their number tells.
  int TakeReports()
  {
    const int reports = this->AllReports;
    this->AllReports = 0;
    return reports;
  }

private:
  int Reports = 0;
  int AllReports = 0;
  vtkNew<vtkCallbackCommand> Record;
};

/// Closed surfaces have their glyphs outside, whatever their winding; open ones on both sides.
void TestSides()
{
  auto sphere = PolyMeshes::Icosphere(4);
  for (const auto& mesh : { sphere, InsideOut(sphere) })
  {
    for (const int degree : { 1, 4 })
    {
      vtkNew<vtkDirectionFieldGlyphs> filter;
      filter->SetInputData(Field(mesh, degree));
      filter->SetOffset(0.2);
      filter->SetMaximumNumberOfGlyphs(500);
      filter->Update();
      vtkPolyData* glyphs = filter->GetOutput();
      CHECK(FieldValue(glyphs, "NumberOfGlyphs") > 400);
      double nearest = 2.0;
      double least = 1.0;
      for (vtkIdType i = 0; i < glyphs->GetNumberOfPoints(); ++i)
      {
        double p[3];
        glyphs->GetPoint(i, p);
        nearest = std::min(nearest, vtkMath::Norm(p));
        least =
          std::min(least, vtkMath::Dot(p, glyphs->GetPointData()->GetNormals()->GetTuple3(i)));
      }
      CHECK(nearest > 1.0);
      CHECK(least > 0.9);
    }
  }

  vtkNew<vtkDirectionFieldGlyphs> filter;
  filter->SetInputData(Field(PolyMeshes::Square(10), 4));
  filter->SetMaximumNumberOfGlyphs(100);
  filter->Update();
  vtkPolyData* glyphs = filter->GetOutput();
  const double number = FieldValue(glyphs, "NumberOfGlyphs");
  CHECK(number > 80.0 && number <= 100.0);
  double bounds[6];
  glyphs->GetBounds(bounds);
  CHECK(bounds[4] < 0.0 && bounds[5] == -bounds[4]);
  CHECK(glyphs->GetCellData()->GetArray("Location")->GetRange()[1] == number - 1.0);
  const vtkIdType cells = glyphs->GetNumberOfCells();
  for (const int side : { vtkDirectionFieldGlyphs::SIDE_FRONT, vtkDirectionFieldGlyphs::SIDE_BACK })
  {
    filter->SetSide(side);
    filter->Update();
    filter->GetOutput()->GetBounds(bounds);
    CHECK((bounds[4] > 0.0) == (side == vtkDirectionFieldGlyphs::SIDE_FRONT));
    CHECK((bounds[5] < 0.0) == (side == vtkDirectionFieldGlyphs::SIDE_BACK));
    CHECK(2 * filter->GetOutput()->GetNumberOfCells() == cells);
    CHECK(FieldValue(filter->GetOutput(), "NumberOfGlyphs") == number);
  }
}

/// Data of the surface are kept: with other fields and other looks, and in polygons.
void TestPlacesAreKept()
{
  for (const auto& mesh : { PolyMeshes::Pebble(4), PolyMeshes::QuadTorus(60, 30) })
  {
    vtkNew<vtkDirectionField> field;
    field->SetInputData(mesh);
    vtkNew<vtkDirectionFieldGlyphs> filter;
    Search search(filter);
    filter->SetInputConnection(field->GetOutputPort());
    filter->SetMaximumNumberOfGlyphs(400);
    filter->Update();
    CHECK(search.Was());
    vtkNew<vtkPolyData> before;
    before->DeepCopy(filter->GetOutput());
    for (const double bias : { 0.5, -0.5 })
    {
      field->SetEnergyBias(bias);
      filter->Update();
      CHECK(!search.Was());
      CHECK(IsRight(filter, field->GetOutput()));
      CHECK(FieldValue(filter->GetOutput(), "Spacing") == FieldValue(before, "Spacing"));
      CHECK(!IsSame(filter->GetOutput()->GetCellData(), before->GetCellData()));
    }
    filter->SetScale(0.5);
    filter->SetGlyphType(vtkDirectionFieldGlyphs::TUBES);
    filter->Update();
    CHECK(!search.Was());
    filter->SetMaximumNumberOfGlyphs(300);
    filter->Update();
    CHECK(search.Was());
    filter->ReleaseSurfaces();
    filter->Modified();
    filter->Update();
    CHECK(search.Was());
  }
}

/// Equal contents in other objects do as well, and in the places of one field stand those of another.
void TestEqualSurfaces()
{
  vtkNew<vtkDirectionFieldGlyphs> filter;
  filter->SetMaximumNumberOfGlyphs(400);
  Search search(filter);
  std::vector<double> locations;
  for (const int degree : { 4, 1, 4 })
  {
    vtkNew<vtkPolyData> copy;
    copy->DeepCopy(Field(PolyMeshes::QuadTorus(40, 20), degree));
    filter->SetInputData(copy);
    filter->Update();
    CHECK(search.Was() == locations.empty());
    CHECK(IsRight(filter, copy));
    locations.push_back(FieldValue(filter->GetOutput(), "NumberOfGlyphs"));
  }
  CHECK(locations[0] == locations[1] && locations[1] == locations[2]);
}

/// Other points, cells and ghosts are noticed, even where nobody says that they were modified.
void TestChanges()
{
  for (const auto& mesh : { PolyMeshes::Pebble(3), PolyMeshes::QuadTorus(30, 15) })
  {
    vtkNew<vtkPolyData> field;
    field->DeepCopy(Field(mesh, 4));
    vtkNew<vtkDirectionFieldGlyphs> filter;
    filter->SetMaximumNumberOfGlyphs(300);
    Search search(filter);
    filter->SetInputData(field);
    const auto isSoughtAnew = [&]
    {
      filter->Modified();
      filter->Update();
      return search.Was() && IsRight(filter, field);
    };
    CHECK(isSoughtAnew());
    CHECK(!isSoughtAnew());
    double p[3];
    field->GetPoint(11, p);
    vtkMath::MultiplyScalar(p, 1.1);
    field->GetPoints()->SetPoint(11, p);
    CHECK(isSoughtAnew());
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfTuples(field->GetNumberOfCells());
    for (vtkIdType i = 0; i < field->GetNumberOfCells(); ++i)
    {
      ghosts->SetValue(i, i % 3 == 0 ? vtkDataSetAttributes::DUPLICATECELL : 0);
    }
    field->GetCellData()->AddArray(ghosts);
    CHECK(isSoughtAnew());
    CHECK(!isSoughtAnew());
    vtkNew<vtkUnsignedCharArray> points;
    points->SetName(vtkDataSetAttributes::GhostArrayName());
    points->SetNumberOfTuples(field->GetNumberOfPoints());
    points->Fill(0.0);
    points->SetValue(5, vtkDataSetAttributes::DUPLICATEPOINT);
    field->GetPointData()->AddArray(points);
    CHECK(isSoughtAnew());
    vtkNew<vtkCellArray> fewer;
    vtkNew<vtkIdList> ids;
    for (vtkIdType i = 10; i < field->GetNumberOfPolys(); ++i)
    {
      field->GetPolys()->GetCellAtId(i, ids);
      fewer->InsertNextCell(ids);
    }
    field->GetCellData()->Initialize();
    field->SetPolys(fewer);
    CHECK(isSoughtAnew());
  }
}

/// Each block keeps its own places; blocks that come and go do no harm.
void TestComposite()
{
  const auto fields = [](int degree, bool third)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, Field(PolyMeshes::Pebble(3), degree));
    blocks->SetBlock(2, Field(PolyMeshes::QuadTorus(30, 15), degree));
    if (third)
    {
      blocks->SetBlock(3, Field(PolyMeshes::Square(9), degree));
    }
    return vtkSmartPointer<vtkMultiBlockDataSet>(blocks);
  };
  vtkNew<vtkDirectionFieldGlyphs> filter;
  filter->SetMaximumNumberOfGlyphs(300);
  Search search(filter);
  int run = 0;
  std::vector<int> reports;
  for (const bool third : { false, false, true, true, false, true })
  {
    auto input = fields(run % 2 == 0 ? 4 : 2, third);
    filter->SetInputDataObject(input);
    filter->Update();
    reports.push_back(search.TakeReports());
    auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    REQUIRE(output && output->GetNumberOfBlocks() == input->GetNumberOfBlocks());
    for (unsigned int block = 0; block < input->GetNumberOfBlocks(); ++block)
    {
      auto* field = vtkPolyData::SafeDownCast(input->GetBlock(block));
      if (field)
      {
        vtkNew<vtkDirectionFieldGlyphs> alone;
        alone->SetMaximumNumberOfGlyphs(300);
        alone->SetInputData(field);
        alone->Update();
        CHECK(IsSameOutput(vtkPolyData::SafeDownCast(output->GetBlock(block)), alone->GetOutput()));
      }
    }
    ++run;
  }
  const int ofTwo = reports[1];
  const int ofThree = reports[3];
  CHECK(reports[4] == ofTwo && ofTwo < ofThree);
  CHECK(reports[0] > ofTwo + 9);
  CHECK(reports[2] > ofThree + 4 && reports[5] == reports[2]);
  // Only the block that is new was searched.
  vtkNew<vtkDirectionFieldGlyphs> fresh;
  fresh->SetMaximumNumberOfGlyphs(300);
  Search searchOfAll(fresh);
  fresh->SetInputDataObject(fields(4, true));
  fresh->Update();
  CHECK(searchOfAll.TakeReports() == reports[0] - ofTwo + reports[2]);
}

/// Without the pipeline's events, which somebody may have cut off, the places are right all the same.
void TestWithoutEvents()
{
  vtkNew<vtkDirectionFieldGlyphs> filter;
  filter->RemoveAllObservers();
  filter->SetMaximumNumberOfGlyphs(300);
  for (const int degree : { 4, 2 })
  {
    for (const auto& mesh : { PolyMeshes::Pebble(3), PolyMeshes::QuadTorus(30, 15) })
    {
      auto field = Field(mesh, degree);
      filter->SetInputData(field);
      filter->Update();
      CHECK(IsRight(filter, field));
    }
  }
}
}

int TestDirectionFieldGlyphsPlaces(int, char*[])
{
  TestSides();
  TestPlacesAreKept();
  TestEqualSurfaces();
  TestChanges();
  TestComposite();
  TestWithoutEvents();
  return Result();
}
