// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef FuzzedRemesh_h
#define FuzzedRemesh_h

#include <cstddef>
#include <cstdint>
#include <string>

/// Makes options and a surface out of any bytes, makes a mesh, and says what does not hold of it; empty if all
/// does. Exceptions that are not documented pass through. The first bytes are the options, each at its own place
/// and the default where the byte is 0; the rest is a surface.
std::string FuzzedRemesh(const std::uint8_t* data, std::size_t size);

#endif
