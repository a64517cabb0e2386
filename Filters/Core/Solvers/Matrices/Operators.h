// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Operators_h
#define DirectionFields_Operators_h

#include "Types.h"

namespace DirectionFields
{
/// Energy and mass matrix of one connected component, Hermitian, full storage, in units of the
/// component's mean edge length. Row and column v belong to the vertex FirstVertex + v.
struct Operators
{
  Operators() = default;
  Operators(const Operators&) = default;
  Operators& operator=(const Operators&) = default;
  /// Eigen would copy the matrices.
  Operators(Operators&& other) noexcept { this->Swap(other); }
  Operators& operator=(Operators&& other) noexcept
  {
    this->Swap(other);
    return *this;
  }
  void Swap(Operators& other) noexcept
  {
    this->Energy.swap(other.Energy);
    this->Mass.swap(other.Mass);
  }

  SparseMatrix Energy;
  SparseMatrix Mass;
};
}

#endif
