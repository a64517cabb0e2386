// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How the glyph filter behaves in a pipeline: parameters, errors, unusual input, progress, abort.

#include "Checks.h"
#include "Fields.h"

#include "vtkCompareDirectionFields.h"
#include "vtkDirectionFieldGlyphs.h"
#include "vtkDirectionFieldSingularities.h"
#include "vtkDirectionFieldStreamlines.h"
#include "vtkFieldAlignedRemesh.h"
#include "vtkGuidanceCurves.h"
#include "vtkStripePattern.h"

#include "vtkCallbackCommand.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <type_traits>

using namespace Checks;

namespace
{
void TestParameters()
{
  vtkNew<vtkDirectionFieldGlyphs> filter;
  CHECK(filter->GetGlyphType() == vtkDirectionFieldGlyphs::AUTOMATIC);
  CHECK(filter->GetGlyphMode() == vtkDirectionFieldGlyphs::SPREAD_EVENLY);
  CHECK(filter->GetSide() == vtkDirectionFieldGlyphs::SIDE_AUTOMATIC);
  CHECK(filter->GetSpacing() == 0.0);
  CHECK(filter->GetMaximumNumberOfGlyphs() == 0);
  CHECK(filter->GetScale() == 1.0);
  CHECK(filter->GetOffset() == 0.04);
  CHECK(filter->GetFollowSurface());
  CHECK(filter->GetNumberOfInputPorts() == 1);
  CHECK(filter->GetNumberOfOutputPorts() == 1);

  filter->SetGlyphType(4);
  filter->SetGlyphMode(1);
  filter->SetSide(2);
  filter->SetSpacing(0.25);
  filter->SetMaximumNumberOfGlyphs(77);
  filter->SetScale(0.5);
  filter->SetOffset(-0.125);
  filter->FollowSurfaceOff();
  std::ostringstream text;
  filter->Print(text);
  for (const char* line : { "GlyphType: 4\n", "GlyphMode: 1\n", "Side: 2\n", "Spacing: 0.25\n",
         "MaximumNumberOfGlyphs: 77\n", "Scale: 0.5\n", "Offset: -0.125\n", "FollowSurface: 0\n" })
  {
    CHECK(text.str().find(line) != std::string::npos);
  }

  filter->SetGlyphType(9);
  CHECK(filter->GetGlyphType() == vtkDirectionFieldGlyphs::TUBES);
  filter->SetGlyphMode(-1);
  CHECK(filter->GetGlyphMode() == vtkDirectionFieldGlyphs::SPREAD_EVENLY);
  filter->SetSide(4);
  CHECK(filter->GetSide() == vtkDirectionFieldGlyphs::SIDE_BOTH);
  filter->SetSide(-1);
  CHECK(filter->GetSide() == vtkDirectionFieldGlyphs::SIDE_AUTOMATIC);
  filter->SetSpacing(-1.0);
  CHECK(filter->GetSpacing() == 0.0);
  filter->SetMaximumNumberOfGlyphs(-1);
  CHECK(filter->GetMaximumNumberOfGlyphs() == 0);
  filter->SetMaximumNumberOfGlyphs(2000000);
  CHECK(filter->GetMaximumNumberOfGlyphs() == 1000000);
  filter->SetScale(0.0);
  CHECK(filter->GetScale() == 0.01);
  filter->SetOffset(2.0);
  CHECK(filter->GetOffset() == 1.0);
}

void TestErrors()
{
  const auto checkError = [](vtkPolyData* input)
  {
    vtkNew<vtkDirectionFieldGlyphs> filter;
    vtkNew<Messages> messages;
    messages->Observe(filter);
    filter->SetInputData(input);
    filter->Update();
    CHECK(messages->IsOneError({ "Direction0", "Apply Direction Field" }));
    CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  };
  auto mesh = PolyMeshes::Pebble(1);
  checkError(mesh);
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("Direction0");
  scalars->SetNumberOfTuples(mesh->GetNumberOfPoints());
  scalars->Fill(1.0);
  mesh->GetPointData()->AddArray(scalars);
  checkError(mesh);

  // NaN, which no clamp catches.
  auto field = Field(PolyMeshes::Pebble(1), 4);
  const auto checkNaN = [&](void (vtkDirectionFieldGlyphs::*set)(double), const char* name)
  {
    vtkNew<vtkDirectionFieldGlyphs> filter;
    vtkNew<Messages> messages;
    messages->Observe(filter);
    filter->SetInputData(field);
    (filter->*set)(std::nan(""));
    filter->Update();
    CHECK(messages->IsOneError({ name, " must be " }));
    CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  };
  checkNaN(&vtkDirectionFieldGlyphs::SetScale, "Scale");
  checkNaN(&vtkDirectionFieldGlyphs::SetOffset, "Offset");
  checkNaN(&vtkDirectionFieldGlyphs::SetSpacing, "Spacing");
}

/// An input without anything to draw is no error.
void TestEmpty()
{
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkPolyData> zero;
  zero->DeepCopy(Field(PolyMeshes::Pebble(1), 4));
  for (int k = 0; k < 4; ++k)
  {
    for (int c = 0; c < 3; ++c)
    {
      Direction(zero, k)->FillComponent(c, 0.0);
    }
  }
  vtkNew<vtkPolyData> lines;
  lines->ShallowCopy(zero);
  lines->SetPolys(vtkNew<vtkCellArray>());
  for (vtkPolyData* input : { empty.Get(), zero.Get(), lines.Get() })
  {
    for (const int mode : { 0, 1 })
    {
      vtkNew<vtkDirectionFieldGlyphs> filter;
      vtkNew<Messages> messages;
      messages->Observe(filter);
      filter->SetInputData(input);
      filter->SetGlyphMode(mode);
      filter->Update();
      CHECK(messages->IsEmpty());
      CHECK(filter->GetOutput()->GetNumberOfCells() == 0);
      CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
    }
  }
}

/// Points and directions that are not finite are refused by each filter, with their place.
template <typename Filter>
void CheckNotFinite(int degree)
{
  const double bad = std::nan("");
  // Guidance From Curves has no use for directions.
  const int kinds = std::is_same_v<Filter, vtkGuidanceCurves> ? 1 : 4;
  for (int k = 0; k < kinds; ++k)
  {
    vtkNew<vtkPolyData> field;
    field->DeepCopy(Field(PolyMeshes::Pebble(3), degree));
    if (k == 0)
    {
      field->GetPoints()->SetPoint(5, bad, 0.0, 0.0);
    }
    else if (k == 1)
    {
      field->GetPointData()->GetArray("RepresentationMagnitude")->SetComponent(5, 0, bad);
    }
    else
    {
      Direction(field, k - 2)
        ->SetComponent(5, 1, k == 2 ? bad : std::numeric_limits<double>::infinity());
    }
    vtkNew<Filter> filter;
    vtkNew<Messages> messages;
    messages->Observe(filter);
    filter->SetInputData(0, field);
    if (filter->GetNumberOfInputPorts() > 1)
    {
      filter->SetInputData(1, field);
    }
    filter->Update();
    CHECK(messages->IsOneError({ "point 5", "NaN" }));
    CHECK(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints() == 0);
  }
}

void TestNotFinite()
{
  CheckNotFinite<vtkDirectionFieldGlyphs>(4);
  CheckNotFinite<vtkDirectionFieldStreamlines>(4);
  CheckNotFinite<vtkStripePattern>(2);
  CheckNotFinite<vtkFieldAlignedRemesh>(4);
  CheckNotFinite<vtkDirectionFieldSingularities>(4);
  CheckNotFinite<vtkCompareDirectionFields>(4);
  CheckNotFinite<vtkGuidanceCurves>(4);
}

/// Ghost cells and points have no glyphs.
void TestGhosts()
{
  vtkNew<vtkPolyData> field;
  field->DeepCopy(Field(PolyMeshes::Square(10), 4));
  vtkNew<vtkUnsignedCharArray> cells, points;
  cells->SetName(vtkDataSetAttributes::GhostArrayName());
  points->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType i = 0; i < field->GetNumberOfCells(); ++i)
  {
    double bounds[6];
    field->GetCellBounds(i, bounds);
    cells->InsertNextValue(bounds[1] < 0.31 ? vtkDataSetAttributes::DUPLICATECELL
        : bounds[0] > 0.69                  ? vtkDataSetAttributes::HIDDENCELL
                                            : 0);
  }
  for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
  {
    points->InsertNextValue(
      field->GetPoint(i)[0] < 0.29 ? vtkDataSetAttributes::DUPLICATEPOINT : 0);
  }
  field->GetCellData()->AddArray(cells);
  field->GetPointData()->AddArray(points);
  for (const int mode : { 0, 1 })
  {
    vtkNew<vtkDirectionFieldGlyphs> filter;
    filter->SetInputData(field);
    filter->SetGlyphMode(mode);
    filter->SetScale(0.01);
    filter->SetMaximumNumberOfGlyphs(300);
    filter->Update();
    CHECK(FieldValue(filter->GetOutput(), "NumberOfGlyphs") > 40);
    double bounds[6];
    filter->GetOutput()->GetBounds(bounds);
    CHECK(bounds[0] > 0.29 && bounds[1] < 0.71);
  }
}

/// Two runs give the same bytes, however the pipeline was used before.
void TestRepetition()
{
  auto field = Field(PolyMeshes::Pebble(4), 6);
  vtkNew<vtkDirectionFieldGlyphs> one, other;
  other->SetInputData(Field(PolyMeshes::Square(4), 2));
  other->Update();
  for (vtkDirectionFieldGlyphs* filter : { one.Get(), other.Get() })
  {
    filter->SetInputData(field);
    filter->Update();
  }
  const auto isSame = [&]()
  {
    return IsSame(one->GetOutput()->GetPoints()->GetData(),
             other->GetOutput()->GetPoints()->GetData()) &&
      IsSame(one->GetOutput()->GetPointData(), other->GetOutput()->GetPointData()) &&
      IsSame(one->GetOutput()->GetCellData(), other->GetOutput()->GetCellData()) &&
      IsSame(one->GetOutput()->GetFieldData(), other->GetOutput()->GetFieldData());
  };
  CHECK(isSame());
  other->SetOffset(0.3);
  other->Update();
  CHECK(!isSame());
}

void TestProgressAndAbort()
{
  auto field = Field(PolyMeshes::Pebble(4), 4);
  std::vector<double> steps;
  vtkNew<vtkCallbackCommand> record;
  record->SetClientData(&steps);
  record->SetCallback([](vtkObject*, unsigned long, void* client, void* progress)
    { static_cast<std::vector<double>*>(client)->push_back(*static_cast<double*>(progress)); });
  vtkNew<vtkDirectionFieldGlyphs> filter;
  filter->SetInputData(field);
  // So many that each phase reports more than its end.
  filter->SetMaximumNumberOfGlyphs(2000);
  filter->AddObserver(vtkCommand::ProgressEvent, record);
  filter->Update();
  CHECK(steps.size() >= 6);
  CHECK(std::is_sorted(steps.begin(), steps.end()));
  REQUIRE(!steps.empty());
  CHECK(steps.back() == 1.0);

  for (const double when : { 0.0, 0.3, 0.5, 0.75 })
  {
    struct
    {
      double When;
      int Later;
    } state = { when, -1 };
    vtkNew<vtkCallbackCommand> stop;
    stop->SetClientData(&state);
    stop->SetCallback(
      [](vtkObject* caller, unsigned long, void* client, void* progress)
      {
        auto request = static_cast<decltype(state)*>(client);
        if (*static_cast<double*>(progress) > request->When)
        {
          ++request->Later;
          static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
        }
      });
    vtkNew<vtkDirectionFieldGlyphs> stopped;
    vtkNew<Messages> messages;
    messages->Observe(stopped);
    stopped->SetInputData(field);
    stopped->SetMaximumNumberOfGlyphs(2000);
    const unsigned long tag = stopped->AddObserver(vtkCommand::ProgressEvent, stop);
    stopped->Update();
    CHECK(messages->IsEmpty());
    CHECK(stopped->GetOutput()->GetNumberOfPoints() == 0);
    // The computation reports nothing after that; only the pipeline and the first phase do.
    CHECK(state.Later >= 0 && state.Later <= 2);

    stopped->RemoveObserver(tag);
    stopped->SetAbortExecute(0);
    stopped->Modified();
    stopped->Update();
    CHECK(IsSame(stopped->GetOutput()->GetCellData(), filter->GetOutput()->GetCellData()));
  }
}

/// A composite input is computed block by block.
void TestComposite()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Field(PolyMeshes::Pebble(2), 4));
  blocks->SetBlock(2, Field(PolyMeshes::QuadTorus(20, 10), 2));
  vtkNew<vtkDirectionFieldGlyphs> filter;
  filter->SetInputDataObject(blocks);
  filter->Update();
  auto output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  REQUIRE(output && output->GetNumberOfBlocks() == 3);
  for (const unsigned int block : { 0u, 2u })
  {
    auto glyphs = vtkPolyData::SafeDownCast(output->GetBlock(block));
    REQUIRE(glyphs);
    CHECK(FieldValue(glyphs, "NumberOfGlyphs") > 425);
  }
}
}

int TestDirectionFieldGlyphsPipeline(int, char*[])
{
  TestParameters();
  TestErrors();
  TestEmpty();
  TestNotFinite();
  TestGhosts();
  TestRepetition();
  TestProgressAndAbort();
  TestComposite();
  return Result();
}
