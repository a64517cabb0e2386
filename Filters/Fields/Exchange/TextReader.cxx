// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Exchange/TextReader.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace DirectionFields::Internal
{
namespace
{
bool IsBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

bool IsEndOfLine(char c)
{
  return c == '\n' || c == '\r';
}

/// A word as a sentence quotes it: no longer than a line, and nothing that does not print.
std::string Quoted(std::string_view word)
{
  constexpr std::size_t most = 40;
  std::string quoted = "\"";
  for (const char c : word.substr(0, most))
  {
    quoted += c >= ' ' && c <= '~' ? c : '?';
  }
  return quoted + (word.size() > most ? "...\"" : "\"");
}

/// The characters of a number; a sign + is none for the standard library.
std::string_view WithoutPlus(std::string_view word)
{
  const bool hasPlus = word.size() > 1 && word.front() == '+' && word[1] != '-' && word[1] != '+';
  return hasPlus ? word.substr(1) : word;
}
}

bool ToNumber(std::string_view word, double& number)
{
  const std::string_view digits = WithoutPlus(word);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (end != digits.data() + digits.size())
  {
    return false;
  }
  if (error == std::errc::result_out_of_range)
  {
    // Too small for a double counts as zero, too large as infinite.
    const std::size_t exponent = digits.find_first_of("eE");
    const bool isSmall =
      exponent != std::string_view::npos && digits.find('-', exponent) != std::string_view::npos;
    number = isSmall ? 0.0 : std::numeric_limits<double>::infinity();
    return true;
  }
  return error == std::errc();
}

bool ToInteger(std::string_view word, std::int64_t& number)
{
  const std::string_view digits = WithoutPlus(word);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return error == std::errc() && end == digits.data() + digits.size();
}

TextReader::TextReader(std::string_view text)
  : Text(text)
{
  // The mark that some editors put before the text.
  constexpr std::string_view mark = "\xef\xbb\xbf";
  this->At = text.substr(0, mark.size()) == mark ? mark.size() : 0;
}

bool TextReader::IsAtEndOfLine()
{
  while (this->At < this->Text.size() && IsBlank(this->Text[this->At]))
  {
    ++this->At;
  }
  return this->At == this->Text.size() || IsEndOfLine(this->Text[this->At]);
}

void TextReader::SkipLine()
{
  while (this->At < this->Text.size() && !IsEndOfLine(this->Text[this->At]))
  {
    ++this->At;
  }
  if (this->At == this->Text.size())
  {
    return;
  }
  const bool isPair = this->Text.substr(this->At, 2) == "\r\n";
  this->At += isPair ? 2 : 1;
  ++this->LineNumber;
}

bool TextReader::IsAtEnd()
{
  while (this->IsAtEndOfLine())
  {
    if (this->At == this->Text.size())
    {
      return true;
    }
    this->SkipLine();
  }
  return false;
}

std::string_view TextReader::Word()
{
  if (this->IsAtEndOfLine())
  {
    return {};
  }
  const std::size_t begin = this->At;
  while (this->At < this->Text.size() && !IsBlank(this->Text[this->At]) &&
    !IsEndOfLine(this->Text[this->At]))
  {
    ++this->At;
  }
  return this->Text.substr(begin, this->At - begin);
}

std::string_view TextReader::NextWord(const char* what)
{
  if (this->IsAtEnd())
  {
    this->Fail(std::string("the file ends where ") + what + " should stand.");
  }
  return this->Word();
}

double TextReader::Number(const char* what)
{
  const std::string_view word = this->NextWord(what);
  double number = 0.0;
  if (!ToNumber(word, number) || !std::isfinite(number))
  {
    this->Fail(std::string(what) + " should stand where " + Quoted(word) + " is.");
  }
  return number;
}

std::int64_t TextReader::Integer(const char* what, std::int64_t least, std::int64_t most)
{
  const std::string_view word = this->NextWord(what);
  std::int64_t number = 0;
  if (!ToInteger(word, number) || number < least || number > most)
  {
    this->Fail(std::string(what) + ", " + std::to_string(least) + " to " + std::to_string(most) +
      ", should stand where " + Quoted(word) + " is.");
  }
  return number;
}

void TextReader::Fail(const std::string& sentence) const
{
  throw FileError("Line " + std::to_string(this->LineNumber) + ": " + sentence);
}
}
