// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TextFile_h
#define DirectionFields_TextFile_h

#include <cstddef>
#include <cstdint>
#include <string>

namespace DirectionFields::Internal
{
/// Texts are 4 GB at most: the directions of 17 million triangles with four directions each.
constexpr std::uint64_t MostTextBytes = std::uint64_t(1) << 32U;

/// Throws FileError where a text is longer than MostTextBytes.
/// @param path of the file that has it, or gets it
void RequireShort(const std::string& path, std::uint64_t bytes);

/// The bytes of a file. Throws FileError where it cannot be read, is longer than MostTextBytes, or
/// is no regular file: reading a pipe may wait, and a device may not end.
std::string ReadText(const std::string& path);

/// Whether the name is taken, by whatever: a link to nowhere is there, too.
bool IsThere(const std::string& path);
}

#endif
