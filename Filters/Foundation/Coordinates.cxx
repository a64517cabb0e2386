// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Coordinates.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields
{
bool CoordinateCheck::MayBe(const double* place) const
{
  return std::all_of(place, place + 3, [this](double x) { return std::abs(x) <= this->Most; });
}

void CoordinateCheck::Refuse(std::size_t point, const double* place)
{
  const bool isFinite = std::all_of(place, place + 3, [](double x) { return std::isfinite(x); });
  std::size_t& count = isFinite ? this->FarCount : this->NowhereCount;
  std::size_t& first = isFinite ? this->Far : this->Nowhere;
  first = count == 0 ? point : first;
  ++count;
}

std::string CoordinateCheck::GetError() const
{
  const auto sentence = [](std::size_t count, const std::string& what, std::size_t first)
  {
    return std::to_string(count) +
      (count == 1 ? " point of the surface has " : " points of the surface have ") + what +
      ", the first is point " + std::to_string(first) + ". ";
  };
  if (this->NowhereCount > 0)
  {
    return sentence(this->NowhereCount, "NaN or infinite coordinates", this->Nowhere) +
      "Remove the cells at these points or correct their coordinates.";
  }
  if (this->FarCount == 0)
  {
    return "";
  }
  const bool isSingle = this->Most < Largest;
  return sentence(this->FarCount,
           std::string("coordinates beyond ") +
             (isSingle ? "1e37, too large for single precision"
                       : "1e300, too large to compute with"),
           this->Far) +
    (isSingle
        ? "Scale the surface down, give its points in double precision, or remove the cells at "
          "these points."
        : "Scale the surface down, or remove the cells at these points.");
}
}
