// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Inputs that the remesher cannot do as they are: each is an error or a warning that names the
// cause and what to do, or gives the right mesh without a word.

#include "Checks.h"
#include "Meshes/PolyData.h"
#include "Meshes/Surfaces.h"

#include "vtkFieldAlignedRemesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace Checks;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
using Place = std::array<double, 3>;
using Rows = std::vector<std::vector<Place>>;

/// A square of side 1 in 288 triangles, in the plane z = 0, and the filter that remeshes it.
struct Run
{
  Run()
    : Square(Meshes::ToPolyData(Meshes::Square(12)))
  {
    this->Filter->SetInputData(this->Square);
    this->Filter->SetNumberOfFaces(100);
  }

  /// Gives values to cells by their middles.
  template <typename ArrayT = vtkIntArray>
  void Regions(const std::function<double(double, double)>& value, vtkIdType more = 0)
  {
    vtkNew<ArrayT> array;
    array->SetName("Region");
    for (vtkIdType c = 0; c < this->Square->GetNumberOfCells() + more; ++c)
    {
      Place middle{};
      for (int k = 0; c < this->Square->GetNumberOfCells() && k < 3; ++k)
      {
        const double* const p = this->Square->GetPoint(this->Square->GetCell(c)->GetPointId(k));
        middle[0] += p[0] / 3.0;
        middle[1] += p[1] / 3.0;
      }
      array->InsertNextValue(value(middle[0], middle[1]));
    }
    this->Square->GetCellData()->AddArray(array);
    this->Filter->SetRegionArray("Region");
  }

  /// Gives a size to each point but the seventh, which gets another.
  void Sizes(int mode, double usual, double seventh, int components = 1, vtkIdType more = 0)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName("Size");
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(this->Square->GetNumberOfPoints() + more);
    array->Fill(usual);
    array->SetComponent(7, 0, seventh);
    this->Square->GetPointData()->AddArray(array);
    this->Filter->SetSizingArray("Size");
    this->Filter->SetSizeMode(mode);
  }

  /// Gives curves, and points for rows of one if asked for.
  void Curves(const Rows& rows, bool arePoints = false)
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    for (const std::vector<Place>& row : rows)
    {
      std::vector<vtkIdType> ids;
      for (const Place& place : row)
      {
        ids.push_back(points->InsertNextPoint(place.data()));
      }
      cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    }
    this->Kept->SetPoints(points);
    arePoints ? this->Kept->SetVerts(cells) : this->Kept->SetLines(cells);
    this->Filter->SetCurvesData(this->Kept);
  }

  vtkSmartPointer<vtkPolyData> Square;
  vtkNew<vtkPolyData> Kept;
  vtkNew<vtkFieldAlignedRemesh> Filter;
};

enum class Outcome
{
  Error,
  Warning,
  Right
};

struct Case
{
  const char* Name;
  std::function<void(Run&)> Make;
  Outcome Is;
  /// All in one message: the cause, and what to do.
  std::vector<const char*> Words;
};

constexpr int Lengths = vtkFieldAlignedRemesh::LENGTHS_AT_POINTS;
constexpr int Relative = vtkFieldAlignedRemesh::FACES;

double Half(double x, double)
{
  return x > 0.5 ? 1.0 : 0.0;
}

std::vector<Case> RegionCases()
{
  return {
    { "missing", [](Run& r) { r.Filter->SetRegionArray("Nope"); }, Outcome::Error,
      { "no cell array \"Nope\"", "Choose another" } },
    { "too short", [](Run& r) { r.Regions(Half, -5); }, Outcome::Error,
      { "283 tuples", "288 cells", "one for each" } },
    { "real numbers", [](Run& r) { r.Regions<vtkDoubleArray>([](double x, double) { return x; }); },
      Outcome::Error, { "no whole number", "Calculator" } },
    { "NaN", [](Run& r) { r.Regions<vtkDoubleArray>([](double, double) { return NaN; }); },
      Outcome::Error, { "no whole number", "cell 0" } },
    { "one each",
      [](Run& r) {
        r.Regions(
          [](double x, double y) { return std::floor(1e3 * x) + 1e4 * std::floor(1e3 * y); });
      },
      Outcome::Error, { "numbers cells, not regions", "Choose another" } },
    { "whole reals", [](Run& r) { r.Regions<vtkDoubleArray>(Half); }, Outcome::Right, {} },
    { "negative", [](Run& r) { r.Regions([](double x, double y) { return Half(x, y) - 7.0; }); },
      Outcome::Right, {} },
    { "one triangle",
      [](Run& r) {
        r.Regions([](double x, double y) { return std::hypot(x - 0.47, y - 0.53) < 0.03 ? 1 : 0; });
      },
      Outcome::Warning, { "Region 1 has no faces", "More faces, or shorter edges" } },
    { "thinner than a face",
      [](Run& r)
      {
        r.Filter->SetNumberOfFaces(25);
        r.Regions([](double x, double) { return x > 0.5 && x < 0.58 ? 1 : 0; });
      },
      Outcome::Right, {} },
  };
}

std::vector<Case> SizeCases()
{
  return {
    { "missing", [](Run& r) { r.Filter->SetSizingArray("Nope"); }, Outcome::Error,
      { "no point array \"Nope\"", "Choose another" } },
    { "too short", [](Run& r) { r.Sizes(Relative, 1.0, 1.0, 1, -3); }, Outcome::Error,
      { "166 tuples", "169 points" } },
    { "vectors", [](Run& r) { r.Sizes(Relative, 1.0, 1.0, 3); }, Outcome::Error,
      { "of 1 component", "Choose another" } },
    { "length 0", [](Run& r) { r.Sizes(Lengths, 0.1, 0.0); }, Outcome::Error,
      { "at point 7 is 0", "above 0" } },
    { "length -1", [](Run& r) { r.Sizes(Lengths, 0.1, -1.0); }, Outcome::Error,
      { "at point 7 is -1", "above 0" } },
    { "length NaN", [](Run& r) { r.Sizes(Lengths, 0.1, NaN); }, Outcome::Error,
      { "at point 7 is no number", "finite and above 0" } },
    { "length infinite", [](Run& r) { r.Sizes(Lengths, 0.1, Infinity); }, Outcome::Error,
      { "at point 7 is inf", "finite and above 0" } },
    { "lengths that no mesh reaches", [](Run& r) { r.Sizes(Lengths, 1e-5, 1e-5); }, Outcome::Error,
      { "need about 1e+10 faces", "100 million", "are 10 times as large" } },
    { "lengths whose squares are 0", [](Run& r) { r.Sizes(Lengths, 1e-200, 1e-200); },
      Outcome::Error, { "need too many faces", "are 1e+196 times as large" } },
    { "few lengths that no mesh reaches", [](Run& r) { r.Sizes(Lengths, 0.1, 1e-6); },
      Outcome::Error, { "1e-06 at the shortest", "100 million", "not refused" } },
    { "an edge length that no mesh reaches",
      [](Run& r)
      {
        r.Filter->SetSizeMode(vtkFieldAlignedRemesh::EDGE_LENGTH);
        r.Filter->SetEdgeLength(1e-6);
      },
      Outcome::Error, { "1e-06 needs about 1e+12 faces", "Lengths of 0.0001 and more" } },
    { "lengths far above the square", [](Run& r) { r.Sizes(Lengths, 10.0, 10.0); }, Outcome::Error,
      { "10 at the shortest", "longer than the whole surface, which is 1.41",
        "room for 24 faces" } },
    { "an edge length far above the square",
      [](Run& r)
      {
        r.Filter->SetSizeMode(vtkFieldAlignedRemesh::EDGE_LENGTH);
        r.Filter->SetEdgeLength(10.0);
      },
      Outcome::Error, { "10 is longer than the whole surface", "One of 0.204 leaves room" } },
    { "relative 0", [](Run& r) { r.Sizes(Relative, 0.0, 0.0); }, Outcome::Warning,
      { "At 169 points", "no positive number", "count as 1" } },
    { "one relative -1", [](Run& r) { r.Sizes(Relative, 1.0, -1.0); }, Outcome::Warning,
      { "At 1 point", "no positive number", "count as 1" } },
    { "one relative NaN", [](Run& r) { r.Sizes(Relative, 1.0, NaN); }, Outcome::Warning,
      { "At 1 point", "no positive number", "count as 1" } },
    { "relative 100", [](Run& r) { r.Sizes(Relative, 1.0, 100.0); }, Outcome::Warning,
      { "from 1/8 to 8 only", "at 1 point" } },
    { "second derivatives of NaN",
      [](Run& r)
      {
        r.Sizes(Relative, 1.0, NaN);
        r.Filter->SetSizeSource(vtkFieldAlignedRemesh::SECOND_DERIVATIVES);
      },
      Outcome::Error, { "at point 7 is NaN", "have to be finite" } },
    { "second derivatives of nothing",
      [](Run& r) { r.Filter->SetSizeSource(vtkFieldAlignedRemesh::SECOND_DERIVATIVES); },
      Outcome::Error, { "is missing", "Choose it as Sizing Array" } },
    { "lengths without an array", [](Run& r) { r.Filter->SetSizeMode(Lengths); }, Outcome::Error,
      { "there are none", "Choose a Sizing Array" } },
    { "gradation below 1",
      [](Run& r)
      {
        r.Sizes(Lengths, 0.1, 0.1);
        r.Filter->SetGradation(0.5);
      },
      Outcome::Error, { "Gradation has to be above 1" } },
    { "an edge length of 0",
      [](Run& r)
      {
        r.Filter->SetSizeMode(vtkFieldAlignedRemesh::EDGE_LENGTH);
        r.Filter->SetEdgeLength(0.0);
      },
      Outcome::Error, { "Edge Length has to be a positive number" } },
    { "a limit of NaN", [](Run& r) { r.Filter->SetMinimumScaledJacobian(NaN); }, Outcome::Error,
      { "Minimum Scaled Jacobian has to be between 0 and 1" } },
  };
}

std::vector<Case> CurveCases()
{
  return {
    { "far away",
      [](Run& r) {
        r.Curves({ { { 0.2, 0.5, 3.0 }, { 0.8, 0.5, 3.0 } } });
      },
      Outcome::Warning, { "Parts of curve 0", "have to lie on it" } },
    { "over the rim",
      [](Run& r) {
        r.Curves({ { { 0.2, 0.5, 0.0 }, { 1.8, 0.5, 0.0 } } });
      },
      Outcome::Warning, { "Parts of curve 0", "have to lie on it" } },
    { "of one point",
      [](Run& r) {
        r.Curves({ { { 0.4, 0.5, 0.0 } } });
      },
      Outcome::Warning, { "Curve 0 has no length", "vertex cell" } },
    { "of points at one place",
      [](Run& r)
      {
        r.Curves(
          { { { 0.1, 0.5, 0.0 }, { 0.9, 0.5, 0.0 } }, { { 0.4, 0.3, 0.0 }, { 0.4, 0.3, 0.0 } } });
      },
      Outcome::Warning, { "Curve 1 has no length", "vertex cell" } },
    { "much shorter than an edge",
      [](Run& r) {
        r.Curves({ { { 0.43, 0.53, 0.0 }, { 0.445, 0.53, 0.0 } } });
      },
      Outcome::Right, {} },
    { "NaN",
      [](Run& r) {
        r.Curves({ { { 0.1, 0.5, 0.0 }, { NaN, 0.5, 0.0 } } });
      },
      Outcome::Error, { "Point 1 of the second input", "Remove it" } },
    { "none", [](Run& r) { r.Curves({}); }, Outcome::Right, {} },
    { "faces alone", [](Run& r) { r.Filter->SetCurvesData(r.Square); }, Outcome::Warning,
      { "Kept Curves has faces alone", "Feature Edges or Slice" } },
    { "along the boundary",
      [](Run& r) {
        r.Curves({ { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } } });
      },
      Outcome::Right, {} },
    { "points at one place",
      [](Run& r) {
        r.Curves({ { { 0.4, 0.5, 0.0 } }, { { 0.4, 0.5, 0.0 } } }, true);
      },
      Outcome::Warning, { "Point 1 is no vertex", "stand for the same places" } },
    { "points closer than a tenth of an edge",
      [](Run& r) {
        r.Curves({ { { 0.4, 0.5, 0.0 } }, { { 0.405, 0.5, 0.0 } } }, true);
      },
      Outcome::Warning, { "Point 1 is no vertex", "Shorter edges there" } },
    { "points off the surface",
      [](Run& r) {
        r.Curves({ { { 0.4, 0.5, 0.0 } }, { { 0.4, 0.5, 1.0 } } }, true);
      },
      Outcome::Warning, { "Point 1 is no vertex", "have to lie on it" } },
    { "a point at a corner",
      [](Run& r) {
        r.Curves({ { { 1.0, 1.0, 0.0 } } }, true);
      },
      Outcome::Right, {} },
  };
}

bool HasAll(const std::string& message, const std::vector<const char*>& words)
{
  return std::all_of(words.begin(), words.end(),
    [&](const char* text) { return message.find(text) != std::string::npos; });
}

void TestEach(const char* what, const std::vector<Case>& cases)
{
  for (const Case& one : cases)
  {
    Run run;
    one.Make(run);
    vtkNew<Messages> messages;
    messages->Observe(run.Filter);
    run.Filter->Update();
    const int before = Failures();
    const bool isError = one.Is == Outcome::Error;
    CHECK(isError == (messages->Errors.size() == 1));
    CHECK(isError == (run.Filter->GetOutput()->GetNumberOfCells() == 0));
    const std::vector<std::string>& told = isError ? messages->Errors : messages->Warnings;
    CHECK(one.Is == Outcome::Right
        ? told.empty()
        : std::any_of(told.begin(), told.end(),
            [&](const std::string& message) { return HasAll(message, one.Words); }));
    if (Failures() > before)
    {
      std::cerr << what << ", " << one.Name << ":" << std::endl;
      for (const std::string& message : told)
      {
        std::cerr << "  " << message << std::endl;
      }
    }
  }
}

/// Three sheets that meet in a line, each of a region of its own: the line is a border of all.
void TestThreeSheets()
{
  for (const bool isPure : { false, true })
  {
    DirectionFields::Surface sheets;
    std::vector<int> regions;
    constexpr int cells = 10;
    constexpr DirectionFields::Index perSheet = (cells + 1) * (cells + 1);
    for (int k = 0; k < 3; ++k)
    {
      const DirectionFields::Surface square = Meshes::Square(cells);
      for (const DirectionFields::Vector3& p : square.Points)
      {
        const double angle = 2.0 * DirectionFields::Pi * k / 3.0;
        sheets.Points.emplace_back(p[0] * std::cos(angle), p[1], p[0] * std::sin(angle));
      }
      for (DirectionFields::Triangle t : square.Triangles)
      {
        for (DirectionFields::Index& p : t)
        {
          // The points on the line are the first sheet's for all.
          p += square.Points[p][0] > 0.0 ? k * perSheet : 0;
        }
        sheets.Triangles.push_back(t);
        regions.push_back(k);
      }
    }
    Run run;
    run.Square = Meshes::ToPolyData(sheets);
    std::size_t next = 0;
    run.Regions([&](double, double) { return regions[next++]; });
    run.Filter->SetInputData(run.Square);
    run.Filter->SetNumberOfFaces(300);
    run.Filter->SetPureQuads(isPure);
    vtkNew<Messages> messages;
    messages->Observe(run.Filter);
    run.Filter->Update();
    CHECK(messages->IsEmpty());
    vtkFieldData* const figures = run.Filter->GetOutput()->GetFieldData();
    REQUIRE(figures->GetArray("Regions") != nullptr);
    CHECK(figures->GetArray("Regions")->GetTuple1(0) == 3.0);
    CHECK(figures->GetArray("RegionsLost")->GetTuple1(0) == 0.0);
    CHECK(figures->GetArray("BordersKept")->GetTuple1(0) > 1.0 - 1e-9);
    CHECK(figures->GetArray("TurnedFaces")->GetTuple1(0) == 0.0);
  }
}
}

int TestFieldAlignedRemeshInputs(int, char*[])
{
  TestEach("regions", RegionCases());
  TestEach("sizes", SizeCases());
  TestEach("curves", CurveCases());
  TestThreeSheets();
  return Result();
}
