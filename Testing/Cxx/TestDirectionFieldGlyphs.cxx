// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The drawing of the glyph filter, in numbers.

#include "Checks.h"
#include "Fields.h"

#include "vtkDirectionFieldGlyphs.h"

#include "vtkStaticCellLocator.h"
#include "vtkStripper.h"

#include <algorithm>
#include <set>

using namespace Checks;

namespace
{
vtkSmartPointer<vtkPolyData> Glyphs(vtkPolyData* field, int maximum = 200)
{
  vtkNew<vtkDirectionFieldGlyphs> filter;
  filter->SetInputData(field);
  filter->SetMaximumNumberOfGlyphs(maximum);
  filter->Update();
  return filter->GetOutput();
}

double CellValue(vtkPolyData* data, const char* name, vtkIdType cell)
{
  vtkDataArray* array = data->GetCellData()->GetArray(name);
  return array ? array->GetComponent(cell, 0) : std::nan("");
}

/// All arrays have the types and sizes that are documented, and each glyph type its kind of cells.
void TestArrays()
{
  for (const int precision : { VTK_FLOAT, VTK_DOUBLE })
  {
    for (const int degree : { 1, 2, 4, 6 })
    {
      auto field = Field(PolyMeshes::Pebble(3, precision), degree);
      for (int type = 0; type <= 4; ++type)
      {
        vtkNew<vtkDirectionFieldGlyphs> filter;
        filter->SetInputData(field);
        filter->SetGlyphType(type);
        filter->SetMaximumNumberOfGlyphs(100);
        filter->Update();
        vtkPolyData* glyphs = filter->GetOutput();
        const vtkIdType cells = glyphs->GetNumberOfCells();
        CHECK(cells > 0);
        CHECK(glyphs->GetPoints()->GetDataType() == precision);
        CHECK((glyphs->GetNumberOfLines() == cells) == (type == vtkDirectionFieldGlyphs::LINES));
        CHECK((glyphs->GetNumberOfPolys() == cells) == (type != vtkDirectionFieldGlyphs::LINES));
        vtkDataArray* normals = glyphs->GetPointData()->GetNormals();
        REQUIRE(normals != nullptr);
        CHECK(normals->GetDataType() == VTK_FLOAT);
        CHECK(normals->GetNumberOfTuples() == glyphs->GetNumberOfPoints());
        vtkCellData* data = glyphs->GetCellData();
        CHECK(data->GetNumberOfArrays() == 5);
        for (const char* name :
          { "Location", "PointId", "Branch", "RepresentationMagnitude", "Direction" })
        {
          REQUIRE(data->GetArray(name) != nullptr);
          CHECK(data->GetArray(name)->GetNumberOfTuples() == cells);
        }
        CHECK(data->GetArray("Location")->GetDataType() == VTK_ID_TYPE);
        CHECK(data->GetArray("PointId")->GetDataType() == VTK_ID_TYPE);
        CHECK(data->GetArray("Branch")->GetDataType() == VTK_INT);
        CHECK(data->GetArray("RepresentationMagnitude")->GetDataType() == VTK_FLOAT);
        CHECK(data->GetArray("Direction")->GetDataType() == VTK_FLOAT);
        CHECK(data->GetArray("Direction")->GetNumberOfComponents() == 3);
        // Nothing that a viewer would color by unasked.
        CHECK(data->GetScalars() == nullptr && data->GetVectors() == nullptr);
        CHECK(glyphs->GetPointData()->GetScalars() == nullptr);

        const auto number = static_cast<vtkIdType>(FieldValue(glyphs, "NumberOfGlyphs"));
        CHECK(number <= 100 && number >= 85);
        CHECK(FieldValue(glyphs, "Spacing") > 0.0);
        std::set<std::pair<vtkIdType, int>> branches;
        for (vtkIdType i = 0; i < cells; ++i)
        {
          const auto location = static_cast<vtkIdType>(CellValue(glyphs, "Location", i));
          const auto branch = static_cast<int>(CellValue(glyphs, "Branch", i));
          const auto point = static_cast<vtkIdType>(CellValue(glyphs, "PointId", i));
          CHECK(location >= 0 && location < number);
          CHECK(branch >= 0 && branch < degree);
          CHECK(point >= 0 && point < field->GetNumberOfPoints());
          CHECK(CellValue(glyphs, "RepresentationMagnitude", i) > 0.0);
          branches.emplace(location, branch);
        }
        CHECK(static_cast<vtkIdType>(branches.size()) == number * degree);
      }
    }
  }
}

/// On all points the arms are the given directions.
void TestAllPoints()
{
  for (const int degree : { 1, 3, 4 })
  {
    auto field = Field(PolyMeshes::Pebble(3), degree);
    const auto normals = Normals(field);
    vtkNew<vtkDirectionFieldGlyphs> filter;
    filter->SetInputData(field);
    filter->SetGlyphType(vtkDirectionFieldGlyphs::LINES);
    filter->SetGlyphMode(vtkDirectionFieldGlyphs::ALL_POINTS);
    filter->SetFollowSurface(false);
    filter->Update();
    vtkPolyData* glyphs = filter->GetOutput();
    CHECK(FieldValue(glyphs, "NumberOfGlyphs") == field->GetNumberOfPoints());
    double worst = 0.0, worstNormal = 0.0;
    vtkNew<vtkIdList> ids;
    for (vtkIdType i = 0; i < glyphs->GetNumberOfCells(); ++i)
    {
      glyphs->GetCellPoints(i, ids);
      if (ids->GetNumberOfIds() == 3)
      {
        // The barbs of an arrow point elsewhere.
        continue;
      }
      double tail[3], tip[3], direction[3];
      glyphs->GetPoint(ids->GetId(0), tail);
      glyphs->GetPoint(ids->GetId(1), tip);
      vtkMath::Subtract(tip, tail, direction);
      const auto point = static_cast<vtkIdType>(CellValue(glyphs, "PointId", i));
      CHECK(point == static_cast<vtkIdType>(CellValue(glyphs, "Location", i)));
      const auto branch = static_cast<int>(CellValue(glyphs, "Branch", i));
      const double* expected = Direction(field, branch)->GetTuple3(point);
      worst = std::max(worst, vtkMath::AngleBetweenVectors(expected, direction));
      double shown[3];
      glyphs->GetCellData()->GetArray("Direction")->GetTuple(i, shown);
      CHECK(std::abs(vtkMath::Norm(shown) - 1.0) < 1e-6);
      worst = std::max(worst, vtkMath::AngleBetweenVectors(expected, shown));
      worstNormal = std::max(worstNormal,
        std::abs(vtkMath::AngleBetweenVectors(normals[static_cast<size_t>(point)].data(),
          glyphs->GetPointData()->GetNormals()->GetTuple3(ids->GetId(0)))));
    }
    CHECK(worst < 1e-6);
    CHECK(worstNormal < 1e-3);

    filter->SetMaximumNumberOfGlyphs(150);
    filter->Update();
    CHECK(FieldValue(filter->GetOutput(), "NumberOfGlyphs") <= 150);
    CHECK(FieldValue(filter->GetOutput(), "NumberOfGlyphs") >= 120);
  }
}

/// The glyphs stand off the surface by the offset, nowhere below it, and not farther from their
/// centers than half the scaled spacing.
void TestOnSurface()
{
  auto field = Field(PolyMeshes::Pebble(3), 4);
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(field);
  locator->BuildLocator();
  for (const double offset : { 0.05, 0.2 })
  {
    for (const double scale : { 0.6, 1.0 })
    {
      vtkNew<vtkDirectionFieldGlyphs> filter;
      filter->SetInputData(field);
      filter->SetSpacing(0.15);
      filter->SetOffset(offset);
      filter->SetScale(scale);
      filter->Update();
      vtkPolyData* glyphs = filter->GetOutput();
      CHECK(FieldValue(glyphs, "Spacing") == 0.15);
      double lowest = 1.0, highest = 0.0;
      for (vtkIdType i = 0; i < glyphs->GetNumberOfPoints(); ++i)
      {
        double p[3], foot[3], distance2;
        vtkIdType cell;
        int part;
        glyphs->GetPoint(i, p);
        locator->FindClosestPoint(p, foot, cell, part, distance2);
        const double length = vtkMath::Norm(p), footLength = vtkMath::Norm(foot);
        const double height = (length > footLength ? 1.0 : -1.0) * std::sqrt(distance2);
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
      }
      CHECK(lowest > 0.15 * (offset - 0.03));
      CHECK(highest < 0.15 * (offset + 0.03));

      // The glyph has this diameter, up to the curvature.
      const auto number = static_cast<vtkIdType>(FieldValue(glyphs, "NumberOfGlyphs"));
      std::vector<std::vector<PolyMeshes::Point>> points(static_cast<size_t>(number));
      vtkNew<vtkIdList> ids;
      for (vtkIdType i = 0; i < glyphs->GetNumberOfCells(); ++i)
      {
        glyphs->GetCellPoints(i, ids);
        for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
        {
          PolyMeshes::Point p;
          glyphs->GetPoint(ids->GetId(k), p.data());
          points[static_cast<size_t>(CellValue(glyphs, "Location", i))].push_back(p);
        }
      }
      for (const auto& glyph : points)
      {
        double diameter2 = 0.0;
        for (const auto& a : glyph)
        {
          for (const auto& b : glyph)
          {
            diameter2 = std::max(diameter2, vtkMath::Distance2BetweenPoints(a.data(), b.data()));
          }
        }
        CHECK(std::abs(std::sqrt(diameter2) / (scale * 0.15) - 1.0) < 0.12);
      }
    }
  }

  // Outside in: below the surface.
  vtkNew<vtkDirectionFieldGlyphs> filter;
  filter->SetInputData(field);
  filter->SetOffset(-0.3);
  filter->Update();
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    double p[3], foot[3], distance2;
    vtkIdType cell;
    int part;
    filter->GetOutput()->GetPoint(i, p);
    locator->FindClosestPoint(p, foot, cell, part, distance2);
    CHECK(vtkMath::Norm(p) < vtkMath::Norm(foot));
  }
}

/// Quads and strips have the glyphs of the same triangles.
void TestPolygons()
{
  auto torus = PolyMeshes::QuadTorus(28, 12);
  auto glyphs = Glyphs(Field(torus, 4));
  CHECK(FieldValue(glyphs, "NumberOfGlyphs") > 170);

  auto pebble = PolyMeshes::Pebble(3);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(pebble);
  stripper->Update();
  CHECK(stripper->GetOutput()->GetNumberOfStrips() > 0);
  auto strips = Glyphs(Field(stripper->GetOutput(), 4));
  CHECK(FieldValue(strips, "NumberOfGlyphs") > 170);
  CHECK(std::abs(FieldValue(strips, "Spacing") / FieldValue(Glyphs(Field(pebble, 4)), "Spacing") -
          1.0) < 0.1);
}
}

int TestDirectionFieldGlyphs(int, char*[])
{
  TestArrays();
  TestAllPoints();
  TestOnSurface();
  TestPolygons();
  return Result();
}
