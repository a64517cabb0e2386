// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Guidance/SoftConstraints.h"

#include "Matrices/VectorOperations.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
double Stiffness(double weight, double strength)
{
  return std::min(
    weight * strength / std::max(1.0 - strength, 1.0 / SoftConstraints::MostStiffness),
    SoftConstraints::MostStiffness);
}

SoftTerms::SoftTerms(const Operators& operators, const SoftConstraints& soft, double sigma)
  : Soft(soft)
  , Matrices(operators)
  , Pull(ComplexVector::Zero(operators.Energy.cols()))
{
  for (std::size_t k = 0; k < soft.Vertices.size(); ++k)
  {
    const Index v = soft.Vertices[k];
    const double area = 2.0 * operators.Mass.coeff(v, v).real();
    const double size = std::sqrt(std::max(0.0, sigma * area));
    const Complex value = soft.Values[static_cast<Eigen::Index>(k)];
    this->Matrices.Energy.coeffRef(v, v) += std::abs(value) * size;
    this->Pull[v] = value * size;
  }
}

bool SoftTerms::Fit(const SoftConstraints& soft) const
{
  return this->Soft.Vertices == soft.Vertices && Equal(this->Soft.Values, soft.Values);
}
}
