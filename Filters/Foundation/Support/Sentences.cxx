// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/Sentences.h"

#include <locale>
#include <numeric>

namespace DirectionFields::Internal
{
Sentence::Sentence()
{
  this->imbue(std::locale::classic());
}

std::string Count(std::size_t number, const std::string& noun, const std::string& several)
{
  return std::to_string(number) + ' ' +
    (number == 1 ? noun : (several.empty() ? noun + 's' : several));
}

std::string Numbered(const std::string& noun, const std::vector<Index>& numbers)
{
  return noun + (numbers.size() == 1 ? " " : "s ") + std::to_string(numbers.front()) +
    (numbers.size() == 1 ? "" : " and " + std::to_string(numbers.size() - 1) + " more");
}

std::string Figure(double value)
{
  Sentence text;
  text.precision(3);
  text << value;
  return text.str();
}

double Sum(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}
}
