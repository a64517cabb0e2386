// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Exchange/TextWriter.h"

#include <array>
#include <charconv>
#include <utility>

namespace DirectionFields::Internal
{
TextWriter& TextWriter::operator<<(double number)
{
  // A sign, 17 digits, a point, and an exponent of five characters at most.
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  this->Text.append(digits.data(), end.ptr);
  return *this;
}

TextWriter& TextWriter::operator<<(std::int64_t number)
{
  this->Text += std::to_string(number);
  return *this;
}

std::string TextWriter::Take()
{
  return std::exchange(this->Text, {});
}
}
