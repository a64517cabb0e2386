// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TextFile_h
#define DirectionFields_TextFile_h

#include <cstddef>
#include <string>
#include <string_view>

namespace DirectionFields::Internal
{
/// The bytes of a file, or its first ones. Throws FileError where it cannot be read.
/// @param most bytes that are read
std::string ReadText(const std::string& path, std::size_t most = static_cast<std::size_t>(-1));

/// Writes a file anew. Throws FileError where that fails.
void WriteText(const std::string& path, std::string_view text);

/// Whether there is a file that can be read.
bool IsThere(const std::string& path);
}

#endif
