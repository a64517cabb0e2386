// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef FuzzedFile_h
#define FuzzedFile_h

#include <cstddef>
#include <cstdint>
#include <string>

/// Reads any bytes as a file with directions: the first byte says of which format, the second one which surface it is for
/// and what its rows are for, the rest is the text. Says what does not hold of what was read; empty if all does.
std::string FuzzedFile(const std::uint8_t* data, std::size_t size);

#endif
