// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SystemFactors_h
#define DirectionFields_SystemFactors_h

#include "Options.h"

namespace DirectionFields::Internal
{
/// K = A - lambda_t M = Energy A + Mass M and the factor lambda_1 - lambda_t of M q, all divided by
/// any positive number.
struct SystemFactors
{
  double Energy = 1.0;
  double Mass = 0.0;
  double Guidance = 0.0;
};
/// @param smallest lambda_1
/// @param gap      lambda_1 - lambda_t, 0 to infinity
SystemFactors FactorsAt(double smallest, double gap);

/// lambda_1 as it was computed, and its relative residual.
struct ComputedEigenvalue
{
  double Value = 0.0;
  double Residual = 0.0;
};

/// lambda_1 - lambda_t, 0 to infinity, in 1 / unit^2. It is no less than the error of lambda_1,
/// since A - lambda_t M could be indefinite otherwise.
/// @param share of the strength, 0 to 1
/// @param scale the order of magnitude of the smallest eigenvalue
/// @param unit  a length in the unit of the input
double SystemGap(const Options& options, double share, const ComputedEigenvalue& smallest,
  double scale, double unit);
/// Smaller gaps give the smoothest field: the guidance's part would be below rounding.
double SmallestSystemGap(double smallest, double scale);
/// Where A - lambda_t M turns out to be indefinite the gap becomes this: the quotient of a section
/// that has not converged may exceed lambda_1 by more than its residual lets expect. lambda_t = 0
/// is safe.
double GrownGap(double gap, double smallest, double scale);
}

#endif
