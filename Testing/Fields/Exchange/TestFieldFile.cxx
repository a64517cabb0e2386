// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Exchange/CompanionFiles.h"
#include "Exchange/FieldFile.h"
#include "Exchange/TextReader.h"
#include "Exchange/TextWriter.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cstdio>
#include <random>
#include <sstream>
#include <string>

using namespace DirectionFields;

namespace
{
/// Rows of unit vectors without short decimals.
FieldFile RandomField(int degree, std::size_t rows)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  FieldFile field;
  field.Degree = degree;
  field.PerRow = degree;
  for (std::size_t i = 0; i < rows * static_cast<std::size_t>(degree); ++i)
  {
    field.Directions.push_back(
      Vector3(normal(random), normal(random), normal(random)).normalized());
  }
  return field;
}

/// The message of the error that a text gives.
std::string ErrorOf(const std::string& text, FieldFormat format)
{
  try
  {
    ReadField(text, format);
  }
  catch (const FileError& error)
  {
    return error.what();
  }
  return {};
}

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}
}

TEST(FieldFile, WhatIsWrittenIsReadBackToTheLastBit)
{
  for (const FieldFormat format :
    { FieldFormat::Rosy, FieldFormat::FrameField, FieldFormat::RawField })
  {
    const FieldFile written = RandomField(4, 50);
    const FieldFile read = ReadField(WriteField(written, format), format);
    EXPECT_EQ(read.Degree, 4);
    ASSERT_EQ(read.Rows(), 50U);
    EXPECT_EQ(read.PerRow,
      format == FieldFormat::Rosy           ? 1
        : format == FieldFormat::FrameField ? 2
                                            : 4);
    for (std::size_t row = 0; row < 50; ++row)
    {
      for (int k = 0; k < read.PerRow; ++k)
      {
        EXPECT_EQ(read.Direction(row, k), written.Direction(row, k));
      }
    }
  }
}

TEST(FieldFile, NumbersHaveAllTheirDigitsInAnyLocale)
{
  // Some machines have no locale with a decimal comma; there this shows less.
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  TextWriter text;
  text << 1.0 / 3.0 << " " << -1e-300 << " " << 5e-324 << " " << 0.1 + 0.2;
  EXPECT_EQ(text.Take(), "0.3333333333333333 -1e-300 5e-324 0.30000000000000004");
  double number = 0.0;
  EXPECT_TRUE(ToNumber("0.5", number));
  EXPECT_EQ(number, 0.5);
  EXPECT_FALSE(ToNumber("0,5", number));
  EXPECT_TRUE(ToNumber("+2", number));
  EXPECT_EQ(number, 2.0);
  EXPECT_FALSE(ToNumber("+-2", number));
  EXPECT_TRUE(ToNumber("1e-999", number));
  EXPECT_EQ(number, 0.0);
  std::setlocale(LC_ALL, "C");
}

TEST(FieldFile, QuadWildReadsRosy)
{
  // As vcglib's ImporterFIELD::Load4ROSY reads.
  const FieldFile written = RandomField(4, 20);
  const std::string text = WriteField(written, FieldFormat::Rosy);
  int rows = 0;
  int symmetry = 0;
  int at = 0;
  int length = 0;
  ASSERT_EQ(std::sscanf(text.c_str(), "%d%n", &rows, &length), 1);
  at += length;
  ASSERT_EQ(std::sscanf(text.c_str() + at, "%d\n%n", &symmetry, &length), 1);
  at += length;
  EXPECT_EQ(rows, 20);
  EXPECT_EQ(symmetry, 4);
  for (std::size_t i = 0; i < 20; ++i)
  {
    float x = 0.0F;
    float y = 0.0F;
    float z = 0.0F;
    ASSERT_EQ(std::sscanf(text.c_str() + at, "%f %f %f \n%n", &x, &y, &z, &length), 3);
    at += length;
    EXPECT_LT((Vector3(x, y, z) - written.Direction(i, 0)).norm(), 1e-7);
  }
  EXPECT_EQ(static_cast<std::size_t>(at), text.size());
}

TEST(FieldFile, VcglibReadsFrameFields)
{
  // As vcglib's ImporterFIELD::LoadFFIELD reads.
  const FieldFile written = RandomField(4, 20);
  std::istringstream stream(WriteField(written, FieldFormat::FrameField));
  std::string word;
  std::string line;
  stream >> word;
  EXPECT_EQ(word[0], '#');
  std::getline(stream, line);
  int rows = -1;
  if (!(stream >> rows))
  {
    stream.clear();
    std::getline(stream, line);
    stream >> rows;
  }
  EXPECT_EQ(rows, 20);
  std::getline(stream, line);
  std::getline(stream, line);
  for (std::size_t i = 0; i < 20; ++i)
  {
    double a = 0.0;
    double b = 0.0;
    Vector3 v;
    Vector3 u;
    stream >> a >> b >> v.x() >> v.y() >> v.z() >> u.x() >> u.y() >> u.z();
    ASSERT_TRUE(stream.good());
    EXPECT_EQ(u, written.Direction(i, 0));
    EXPECT_EQ(v, written.Direction(i, 1));
  }
}

TEST(FieldFile, DirectionalReadsRawFieldsAndSingularities)
{
  // As Directional's read_raw_field and read_singularities read.
  const FieldFile written = RandomField(3, 20);
  std::istringstream stream(WriteField(written, FieldFormat::RawField));
  int degree = 0;
  int rows = 0;
  stream >> degree >> rows;
  EXPECT_EQ(degree, 3);
  ASSERT_EQ(rows, 20);
  for (const Vector3& direction : written.Directions)
  {
    Vector3 read;
    stream >> read.x() >> read.y() >> read.z();
    EXPECT_EQ(read, direction);
  }
  EXPECT_TRUE(stream.good());

  std::istringstream singular(WriteSingularities(4, { { 7, 1 }, { 12, -1 } }));
  int count = 0;
  singular >> degree >> count;
  EXPECT_EQ(degree, 4);
  ASSERT_EQ(count, 2);
  int element = 0;
  int index = 0;
  singular >> element >> index;
  EXPECT_EQ(element, 7);
  EXPECT_EQ(index, 1);
  singular >> element >> index;
  EXPECT_EQ(element, 12);
  EXPECT_EQ(index, -1);
}

TEST(FieldFile, QuadWildReadsSharpEdges)
{
  // As QuadWild's LoadSharpFeatures reads: with commas, as fscanf takes its formats.
  const std::vector<SharpEdge> edges = { { true, 3, 0 }, { false, 11, 2 }, { true, 140, 1 } };
  const std::string text = WriteSharp(edges);
  int rows = 0;
  int at = 0;
  ASSERT_EQ(std::sscanf(text.c_str(), "%d%n", &rows, &at), 1);
  ASSERT_EQ(rows, 3);
  for (const SharpEdge& edge : edges)
  {
    int type = -1;
    int face = -1;
    int corner = -1;
    int length = 0;
    ASSERT_EQ(std::sscanf(text.c_str() + at, "%d,%d,%d%n", &type, &face, &corner, &length), 3);
    at += length;
    EXPECT_EQ(type, edge.IsConvex ? 1 : 0);
    EXPECT_EQ(face, edge.Triangle);
    EXPECT_EQ(corner, edge.Corner);
  }
}

TEST(FieldFile, MeshesKeepTheirOrder)
{
  const Surface surface = Meshes::Potato(1);
  std::istringstream stream(WriteObj(surface));
  std::string line;
  std::getline(stream, line);
  EXPECT_EQ(line, ObjMark);
  for (const Vector3& point : surface.Points)
  {
    std::string word;
    Vector3 read;
    stream >> word >> read.x() >> read.y() >> read.z();
    ASSERT_EQ(word, "v");
    EXPECT_EQ(read, point);
  }
  for (const Triangle& triangle : surface.Triangles)
  {
    std::string word;
    Triangle read;
    stream >> word >> read[0] >> read[1] >> read[2];
    ASSERT_EQ(word, "f");
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_EQ(read[c] - 1, triangle[c]);
    }
  }
}

TEST(FieldFile, FieldgensCommentsAreTakenFromItsExplanation)
{
  const std::string text = "# out.obj\n# It also includes a field of the form\n#    degree n\n"
                           "#    field i x y z\n#field, which are associated with faces\n\n"
                           "v 0 0 0\nv 1 0 0\r\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/2 3/1/3 \n"
                           "#degree 4\n#field 1 1 0 0\n# field 3 0 1e0 0\n#singularity 1 1\n";
  const FieldFile field = ReadField(text, FieldFormat::ObjComments);
  EXPECT_EQ(field.Degree, 4);
  ASSERT_EQ(field.Rows(), 3U);
  EXPECT_EQ(field.Direction(0, 0), Vector3(1.0, 0.0, 0.0));
  EXPECT_EQ(field.Direction(1, 0), Vector3(0.0, 0.0, 0.0));
  EXPECT_EQ(field.Direction(2, 0), Vector3(0.0, 1.0, 0.0));
  EXPECT_EQ(field.Places[1], Vector3(1.0, 0.0, 0.0));
}

TEST(FieldFile, ErrorsNameTheLine)
{
  EXPECT_TRUE(Has(ErrorOf("", FieldFormat::Rosy), "Line 1"));
  EXPECT_TRUE(Has(ErrorOf("2\n4\n1 0 0\n1 0\n", FieldFormat::Rosy), "file ends"));
  EXPECT_TRUE(Has(ErrorOf("2\n4\n1 0 0\n1 x 0\n", FieldFormat::Rosy), "Line 4"));
  EXPECT_TRUE(Has(ErrorOf("2\n4\n1 0 0\n1 x 0\n", FieldFormat::Rosy), "\"x\""));
  EXPECT_TRUE(Has(ErrorOf("1\n4\n1 0 0\n1 0 0\n", FieldFormat::Rosy), "goes on"));
  EXPECT_TRUE(Has(ErrorOf("1\n99\n1 0 0\n", FieldFormat::Rosy), "1 to 16"));
  EXPECT_TRUE(Has(ErrorOf("1\n4\nnan 0 0\n", FieldFormat::Rosy), "Line 3"));
  EXPECT_TRUE(Has(ErrorOf("1\n4\n1e999 0 0\n", FieldFormat::Rosy), "Line 3"));
  EXPECT_TRUE(Has(ErrorOf("-1\n4\n", FieldFormat::Rosy), "number of rows"));
  EXPECT_TRUE(Has(ErrorOf("700000000\n4\n1 0 0\n", FieldFormat::Rosy), "file ends"));
  EXPECT_TRUE(Has(ErrorOf("9999999999999999999\n4\n1 0 0\n", FieldFormat::Rosy), "Line 1"));
  EXPECT_TRUE(Has(ErrorOf("hello\n", FieldFormat::FrameField), "comment"));
  EXPECT_TRUE(Has(ErrorOf("# c\nsomething\n", FieldFormat::FrameField), "Line 2"));
  EXPECT_TRUE(
    Has(ErrorOf("# c\ntarget frame\n1\nk1 k2\n1 1 0 0 1 0 0\n", FieldFormat::FrameField), "ends"));
  EXPECT_TRUE(Has(ErrorOf("4 1\n1 0 0 0 1 0 -1 0 0\n", FieldFormat::RawField), "ends"));
  EXPECT_TRUE(Has(ErrorOf("v 0 0 0\n", FieldFormat::ObjComments), "#field i x y z"));
  EXPECT_TRUE(Has(ErrorOf("v 0 0 0\n#field 1 1 0 0\n", FieldFormat::ObjComments), "#degree n"));
  EXPECT_TRUE(Has(ErrorOf("v 0 0 0\n#field 2 1 0 0\n", FieldFormat::ObjComments), "Line 2"));
  EXPECT_TRUE(Has(ErrorOf("v 0 0 0\nv 1 1 1\n#field 1 1 0\n3 4\n", FieldFormat::ObjComments),
    "three coordinates"));
  EXPECT_TRUE(Has(ErrorOf("4 0\n", FieldFormat::Singularities), ".rawfield"));
  EXPECT_THROW(WriteField(RandomField(2, 3), FieldFormat::FrameField), FileError);
}

TEST(FieldFile, FormatsFollowTheEndOfTheName)
{
  EXPECT_EQ(FormatOf("a.rosy"), FieldFormat::Rosy);
  EXPECT_EQ(FormatOf("/b/a.b.RawField"), FieldFormat::RawField);
  EXPECT_EQ(FormatOf("a.ffield"), FieldFormat::FrameField);
  EXPECT_EQ(FormatOf("a.sing"), FieldFormat::Singularities);
  EXPECT_EQ(FormatOf("a.obj"), FieldFormat::ObjComments);
  EXPECT_THROW(FormatOf("a.ply"), FileError);
  EXPECT_THROW(FormatOf(".rosy"), FileError);
}
