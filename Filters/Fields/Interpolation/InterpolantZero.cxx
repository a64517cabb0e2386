// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Interpolation/InterpolantZero.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
constexpr int MostSteps = 60;
constexpr int MostHalvings = 30;
/// |q| that passes for 0, as a part of the largest at the corners.
constexpr double Vanishing = 1e-13;

/// The nearest weights that are large enough, roughly: small ones are raised at the cost of the
/// others.
std::array<double, 3> KeptInside(std::array<double, 3> weights)
{
  for (double& weight : weights)
  {
    weight = std::max(weight, InterpolantZero::LeastWeight);
  }
  const double sum = weights[0] + weights[1] + weights[2];
  // The excess over the least is shared out in proportion.
  const double rest =
    (1.0 - 3.0 * InterpolantZero::LeastWeight) / (sum - 3.0 * InterpolantZero::LeastWeight);
  for (double& weight : weights)
  {
    weight = InterpolantZero::LeastWeight + (weight - InterpolantZero::LeastWeight) * rest;
  }
  return weights;
}

double LargestAtCorners(const FieldInterpolant& interpolant)
{
  double largest = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    largest = std::max(largest, std::norm(interpolant.At(interpolant.Flat().Corner(c))));
  }
  return std::sqrt(largest);
}

InterpolantZero Newton(
  const FieldInterpolant& interpolant, const std::array<double, 3>& start, double scale)
{
  const FlatTriangle& flat = interpolant.Flat();
  InterpolantZero zero;
  zero.Place = flat.Place(start);
  zero.Jet = interpolant.JetAt(zero.Place);
  for (int step = 0; step < MostSteps; ++step)
  {
    const double size = std::abs(zero.Jet.Value);
    if (size <= Vanishing * scale)
    {
      zero.Converged = true;
      break;
    }
    const double determinant = zero.Jet.Determinant();
    const Complex whole = (zero.Jet.AlongConjugate * std::conj(zero.Jet.Value) -
                            std::conj(zero.Jet.AlongZ) * zero.Jet.Value) /
      determinant;
    if (determinant == 0.0 || !std::isfinite(std::norm(whole)))
    {
      break;
    }
    bool isLower = false;
    double part = 1.0;
    for (int halving = 0; halving < MostHalvings && !isLower; ++halving, part *= 0.5)
    {
      const Complex place = flat.Place(KeptInside(flat.Weights(zero.Place + part * whole)));
      const FieldInterpolant::Jet jet = interpolant.JetAt(place);
      if (std::abs(jet.Value) < size * (1.0 - 1e-4 * part))
      {
        zero.Place = place;
        zero.Jet = jet;
        isLower = true;
      }
    }
    if (!isLower)
    {
      break;
    }
  }
  return zero;
}
}

InterpolantZero FindZero(const FieldInterpolant& interpolant, int sign)
{
  constexpr double third = 1.0 / 3.0;
  constexpr double near = 0.98;
  constexpr double far = 0.01;
  constexpr double half = 0.495;
  // The centroid, the middle between it and the corners, close to the edges' midpoints and to the
  // corners.
  constexpr std::array<std::array<double, 3>, 10> starts = { { { third, third, third },
    { 0.66, 0.17, 0.17 }, { 0.17, 0.66, 0.17 }, { 0.17, 0.17, 0.66 }, { half, half, far },
    { far, half, half }, { half, far, half }, { near, far, far }, { far, near, far },
    { far, far, near } } };
  const double scale = LargestAtCorners(interpolant);
  InterpolantZero best;
  bool isFirst = true;
  for (const auto& start : starts)
  {
    const InterpolantZero zero = Newton(interpolant, start, scale);
    if (zero.Converged && (sign == 0 || zero.Sign() == sign))
    {
      return zero;
    }
    if (isFirst || (zero.Converged && !best.Converged) ||
      (zero.Converged == best.Converged && std::norm(zero.Jet.Value) < std::norm(best.Jet.Value)))
    {
      best = zero;
      isFirst = false;
    }
  }
  return best;
}
}
