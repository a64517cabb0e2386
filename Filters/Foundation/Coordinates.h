// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Coordinates_h
#define DirectionFields_Coordinates_h

#include <cstddef>
#include <string>

namespace DirectionFields
{
/// Whether the coordinates of a surface can be computed with. Larger ones than these have numbers,
/// but sums of a few of them, and places beside the surface, have none.
class CoordinateCheck
{
public:
  /// The largest modulus of a coordinate, and the largest where places are handed on in single
  /// precision.
  static constexpr double Largest = 1e300;
  static constexpr double LargestSingle = 1e37;

  explicit CoordinateCheck(bool isSingle)
    : Most(isSingle ? LargestSingle : Largest)
  {
  }

  /// Three coordinates; false for NaN, too.
  bool MayBe(const double* place) const;
  /// Notes a point that may not be where it is. Points come in ascending order.
  void Refuse(std::size_t point, const double* place);

  /// The first refused point, of those that are NaN or infinite where there are any.
  std::size_t GetFirst() const { return this->NowhereCount > 0 ? this->Nowhere : this->Far; }
  /// A sentence with the number and the first of the refused points, and one with the remedy; empty
  /// where there is no such point.
  std::string GetError() const;

private:
  double Most;
  std::size_t Nowhere = 0;
  std::size_t NowhereCount = 0;
  std::size_t Far = 0;
  std::size_t FarCount = 0;
};
}

#endif
