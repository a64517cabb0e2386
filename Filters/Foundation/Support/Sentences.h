// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Sentences_h
#define DirectionFields_Sentences_h

#include "Types.h"

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace DirectionFields::Internal
{
/// A sentence for the user that is being written. Its numbers have a decimal point and no marks
/// between thousands in any locale, as all other words are English, too.
class Sentence : public std::ostringstream
{
public:
  Sentence();
};

/// A number with its noun, as sentences for the user have it.
/// @param several the plural, where it is not the noun with an s
std::string Count(std::size_t number, const std::string& noun, const std::string& several = "");

/// A noun and the first of the numbers of what it names, and how many more there are: `Point 3`,
/// and `Points 3 and 4 more`. There has to be one.
std::string Numbered(const std::string& noun, const std::vector<Index>& numbers);

/// A length, an angle or a ratio with three digits.
std::string Figure(double value);

double Sum(const std::vector<double>& values);
}

#endif
