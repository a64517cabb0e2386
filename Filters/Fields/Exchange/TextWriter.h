// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TextWriter_h
#define DirectionFields_TextWriter_h

#include "Types.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace DirectionFields::Internal
{
/// Makes a text of words and numbers in the C locale, whatever the program's locale is. Numbers
/// have as many digits as it takes to read them back to the last bit, 17 at most.
class TextWriter
{
public:
  TextWriter& operator<<(std::string_view word)
  {
    this->Text += word;
    return *this;
  }
  TextWriter& operator<<(double number);
  TextWriter& operator<<(std::int64_t number);
  TextWriter& operator<<(Index number) { return *this << static_cast<std::int64_t>(number); }
  /// The coordinates with a blank between them.
  TextWriter& operator<<(const Vector3& vector)
  {
    return *this << vector.x() << " " << vector.y() << " " << vector.z();
  }

  /// The text so far, which is left empty.
  std::string Take();

private:
  std::string Text;
};
}

#endif
