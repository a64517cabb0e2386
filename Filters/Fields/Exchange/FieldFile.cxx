// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Exchange/FieldFile.h"

#include "Exchange/TextFile.h"
#include "Exchange/TextReader.h"
#include "Exchange/TextWriter.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <utility>

namespace DirectionFields
{
namespace
{
constexpr Index MostRows = std::numeric_limits<Index>::max() / 3;

struct Ending
{
  std::string_view Name;
  FieldFormat Format;
};
constexpr std::array<Ending, 5> Endings = { { { ".rosy", FieldFormat::Rosy },
  { ".ffield", FieldFormat::FrameField }, { ".rawfield", FieldFormat::RawField },
  { ".sing", FieldFormat::Singularities }, { ".obj", FieldFormat::ObjComments } } };

std::size_t ReadRowCount(TextReader& reader)
{
  return static_cast<std::size_t>(reader.Integer("the number of rows", 0, MostRows));
}

int ReadDegree(TextReader& reader)
{
  return static_cast<int>(reader.Integer("the number of directions at a point", 1, LargestDegree));
}

Vector3 ReadVector(TextReader& reader)
{
  const double x = reader.Number("a coordinate of a direction");
  const double y = reader.Number("a coordinate of a direction");
  const double z = reader.Number("a coordinate of a direction");
  return { x, y, z };
}

/// Makes room for rows, but no more than the text can hold.
void Reserve(FieldFile& field, std::size_t rows, std::string_view text)
{
  field.Directions.reserve(
    std::min(rows * static_cast<std::size_t>(field.PerRow), text.size() / 6 + 1));
}

void RequireEnd(TextReader& reader, std::size_t rows)
{
  if (!reader.IsAtEnd())
  {
    reader.Fail(
      "the file says that it has " + std::to_string(rows) + " rows, but goes on after them.");
  }
}

FieldFile ReadRosy(std::string_view text)
{
  TextReader reader(text);
  FieldFile field;
  const std::size_t rows = ReadRowCount(reader);
  field.Degree = ReadDegree(reader);
  Reserve(field, rows, text);
  for (std::size_t row = 0; row < rows; ++row)
  {
    field.Directions.push_back(ReadVector(reader));
  }
  RequireEnd(reader, rows);
  return field;
}

/// The number of rows of a .ffield file, which stands on the first line that begins with a number.
std::size_t ReadFrameFieldHead(TextReader& reader)
{
  if (reader.IsAtEnd())
  {
    reader.Fail("the file is empty.");
  }
  const std::string_view first = reader.Word();
  if (first.substr(0, 1) != "#")
  {
    reader.Fail("a .ffield file begins with a comment, #.");
  }
  reader.SkipLine();
  while (!reader.IsAtEnd())
  {
    const std::string_view word = reader.Word();
    std::int64_t rows = 0;
    if (ToInteger(word, rows))
    {
      if (rows < 0 || rows > MostRows)
      {
        reader.Fail("there cannot be " + std::to_string(rows) + " rows.");
      }
      reader.SkipLine();
      return static_cast<std::size_t>(rows);
    }
    if (word.substr(0, 1) != "#" && word != "target")
    {
      reader.Fail("\"target frame\" or the number of rows should stand here.");
    }
    reader.SkipLine();
  }
  reader.Fail("the file ends before the number of rows.");
}

FieldFile ReadFrameField(std::string_view text)
{
  TextReader reader(text);
  FieldFile field;
  field.Degree = 4;
  field.PerRow = 2;
  const std::size_t rows = ReadFrameFieldHead(reader);
  // The line of the columns' names.
  reader.SkipLine();
  Reserve(field, rows, text);
  for (std::size_t row = 0; row < rows; ++row)
  {
    reader.Number("a length");
    reader.Number("a length");
    // The second direction comes first.
    const Vector3 second = ReadVector(reader);
    field.Directions.push_back(ReadVector(reader));
    field.Directions.push_back(second);
  }
  RequireEnd(reader, rows);
  return field;
}

FieldFile ReadRawField(std::string_view text)
{
  TextReader reader(text);
  FieldFile field;
  field.Degree = ReadDegree(reader);
  field.PerRow = field.Degree;
  const std::size_t rows = ReadRowCount(reader);
  Reserve(field, rows, text);
  for (std::size_t row = 0; row < rows; ++row)
  {
    for (int k = 0; k < field.PerRow; ++k)
    {
      field.Directions.push_back(ReadVector(reader));
    }
  }
  RequireEnd(reader, rows);
  return field;
}

/// Reads the comment of a line whose first word begins with #: a number of directions or a
/// direction. Prose, even that which explains these very comments, is left out.
void ReadObjComment(TextReader& reader, std::string_view word, FieldFile& field)
{
  if (word == "#")
  {
    word = reader.Word();
  }
  else
  {
    word.remove_prefix(1);
  }
  if (word != "degree" && word != "field")
  {
    return;
  }
  TextReader ahead = reader;
  std::int64_t number = 0;
  if (!ToInteger(ahead.Word(), number))
  {
    return;
  }
  if (word == "degree")
  {
    field.Degree = ReadDegree(reader);
    return;
  }
  const auto vertex = static_cast<std::size_t>(
    reader.Integer("the number of a vertex", 1, static_cast<std::int64_t>(field.Places.size())));
  if (field.Directions.empty())
  {
    field.Directions.reserve(field.Places.size());
  }
  if (field.Directions.size() < vertex)
  {
    field.Directions.resize(vertex, Vector3::Zero());
  }
  const std::size_t line = reader.Line();
  field.Directions[vertex - 1] = ReadVector(reader);
  if (reader.Line() != line)
  {
    reader.Fail("the direction of the line before has less than three coordinates.");
  }
}

FieldFile ReadObjComments(std::string_view text)
{
  TextReader reader(text);
  FieldFile field;
  while (!reader.IsAtEnd())
  {
    const std::string_view word = reader.Word();
    if (word == "v")
    {
      field.Places.push_back(ReadVector(reader));
    }
    else if (word.front() == '#')
    {
      ReadObjComment(reader, word, field);
    }
    reader.SkipLine();
  }
  if (field.Directions.empty())
  {
    reader.Fail(
      "the file has no comments \"#field i x y z\", which fieldgen writes for directions.");
  }
  if (field.Degree == 0)
  {
    reader.Fail(
      "the file has no comment \"#degree n\", which fieldgen writes for the number of directions.");
  }
  field.Directions.resize(field.Places.size(), Vector3::Zero());
  return field;
}

void WriteRows(const FieldFile& field, int perRow, TextWriter& text)
{
  for (std::size_t row = 0; row < field.Rows(); ++row)
  {
    for (int k = 0; k < perRow; ++k)
    {
      text << (k > 0 ? " " : "") << field.Direction(row, k);
    }
    text << "\n";
  }
}
}

FieldFormat FormatOf(std::string_view fileName)
{
  std::string name(fileName);
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const Ending& ending : Endings)
  {
    if (name.size() > ending.Name.size() &&
      std::string_view(name).substr(name.size() - ending.Name.size()) == ending.Name)
    {
      return ending.Format;
    }
  }
  throw FileError(
    "The name of a file with directions ends with .rosy, .ffield, .rawfield, .sing or .obj; \"" +
    std::string(fileName) + "\" does not.");
}

FieldFile ReadField(std::string_view text, FieldFormat format)
{
  switch (format)
  {
    case FieldFormat::Rosy:
      return ReadRosy(text);
    case FieldFormat::FrameField:
      return ReadFrameField(text);
    case FieldFormat::RawField:
      return ReadRawField(text);
    case FieldFormat::ObjComments:
      return ReadObjComments(text);
    case FieldFormat::Singularities:
      break;
  }
  throw FileError(
    "A .sing file has singularities, but no directions. Choose the .rawfield file that it belongs to; "
    "the singularities follow from the directions.");
}

FieldFile ReadFieldFile(const std::string& fileName)
{
  const FieldFormat format = FormatOf(fileName);
  return ReadField(ReadText(fileName), format);
}

std::string WriteField(const FieldFile& field, FieldFormat format)
{
  const auto rows = static_cast<std::int64_t>(field.Rows());
  TextWriter text;
  if (format == FieldFormat::Rosy)
  {
    text << rows << "\n" << field.Degree << "\n";
    WriteRows(field, 1, text);
    return text.Take();
  }
  if (format == FieldFormat::RawField)
  {
    text << field.Degree << " " << rows << "\n";
    WriteRows(field, field.PerRow, text);
    return text.Take();
  }
  if (format != FieldFormat::FrameField)
  {
    throw FileError("Directions are written to .rosy, .ffield and .rawfield files.");
  }
  if (field.Degree != 4 || field.PerRow < 2)
  {
    throw FileError("A .ffield file holds cross fields (degree 4); this field has degree " +
      std::to_string(field.Degree) + ". Choose .rawfield.");
  }
  text << "# directions of a cross field\ntarget frame\n"
       << rows << "\nk1 k2 k1v_x k1v_y k1v_z k2v_x k2v_y k2v_z\n";
  for (std::size_t row = 0; row < field.Rows(); ++row)
  {
    text << "1 1 " << field.Direction(row, 1) << " " << field.Direction(row, 0) << "\n";
  }
  return text.Take();
}
}
