// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Exchange/TextFile.h"

#include "Exchange/FileError.h"

#include <algorithm>
#include <array>
#include <fstream>

namespace DirectionFields::Internal
{
std::string ReadText(const std::string& path, std::size_t most)
{
  std::ifstream stream(path, std::ios::binary);
  // Directories can be opened, but not read.
  if (!stream || (stream.peek() == std::ifstream::traits_type::eof() && !stream.eof()))
  {
    throw FileError("The file " + path + " cannot be read.");
  }
  std::string text;
  std::array<char, 1 << 16> buffer;
  stream.clear();
  while (text.size() < most && stream)
  {
    stream.read(
      buffer.data(), static_cast<std::streamsize>(std::min(buffer.size(), most - text.size())));
    text.append(buffer.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad())
  {
    throw FileError("The file " + path + " cannot be read to its end.");
  }
  return text;
}

void WriteText(const std::string& path, std::string_view text)
{
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  if (!stream)
  {
    throw FileError("The file " + path + " cannot be written.");
  }
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  if (!stream)
  {
    throw FileError("The file " + path + " could not be written to its end; the disk may be full.");
  }
}

bool IsThere(const std::string& path)
{
  return std::ifstream(path).good();
}
}
