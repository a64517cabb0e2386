// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Eigenpairs/Eigenpair.h"

#include "Matrices/OperatorProducts.h"

#include <cmath>

namespace DirectionFields::Internal
{
double FractionDone(int solves)
{
  return solves == 0 ? 0.0 : 1.0 - 0.6 * std::exp(-0.1 * (solves - 1));
}

double RelativeResidual(double residual, double energy, double terms)
{
  if (energy < 1e-7 * terms)
  {
    return residual <= 1e-14 * terms ? 0.0 : residual / (1e-7 * terms);
  }
  return residual / energy;
}

double RelativeResidual(const SparseMatrix& energy, const SectionProducts& u, double lambda)
{
  return RelativeResidual(
    (u.Energy - lambda * u.Mass).norm(), u.Energy.norm(), SumOfMagnitudes(energy, u.Vector));
}
}
