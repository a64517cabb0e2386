// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Exchange/CompanionFiles.h"

#include "Exchange/TextWriter.h"

#include <array>
#include <charconv>
#include <cstdint>

namespace DirectionFields::Internal
{
const std::string_view ObjMark = "# The mesh of a direction field written by Direction Fields";

namespace
{
constexpr std::string_view ChecksumMark = "# checksum ";
constexpr std::string_view BesideMark = "# beside it ";

/// Takes the first line off a text.
std::string_view TakeLine(std::string_view& text)
{
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

bool StartsWith(std::string_view text, std::string_view beginning)
{
  return text.substr(0, beginning.size()) == beginning;
}
}

std::string Checksum(std::string_view text)
{
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : text)
  {
    hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  }
  std::array<char, 16> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), hash, 16);
  const std::string number(digits.data(), end.ptr);
  return std::string(digits.size() - number.size(), '0') + number;
}

std::string WithRecord(std::string_view obj, const FileRecord& record)
{
  TakeLine(obj);
  std::string rest;
  for (const auto& [ending, checksum] : record)
  {
    rest += std::string(BesideMark) + ending + " " + checksum + "\n";
  }
  rest += obj;
  return std::string(ObjMark) + "\n" + std::string(ChecksumMark) + Checksum(rest) + "\n" + rest;
}

std::optional<FileRecord> RecordOf(std::string_view obj)
{
  const std::string_view mark = TakeLine(obj);
  const std::string_view checksum = TakeLine(obj);
  if (mark != ObjMark || checksum != std::string(ChecksumMark) + Checksum(obj))
  {
    return std::nullopt;
  }
  FileRecord record;
  while (StartsWith(obj, BesideMark))
  {
    const std::string_view entry = TakeLine(obj).substr(BesideMark.size());
    const std::size_t blank = entry.find(' ');
    if (blank != std::string_view::npos)
    {
      record[std::string(entry.substr(0, blank))] = entry.substr(blank + 1);
    }
  }
  return record;
}

std::string WriteObj(const Surface& surface)
{
  TextWriter text;
  text << ObjMark << "\n";
  for (const Vector3& point : surface.Points)
  {
    text << "v " << point << "\n";
  }
  for (const Triangle& triangle : surface.Triangles)
  {
    text << "f " << triangle[0] + 1 << " " << triangle[1] + 1 << " " << triangle[2] + 1 << "\n";
  }
  return text.Take();
}

std::string WriteSharp(const std::vector<SharpEdge>& edges)
{
  TextWriter text;
  text << static_cast<std::int64_t>(edges.size()) << "\n";
  for (const SharpEdge& edge : edges)
  {
    text << (edge.IsConvex ? "1," : "0,") << edge.Triangle << "," << edge.Corner << "\n";
  }
  return text.Take();
}

std::string WriteSingularities(int degree, const std::vector<SingularElement>& elements)
{
  TextWriter text;
  text << degree << " " << static_cast<std::int64_t>(elements.size()) << "\n";
  for (const SingularElement& element : elements)
  {
    text << element.Element << " " << element.SingularityIndex << "\n";
  }
  return text.Take();
}
}
