// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_IntegerElimination_h
#define DirectionFields_IntegerElimination_h

#include "Types.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace DirectionFields::Internal
{
/// A sum of variables with integer coefficients, in ascending order of the variables.
using IntegerSum = std::vector<std::pair<Index, std::int64_t>>;

/// Solves linear equations with integer coefficients exactly: some of the variables become sums of
/// the others, which are free. Where variables are to be integers, the dependent ones among them
/// are integers for whatever integers the free ones are, provided that every equation with real
/// variables has, after the equations before it, a coefficient 1 or -1 at one of these.
class IntegerElimination
{
public:
  /// @param isInteger not 0 for variables that are to be integers
  explicit IntegerElimination(std::vector<char> isInteger);

  /// A new variable that is to be an integer, and stays free where an equation leaves another one
  /// to be solved for: bounds can be put on it.
  Index AddFreeInteger();

  /// Requires that a sum vanishes. Its terms may be in any order, and repeated.
  void Require(IntegerSum sum);

  /// The same for integers such that few variables depend on each free one, where an equation
  /// p x + ... = 0 is one of many that have others of their variables in common.
  /// @param own   x: what is solved for, if it is possible. Where its coefficient p is not 1 or -1,
  ///              another variable gets the value modulo p that makes it possible, and loses its
  ///              freedom up to multiples of p
  /// @param other this variable, if its coefficient is 1 or -1
  void RequireLocally(IntegerSum sum, Index own, Index other);

  bool IsFree(Index variable) const { return this->Dependent[variable] == None; }
  bool IsInteger(Index variable) const { return this->Integers[variable] != 0; }
  /// There may be more than were given: where all coefficients of an equation are other than 1 and
  /// -1, new variables take the place of old ones.
  Index GetNumberOfVariables() const { return static_cast<Index>(this->Dependent.size()); }
  /// A variable as a sum of free ones.
  const IntegerSum& Resolve(Index variable);
  IntegerSum Resolve(const IntegerSum& sum);

private:
  void MakeDependent(Index variable, IntegerSum sum);
  /// Solves for the term at a place of a sum; its coefficient is 1 or -1.
  void SolveFor(std::size_t pivot, IntegerSum sum);

  /// The kind of each variable: 0 for a real number, 1 for an integer, 2 for one that stays free if
  /// it can.
  std::vector<char> Integers;
  /// Which of the sums a variable is, or None.
  std::vector<Index> Dependent;
  std::vector<IntegerSum> Sums;
  IntegerSum Own;
};
}

#endif
