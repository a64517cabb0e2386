// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FieldFile_h
#define DirectionFields_FieldFile_h

#include "Exchange/FileError.h"
#include "Types.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace DirectionFields
{
/// How other programs keep direction fields.
enum class FieldFormat
{
  /// .rosy: the number of rows, the degree, and one direction a row (Palacios and Zhang 2011;
  /// QuadWild and others that use vcglib, which take degree 4 only).
  Rosy,
  /// .ffield: a comment, `target frame`, the number of rows, a line of names, and rows of two
  /// lengths, the second and the first direction of a cross (vcglib).
  FrameField,
  /// .rawfield: the degree, the number of rows, and all directions of an element in each row,
  /// counter-clockwise (Directional).
  RawField,
  /// .sing: the degree, the number of rows, and an element and its index in each row (Directional).
  Singularities,
  /// .obj with comments `#degree n` and `#field i x y z` for the vertices, counted from 1
  /// (fieldgen).
  ObjComments
};

/// The largest degree that there is.
constexpr int LargestDegree = 16;

/// The format that a file's name ends with. Throws FileError where that is none of these.
FieldFormat FormatOf(std::string_view fileName);

/// The directions in a file: rows for the faces or the vertices of a mesh, which the file does not
/// know.
struct FieldFile
{
  int Degree = 0;
  /// Directions in a row.
  int PerRow = 1;
  /// Row by row. Not normalized; zero where a row has no direction.
  std::vector<Vector3> Directions;
  /// For ObjComments the vertex that each row belongs to; else empty.
  std::vector<Vector3> Places;

  std::size_t Rows() const
  {
    return this->Directions.size() / static_cast<std::size_t>(this->PerRow);
  }
  const Vector3& Direction(std::size_t row, int k) const
  {
    return this
      ->Directions[row * static_cast<std::size_t>(this->PerRow) + static_cast<std::size_t>(k)];
  }
};

/// Reads the text of a file, as tolerant about blanks and ends of lines as the programs that the
/// formats come from. Throws FileError where that is broken, has a number that is not finite, or a
/// format without directions. Takes time and memory linear in the text, whatever numbers of rows it
/// promises.
FieldFile ReadField(std::string_view text, FieldFormat format);

/// The same for a file, whose format its name tells. Throws FileError where it cannot be read, too.
FieldFile ReadFieldFile(const std::string& fileName);

/// The text of a .rosy, .ffield or .rawfield file. Rosy takes the first direction of each row,
/// FrameField the first two, RawField all. Throws FileError for another format, and for a
/// FrameField of another degree than 4.
std::string WriteField(const FieldFile& field, FieldFormat format);
}

#endif
