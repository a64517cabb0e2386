// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FuzzedField_h
#define DirectionFields_FuzzedField_h

#include <cstddef>
#include <cstdint>
#include <string>

/// Makes options, guidance and a surface out of any bytes, computes the field, and says what does not
/// hold of it; empty if all does. Exceptions that are not documented pass through.
///
/// The first bytes are the options, each at its own place and the default where the byte is 0, so
/// that inputs keep their meaning when an option is added. The rest edits a mesh.
std::string FuzzedField(const std::uint8_t* data, std::size_t size);

#endif
