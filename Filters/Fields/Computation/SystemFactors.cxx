// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/SystemFactors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace DirectionFields::Internal
{
namespace
{
/// A gap lambda_1 - lambda_t below this part of sigma leaves the smoothest field.
constexpr double SmallestRelativeGap = 1e-8;
/// Where A - lambda_t M turns out to be indefinite the gap grows by this factor.
constexpr double GapGrowth = 8.0;

/// A bound of the error of the computed lambda_1, over sigma: the square of its residual over the
/// distance to the next eigenvalue, which is assumed to be a hundredth of sigma, or the residual
/// where that is less.
double EigenvalueError(double residual)
{
  constexpr double nearness = 100.0;
  return residual * std::min(1.0, nearness * residual);
}
}

SystemFactors FactorsAt(double smallest, double gap)
{
  if (std::isinf(gap))
  {
    return { 0.0, 1.0, 1.0 };
  }
  if (gap > 1.0)
  {
    return { 1.0 / gap, 1.0 - smallest / gap, 1.0 };
  }
  return { 1.0, gap - smallest, gap };
}

double SystemGap(const Options& options, double share, const ComputedEigenvalue& smallest,
  double scale, double unit)
{
  const double sigma = std::max(smallest.Value, scale);
  const double least = sigma * EigenvalueError(smallest.Residual);
  if (options.UseShift)
  {
    return std::clamp(
      options.Shift * unit * unit, least, std::max(least, std::numeric_limits<double>::max()));
  }
  const double tau = options.AlignmentStrength;
  return tau < 1.0 ? std::max(least, share * sigma * tau / (1.0 - tau))
                   : std::numeric_limits<double>::infinity();
}

double SmallestSystemGap(double smallest, double scale)
{
  return SmallestRelativeGap * std::max(smallest, scale);
}

double GrownGap(double gap, double smallest, double scale)
{
  return std::min(smallest, std::max(GapGrowth * gap, SmallestSystemGap(smallest, scale)));
}
}
