// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Systems/ShiftedSystem.h"

#include "Matrices/OperatorProducts.h"

namespace DirectionFields::Internal
{
namespace
{
/// In 1 / unit^2. With a larger shift nothing but the mass matrix counts.
constexpr double LargestShift = 1e8;
}

double ShiftedSystem::Shift() const
{
  return this->MassFactor < LargestShift * this->EnergyFactor
    ? this->MassFactor / this->EnergyFactor
    : LargestShift;
}

ComplexVector ShiftedSystem::Times(const ComplexVector& x) const
{
  return Product(this->Matrices, this->EnergyFactor, this->MassFactor, x);
}
}
