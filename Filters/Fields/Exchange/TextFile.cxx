// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Exchange/TextFile.h"

#include "Exchange/FileError.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace DirectionFields::Internal
{
namespace fs = std::filesystem;

void RequireShort(const std::string& path, std::uint64_t bytes)
{
  if (bytes > MostTextBytes)
  {
    throw FileError("The file " + path +
      " is longer than the 4 GB that a text may have here. Decimate the surface, or divide it.");
  }
}

std::string ReadText(const std::string& path)
{
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    throw FileError(
      "The file " + path + " cannot be read: it is no regular file, but a folder, pipe or device.");
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
  {
    throw FileError("The file " + path + " cannot be read.");
  }
  const std::uintmax_t size = fs::file_size(path, error);
  RequireShort(path, error ? 0 : size);
  std::string text;
  std::array<char, 1 << 16> buffer;
  while (stream)
  {
    stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    text.append(buffer.data(), static_cast<std::size_t>(stream.gcount()));
    // It may grow while it is read.
    RequireShort(path, text.size());
  }
  if (stream.bad())
  {
    throw FileError("The file " + path + " cannot be read to its end.");
  }
  return text;
}

bool IsThere(const std::string& path)
{
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}
}
