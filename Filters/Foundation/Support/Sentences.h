// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Sentences_h
#define DirectionFields_Sentences_h

#include <cstddef>
#include <string>
#include <vector>

namespace DirectionFields::Internal
{
/// A number with its noun, as sentences for the user have it.
/// @param several the plural, where it is not the noun with an s
std::string Count(std::size_t number, const std::string& noun, const std::string& several = "");

/// A length, an angle or a ratio with three digits.
std::string Figure(double value);

double Sum(const std::vector<double>& values);
}

#endif
