// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FuzzedFile.h"

#include "Exchange/FieldFile.h"
#include "Exchange/FieldImport.h"
#include "Meshes/Surfaces.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

using namespace DirectionFields;

namespace
{
bool IsSame(const FieldFile& one, const FieldFile& other)
{
  return one.Degree == other.Degree && one.PerRow == other.PerRow &&
    one.Directions == other.Directions;
}

/// The first fault of the directions that were read.
std::string FileFlaw(const FieldFile& file, FieldFormat format)
{
  if (file.Degree < 1 || file.Degree > LargestDegree || file.PerRow < 1 ||
    file.Rows() * static_cast<std::size_t>(file.PerRow) != file.Directions.size())
  {
    return "rows that are not whole";
  }
  if (!std::all_of(file.Directions.begin(), file.Directions.end(),
        [](const Vector3& direction) { return direction.allFinite(); }))
  {
    return "a direction that is not finite";
  }
  if (format != FieldFormat::ObjComments &&
    !IsSame(file, ReadField(WriteField(file, format), format)))
  {
    return "another file when it is written and read again";
  }
  return {};
}

/// The first fault of the field that it makes of a closed surface.
std::string FieldFlaw(const Result& field)
{
  if (field.Components.size() != 1 || field.Components[0].IndexSum != 2 * field.Degree)
  {
    return "another index sum";
  }
  for (std::size_t i = 0; i < field.Representation.size(); ++i)
  {
    const Vector3 direction = field.Direction(static_cast<Index>(i), field.Degree - 1);
    if (!(std::abs(direction.norm() - 1.0) < 1e-9) || !(std::abs(field.Representation[i]) < 2.0))
    {
      return "a direction that is not of unit length";
    }
  }
  return {};
}
}

std::string FuzzedFile(const std::uint8_t* data, std::size_t size)
{
  const unsigned kind = size > 0 ? data[0] : 0;
  const unsigned surface = size > 1 ? data[1] : 0;
  const auto format = static_cast<FieldFormat>(kind % 5);
  const std::string_view text(
    reinterpret_cast<const char*>(data) + std::min<std::size_t>(size, 2), size > 2 ? size - 2 : 0);
  try
  {
    const FieldFile file = ReadField(text, format);
    const std::string flaw = FileFlaw(file, format);
    if (!flaw.empty())
    {
      return flaw;
    }
    const Surface mesh = surface % 2 == 0 ? Meshes::Tetrahedron() : Meshes::Icosahedron();
    const ImportedField imported =
      ImportField(file, mesh, static_cast<FieldOn>(surface / 2 % 3), surface / 8 % 2 == 0);
    return FieldFlaw(imported.Field);
  }
  catch (const FileError& error)
  {
    return std::string(error.what()).empty() ? "an error without a sentence" : "";
  }
}
