// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Exchange/FieldExport.h"
#include "Exchange/FieldImport.h"
#include "Exchange/SharpEdges.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
std::string TextOf(const std::vector<ExportedFile>& files, const std::string& ending)
{
  for (const ExportedFile& file : files)
  {
    if (file.Ending == ending)
    {
      return file.Text;
    }
  }
  return {};
}

/// The mesh of an .obj text.
Surface MeshOf(const std::string& text)
{
  Surface surface;
  std::istringstream stream(text);
  std::string line;
  while (std::getline(stream, line))
  {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v")
    {
      Vector3 p;
      words >> p.x() >> p.y() >> p.z();
      surface.Points.push_back(p);
    }
    else if (word == "f")
    {
      Triangle t;
      words >> t[0] >> t[1] >> t[2];
      surface.Triangles.push_back({ t[0] - 1, t[1] - 1, t[2] - 1 });
    }
  }
  return surface;
}

/// The largest angle between the directions of two fields at a point, in degrees; of those far from singularities.
double LargestDeviation(const Result& one, const Result& other, double leastMagnitude)
{
  double worst = 0.0;
  for (std::size_t i = 0; i < one.Representation.size(); ++i)
  {
    if (std::abs(one.Representation[i]) > leastMagnitude)
    {
      worst = std::max(
        worst, Deviation(other, static_cast<Index>(i), one.Direction(static_cast<Index>(i), 0)));
    }
  }
  return worst;
}
}

TEST(Exchange, FieldsOnPointsComeBackAsTheyWere)
{
  for (const Surface& surface : { Potato(3), MoebiusStrip(40, 3), Torus(24, 12) })
  {
    for (const int degree : { 1, 2, 4, 6 })
    {
      const Result result = Fields::Compute(surface, degree);
      const GivenField field(surface, Fields::Of(result));
      ExportOptions options;
      options.Format = FieldFormat::RawField;
      options.On = FieldOn::Points;
      const std::vector<ExportedFile> files = ExportField(field, nullptr, options);
      const Surface mesh = MeshOf(TextOf(files, ".obj"));
      EXPECT_EQ(mesh.Points, surface.Points);
      EXPECT_EQ(mesh.Triangles, surface.Triangles);
      const FieldFile file = ReadField(TextOf(files, ".rawfield"), FieldFormat::RawField);
      const ImportedField back = ImportField(file, mesh, FieldOn::Points, true);
      EXPECT_TRUE(back.Warnings.empty());
      // arc cosines near 1 have half of the digits.
      EXPECT_LT(LargestDeviation(result, back.Field, 0.0), 1e-5);
      EXPECT_EQ(back.Field.SingularityIndex, result.SingularityIndex);
      EXPECT_EQ(back.Field.Components[0].IndexSum, result.Components[0].IndexSum);
      EXPECT_EQ(
        back.Field.Components[0].EulerCharacteristic, result.Components[0].EulerCharacteristic);
    }
  }
}

TEST(Exchange, FieldsOnTrianglesComeBackNearly)
{
  const Surface surface = Potato(4);
  for (const int degree : { 1, 2, 4, 6 })
  {
    const Result result = Fields::Compute(surface, degree);
    const GivenField field(surface, Fields::Of(result));
    ExportOptions options;
    options.Format = FieldFormat::Rosy;
    const std::vector<ExportedFile> files = ExportField(field, nullptr, options);
    const FieldFile file = ReadField(TextOf(files, ".rosy"), FieldFormat::Rosy);
    EXPECT_EQ(file.Rows(), surface.Triangles.size());
    const ImportedField back = ImportField(file, surface, FieldOn::Automatic, true);
    EXPECT_LT(LargestDeviation(result, back.Field, 0.5), 2.0);
    EXPECT_EQ(back.Field.Components[0].IndexSum, 2 * degree);
    EXPECT_EQ(
      std::accumulate(back.Field.SingularityIndex.begin(), back.Field.SingularityIndex.end(), 0),
      2 * degree);
  }
}

TEST(Exchange, RowsGoCounterClockwiseAroundTheirTriangles)
{
  // Every other triangle is wound the other way around.
  Surface surface = Potato(2);
  for (std::size_t t = 0; t < surface.Triangles.size(); t += 3)
  {
    std::swap(surface.Triangles[t][1], surface.Triangles[t][2]);
  }
  const Result result = Fields::Compute(surface, 3);
  const GivenField field(surface, Fields::Of(result));
  ExportOptions options;
  options.Format = FieldFormat::RawField;
  const std::vector<ExportedFile> files = ExportField(field, nullptr, options);
  const FieldFile file = ReadField(TextOf(files, ".rawfield"), FieldFormat::RawField);
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Triangle& triangle = surface.Triangles[t];
    const Vector3 normal = (surface.Points[triangle[1]] - surface.Points[triangle[0]])
                             .cross(surface.Points[triangle[2]] - surface.Points[triangle[0]])
                             .normalized();
    for (int k = 0; k < 3; ++k)
    {
      const double sine = normal.dot(file.Direction(t, k).cross(file.Direction(t, (k + 1) % 3)));
      EXPECT_NEAR(sine, std::sin(2.0 * Pi / 3.0), 1e-12);
    }
  }
  // The singularities of the .sing file add up.
  std::istringstream stream(TextOf(files, ".sing"));
  int degree = 0;
  int count = 0;
  int sum = 0;
  stream >> degree >> count;
  for (int i = 0; i < count; ++i)
  {
    int vertex = -1;
    int index = 0;
    stream >> vertex >> index;
    EXPECT_GE(vertex, 0);
    EXPECT_LT(vertex, static_cast<int>(surface.Points.size()));
    sum += index;
  }
  EXPECT_EQ(degree, 3);
  EXPECT_EQ(sum, 6);
}

TEST(Exchange, PointsAcrossSeamsAreWrittenOnce)
{
  const Surface surface = Soup(Potato(2));
  Options computed;
  computed.MergePoints = MergePoints::Automatic;
  const Result result = DirectionField(surface).Compute(computed);
  const GivenField field(surface, Fields::Of(result));
  const std::vector<ExportedFile> files = ExportField(field, nullptr, {});
  const Surface mesh = MeshOf(TextOf(files, ".obj"));
  EXPECT_EQ(mesh.Points.size(), Potato(2).Points.size());
  EXPECT_EQ(mesh.Triangles.size(), surface.Triangles.size());
  // Directions that are read belong to the facets as well.
  const FieldFile file = ReadField(TextOf(files, ".rosy"), FieldFormat::Rosy);
  const ImportedField onFacets = ImportField(file, surface, FieldOn::Automatic, true);
  EXPECT_EQ(onFacets.Field.Representation.size(), surface.Points.size());
  EXPECT_EQ(onFacets.Field.Components.size(), 1U);
  EXPECT_EQ(onFacets.Field.Components[0].IndexSum, 8);
}

TEST(Exchange, SharpEdgesAreThoseOfTheCube)
{
  const Surface cube = FlatlySubdivided(Cube(), 2);
  const std::vector<SharpEdge> edges = FindSharpEdges(cube, 30.0, 0.1);
  // Twelve edges in four parts, from both sides.
  EXPECT_EQ(edges.size(), 96U);
  for (const SharpEdge& edge : edges)
  {
    EXPECT_TRUE(edge.IsConvex);
    const Vector3& a = cube.Points[cube.Triangles[edge.Triangle][edge.Corner]];
    const Vector3& b = cube.Points[cube.Triangles[edge.Triangle][(edge.Corner + 1) % 3]];
    int atRim = 0;
    for (int c = 0; c < 3; ++c)
    {
      atRim += a[c] == b[c] &&
        (std::abs(a[c]) < 1e-12 || std::abs(std::abs(a[c]) - 1.0) < 1e-12 ||
          std::abs(std::abs(a[c]) - 0.5) < 1e-12);
    }
    EXPECT_GE(atRim, 2);
  }
  // Bent the other way, the edge between two squares is concave; the rim is convex.
  const std::vector<SharpEdge> folded = FindSharpEdges(Folded(Square(4), 1.0), 30.0, 0.1);
  const std::vector<SharpEdge> other = FindSharpEdges(Folded(Square(4), -1.0), 30.0, 0.1);
  const auto concave = [](const SharpEdge& edge) { return !edge.IsConvex; };
  EXPECT_EQ(folded.size(), 16U + 8U);
  EXPECT_EQ(other.size(), 16U + 8U);
  EXPECT_EQ(std::count_if(folded.begin(), folded.end(), concave) +
      std::count_if(other.begin(), other.end(), concave),
    8);
}

TEST(Exchange, DirectionsOfVerticesAreFoundByTheirPlaces)
{
  // Each corner of a triangle has a point of its own, as a reader makes it of a file with texture coordinates.
  const Surface surface = Potato(2);
  const Result result = Fields::Compute(surface, 4);
  FieldFile file;
  file.Degree = 4;
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    file.Directions.push_back(result.Direction(static_cast<Index>(i), 0));
    file.Places.push_back(surface.Points[i]);
  }
  Surface soup = Soup(surface);
  for (Vector3& point : soup.Points)
  {
    point = point.cast<float>().cast<double>();
  }
  const ImportedField back = ImportField(file, soup, FieldOn::Automatic, true);
  EXPECT_EQ(back.Field.SingularityIndex, result.SingularityIndex);
  EXPECT_TRUE(back.Warnings.empty());
  for (Vector3& point : soup.Points)
  {
    point += Vector3(10.0, 0.0, 0.0);
  }
  EXPECT_THROW(ImportField(file, soup, FieldOn::Automatic, true), FileError);
}

TEST(Exchange, WhatTheFileLacksIsSaid)
{
  const Surface surface = Potato(2);
  const Result result = Fields::Compute(surface, 4);
  FieldFile file;
  file.Degree = 4;
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    file.Directions.push_back(
      i == 7 ? Vector3(Vector3::Zero()) : result.Direction(static_cast<Index>(i), 0));
  }
  const ImportedField holes = ImportField(file, surface, FieldOn::Automatic, true);
  ASSERT_EQ(holes.Warnings.size(), 1U);
  EXPECT_NE(holes.Warnings[0].find("1 points"), std::string::npos);
  EXPECT_EQ(holes.Field.Components[0].IndexSum, 8);

  file.Directions.pop_back();
  EXPECT_THROW(ImportField(file, surface, FieldOn::Automatic, true), FileError);
  EXPECT_THROW(ImportField(file, surface, FieldOn::Cells, true), FileError);
  EXPECT_THROW(ImportField(file, surface, FieldOn::Points, true), FileError);

  // Two families of lines that meet at 60 degrees are no crosses.
  const GivenField field(surface, Fields::Of(result));
  FieldFile skew = ReadField(
    ExportField(field, nullptr, { FieldFormat::RawField })[0].Text, FieldFormat::RawField);
  for (std::size_t row = 0; row < skew.Rows(); ++row)
  {
    const Vector3 x = skew.Direction(row, 0);
    const Vector3 y = skew.Direction(row, 1);
    skew.Directions[4 * row + 1] = 0.5 * x + std::sqrt(0.75) * y;
    skew.Directions[4 * row + 3] = -skew.Directions[4 * row + 1];
  }
  const ImportedField frames = ImportField(skew, surface, FieldOn::Automatic, true);
  ASSERT_EQ(frames.Warnings.size(), 1U);
  EXPECT_NE(frames.Warnings[0].find("equal angles"), std::string::npos);
  EXPECT_EQ(frames.Field.Components[0].IndexSum, 8);
}

TEST(Exchange, DirtyMeshesGiveFieldsAllTheSame)
{
  Surface fins = Potato(2);
  // Two more triangles at an edge, one of them there twice, and one without area.
  fins.Points.emplace_back(2.0, 2.0, 2.0);
  const Triangle first = fins.Triangles[0];
  const auto tip = static_cast<Index>(fins.Points.size()) - 1;
  fins.Triangles.push_back({ first[0], first[1], tip });
  fins.Triangles.push_back({ first[0], first[1], tip });
  fins.Triangles.push_back({ first[2], first[2], tip });
  for (const Surface& surface : { fins, BadSphere(3, 0.4, 5), Scrambled(Potato(2), 3), LShape(6),
         PlateWithHole(24, 6, 0.5, true), Joined(MoebiusStrip(30, 2), Potato(1)) })
  {
    for (const int degree : { 1, 4 })
    {
      const Result result = Fields::Compute(surface, degree);
      const GivenField field(surface, Fields::Of(result));
      for (const FieldOn on : { FieldOn::Cells, FieldOn::Points })
      {
        const std::vector<ExportedFile> files =
          ExportField(field, nullptr, { FieldFormat::RawField, on });
        const FieldFile file = ReadField(files[0].Text, FieldFormat::RawField);
        const Surface mesh = MeshOf(TextOf(files, ".obj"));
        EXPECT_EQ(mesh.Triangles, surface.Triangles);
        const ImportedField back = ImportField(file, mesh, on, true);
        for (std::size_t i = 0; i < back.Field.Representation.size(); ++i)
        {
          EXPECT_TRUE(std::isfinite(std::abs(back.Field.Representation[i])));
        }
        for (const ComponentReport& component : back.Field.Components)
        {
          if (component.Closed)
          {
            EXPECT_EQ(component.IndexSum, degree * component.EulerCharacteristic);
          }
        }
      }
    }
  }
}

TEST(Exchange, AnyNumberOfThreadsWritesTheSameBytes)
{
  const Surface surface = Potato(5);
  const Result result = Fields::Compute(surface, 4);
  std::vector<std::string> texts;
  for (const int number : { 1, 3 })
  {
    Threads threads(number);
    const Threads::Scope scope(threads);
    const GivenField field(surface, Fields::Of(result));
    const std::vector<ExportedFile> files = ExportField(field, nullptr, { FieldFormat::RawField });
    const ImportedField back = ImportField(
      ReadField(files[0].Text, FieldFormat::RawField), surface, FieldOn::Automatic, true);
    texts.push_back(files[0].Text + TextOf(files, ".sing"));
    for (const Complex& u : back.Field.Representation)
    {
      texts.back() += std::to_string(u.real()) + std::to_string(u.imag());
    }
  }
  EXPECT_EQ(texts[0], texts[1]);
}

TEST(Exchange, AnEmptySurfaceIsRefused)
{
  const Surface nothing;
  PointDirections none;
  none.Degree = 4;
  none.Direction = [](Index, int) { return Vector3(Vector3::Zero()); };
  none.Magnitude = [](Index) { return 0.0; };
  const GivenField field(nothing, none);
  EXPECT_THROW(ExportField(field, nullptr, {}), FileError);
}
