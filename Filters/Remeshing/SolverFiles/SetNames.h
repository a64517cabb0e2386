// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SetNames_h
#define DirectionFields_SetNames_h

#include <set>
#include <string>
#include <string_view>

namespace DirectionFields::Internal
{
/// Names of sets as input files of Abaqus and CalculiX allow them: neither distinguishes small
/// letters from capitals.
class SetNames
{
public:
  /// @param taken names that no set may have, in capitals
  explicit SetNames(std::set<std::string> taken);

  /// A name that no other set has: letters as capitals, all but letters and digits of ASCII as one
  /// `_` between others, SET_ before what does not begin with a letter, 64 characters at most, and
  /// a number behind a name that is taken.
  std::string Unique(std::string_view wanted);

private:
  std::set<std::string> Taken;
};
}

#endif
