// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TextReader_h
#define DirectionFields_TextReader_h

#include "Exchange/FileError.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace DirectionFields::Internal
{
/// Takes words and numbers out of a text one after the other. Numbers are those of the C locale,
/// whatever the program's locale is. Blanks, tabs and ends of lines, those of any system, separate
/// words.
class TextReader
{
public:
  /// @param text must outlive this
  explicit TextReader(std::string_view text);

  /// Whether nothing but blanks is left.
  bool IsAtEnd();
  /// Whether nothing but blanks is left of this line.
  bool IsAtEndOfLine();
  /// The next word on this line, up to a blank; empty at the end of the line.
  std::string_view Word();
  /// The next word of the text, on whatever line, as a number. Throws FileError where it is none,
  /// or not finite.
  /// @param what the number's name, for the sentence
  double Number(const char* what);
  /// The same for an integer in a range.
  std::int64_t Integer(const char* what, std::int64_t least, std::int64_t most);
  /// Leaves the rest of this line out.
  void SkipLine();
  /// The number of this line, from 1.
  std::size_t Line() const { return this->LineNumber; }

  /// Throws FileError with the number of the line before the sentence.
  [[noreturn]] void Fail(const std::string& sentence) const;

private:
  /// Goes to the next word, on whatever line. Throws FileError at the end of the text.
  std::string_view NextWord(const char* what);

  std::string_view Text;
  std::size_t At = 0;
  std::size_t LineNumber = 1;
};

/// The number that a word is, in the C locale. False where it is none.
bool ToNumber(std::string_view word, double& number);
bool ToInteger(std::string_view word, std::int64_t& number);
}

#endif
