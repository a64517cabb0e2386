// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files of another mesh that has as many elements.

#include "Exchange/FieldExport.h"
#include "Exchange/FieldImport.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
FieldFile FileOf(const Surface& surface, FieldOn on, int degree = 4)
{
  const Result result = Fields::Compute(surface, degree);
  const GivenField field(surface, Fields::Of(result));
  ExportOptions options;
  options.Format = FieldFormat::RawField;
  options.On = on;
  return ReadField(ExportField(field, nullptr, options)[0].Text, FieldFormat::RawField);
}

/// The warnings, or the error, that a file gives.
std::string SentencesOf(const FieldFile& file, const Surface& surface, FieldOn on)
{
  std::string sentences;
  try
  {
    for (const std::string& warning : ImportField(file, surface, on, true).Warnings)
    {
      sentences += "Warning: " + warning;
    }
  }
  catch (const FileError& error)
  {
    sentences = std::string("Error: ") + error.what();
  }
  return sentences;
}

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

Surface WithTrianglesInAnotherOrder(Surface surface)
{
  std::shuffle(surface.Triangles.begin(), surface.Triangles.end(), std::mt19937(5));
  return surface;
}
}

TEST(OtherMeshes, TrianglesInAnotherOrderAreNoticed)
{
  const Surface surface = Potato(3);
  const FieldFile file = FileOf(surface, FieldOn::Cells);
  EXPECT_EQ(SentencesOf(file, surface, FieldOn::Cells), "");
  const std::string sentences =
    SentencesOf(file, WithTrianglesInAnotherOrder(surface), FieldOn::Cells);
  EXPECT_TRUE(Has(sentences, "Error: ")) << sentences;
  EXPECT_TRUE(Has(sentences, "another mesh")) << sentences;
  // In a plane no direction stands out, but neighbours do not agree.
  const Surface flat = Disk(20);
  FieldFile circles;
  circles.Degree = 1;
  for (const Triangle& triangle : flat.Triangles)
  {
    circles.Directions.push_back(Vector3::UnitZ().cross(
      flat.Points[triangle[0]] + flat.Points[triangle[1]] + flat.Points[triangle[2]]));
  }
  EXPECT_EQ(SentencesOf(circles, flat, FieldOn::Cells), "");
  const std::string onFlat =
    SentencesOf(circles, WithTrianglesInAnotherOrder(flat), FieldOn::Cells);
  EXPECT_TRUE(Has(onFlat, "Warning: ") && Has(onFlat, "at random")) << onFlat;
}

TEST(OtherMeshes, MeshesThatWereTurnedAreNoticed)
{
  const Surface surface = Potato(3);
  const Surface turned = Transformed(
    surface, Eigen::Matrix3d(Eigen::AngleAxisd(Pi / 2.0, Vector3::UnitY())), Vector3::Zero());
  for (const FieldOn on : { FieldOn::Cells, FieldOn::Points })
  {
    const FieldFile file = FileOf(surface, on);
    EXPECT_EQ(SentencesOf(file, surface, on), "");
    const std::string sentences = SentencesOf(file, turned, on);
    EXPECT_TRUE(Has(sentences, "Error: ") && Has(sentences, "another mesh")) << sentences;
  }
}

TEST(OtherMeshes, DirectionsAtRandomAreNoticedOnPoints)
{
  const Surface flat = Square(12);
  FieldFile file = FileOf(flat, FieldOn::Points);
  EXPECT_EQ(SentencesOf(file, flat, FieldOn::Points), "");
  std::mt19937 random(3);
  for (std::size_t row = 0; row < file.Rows(); ++row)
  {
    const double angle = std::uniform_real_distribution<double>(0.0, 2.0 * Pi)(random);
    for (int k = 0; k < 4; ++k)
    {
      file.Directions[4 * row + static_cast<std::size_t>(k)] =
        Vector3(std::cos(angle + k * Pi / 2.0), std::sin(angle + k * Pi / 2.0), 0.0);
    }
  }
  const std::string sentences = SentencesOf(file, flat, FieldOn::Points);
  EXPECT_TRUE(Has(sentences, "Warning: ") && Has(sentences, "at random")) << sentences;
}

TEST(OtherMeshes, AFewRowsOutOfTheirPlanesAreAWarning)
{
  const Surface surface = Potato(3);
  FieldFile file = FileOf(surface, FieldOn::Cells);
  std::swap(file.Directions[0], file.Directions[file.Directions.size() / 2]);
  const std::string sentences = SentencesOf(file, surface, FieldOn::Cells);
  EXPECT_TRUE(Has(sentences, "Warning: ") && Has(sentences, "tangential parts")) << sentences;
  // Six digits, as of programs with single precision, are enough.
  FieldFile rounded = FileOf(surface, FieldOn::Cells);
  for (Vector3& direction : rounded.Directions)
  {
    direction = (direction * 1e6).array().round().matrix() * 1e-6;
  }
  EXPECT_EQ(SentencesOf(rounded, surface, FieldOn::Cells), "");
}

TEST(OtherMeshes, OtherNormalsOfTheSamePointsAreAccepted)
{
  // Tangents of one of the faces at a cube's edges, as a program has them that takes any normal.
  const Surface cube = FlatlySubdivided(Cube(), 4);
  FieldFile file = FileOf(cube, FieldOn::Points);
  for (const Triangle& triangle : cube.Triangles)
  {
    const Vector3 normal = (cube.Points[triangle[1]] - cube.Points[triangle[0]])
                             .cross(cube.Points[triangle[2]] - cube.Points[triangle[0]])
                             .normalized();
    for (const Index point : triangle)
    {
      for (std::size_t k = 0; k < 4; ++k)
      {
        Vector3& direction = file.Directions[4 * static_cast<std::size_t>(point) + k];
        direction -= normal.dot(direction) * normal;
      }
    }
  }
  EXPECT_FALSE(Has(SentencesOf(file, cube, FieldOn::Points), "another mesh"));
}

TEST(OtherMeshes, PartsWithoutAnyDirectionAreAnError)
{
  const Surface surface = Joined(Potato(2), Icosphere(1));
  for (const FieldOn on : { FieldOn::Cells, FieldOn::Points })
  {
    FieldFile file = FileOf(surface, on);
    const std::size_t first =
      4 * (on == FieldOn::Cells ? Potato(2).Triangles.size() : Potato(2).Points.size());
    std::fill(file.Directions.begin() + static_cast<std::ptrdiff_t>(first), file.Directions.end(),
      Vector3(Vector3::Zero()));
    const std::string sentences = SentencesOf(file, surface, on);
    EXPECT_TRUE(Has(sentences, "Error: ") && Has(sentences, "42 points")) << sentences;
    std::fill(file.Directions.begin(), file.Directions.end(), Vector3(Vector3::Zero()));
    EXPECT_TRUE(Has(SentencesOf(file, surface, on), "Error: "));
  }
  // The normals themselves.
  FieldFile normals;
  normals.Degree = 4;
  const Surface sphere = Icosphere(2);
  normals.Directions = sphere.Points;
  EXPECT_TRUE(Has(SentencesOf(normals, sphere, FieldOn::Points), "Error: "));
}
