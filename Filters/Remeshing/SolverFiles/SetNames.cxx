// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SolverFiles/SetNames.h"

#include <cstddef>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Of Abaqus and CalculiX 80, some of which they need themselves.
constexpr std::size_t LongestName = 64;

/// Not those of <cctype>, which depend on the locale.
bool IsLetter(char c)
{
  return c >= 'A' && c <= 'Z';
}
bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}
char Capital(char c)
{
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

std::string Allowed(std::string_view wanted)
{
  std::string name;
  for (const char given : wanted)
  {
    const char c = Capital(given);
    if (IsLetter(c) || IsDigit(c))
    {
      name += c;
    }
    else if (c == '-')
    {
      // Negative numbers of regions.
      name += name.empty() || name.back() == '_' ? "M" : "_";
    }
    else if (!name.empty() && name.back() != '_')
    {
      name += '_';
    }
  }
  while (!name.empty() && name.back() == '_')
  {
    name.pop_back();
  }
  if (name.empty() || !IsLetter(name.front()))
  {
    name = name.empty() ? "SET" : "SET_" + name;
  }
  return name.substr(0, LongestName);
}
}

SetNames::SetNames(std::set<std::string> taken)
  : Taken(std::move(taken))
{
}

std::string SetNames::Unique(std::string_view wanted)
{
  const std::string name = Allowed(wanted);
  std::string unique = name;
  for (int k = 2; this->Taken.count(unique) > 0; ++k)
  {
    const std::string number = "_" + std::to_string(k);
    unique = name.substr(0, LongestName - number.size()) + number;
  }
  this->Taken.insert(unique);
  return unique;
}
}
