// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrivialConnection/RotationAtPlace.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
bool CanHaveIndex(int index, double holonomy)
{
  return std::abs(2.0 * Pi * index - holonomy) <= 3.0 * MostRotation;
}

std::array<double, 3> WithinTriangle(std::array<double, 3> weights)
{
  double sum = 0.0;
  for (double& weight : weights)
  {
    weight = std::max(weight, LeastWeightOfPlace);
    sum += weight;
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

std::optional<std::array<double, 3>> RotationAround(
  const FlatTriangle& triangle, const std::array<double, 3>& weights, int index, double holonomy)
{
  if (!CanHaveIndex(index, holonomy))
  {
    return std::nullopt;
  }
  const Complex place = triangle.Place(WithinTriangle(weights));
  std::array<double, 3> rotation;
  const double even = (2.0 * Pi * index - holonomy) / 3.0;
  // Even rotations are small enough: the least fraction of the step towards them that makes all of
  // them so.
  double part = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const double seen =
      std::arg((triangle.Corner((c + 1) % 3) - place) * std::conj(triangle.Corner(c) - place));
    rotation[c] = index * seen - holonomy / 3.0;
    if (std::abs(rotation[c]) > MostRotation)
    {
      const double limit = rotation[c] > 0.0 ? MostRotation : -MostRotation;
      part = std::max(part, (rotation[c] - limit) / (rotation[c] - even));
    }
  }
  for (double& angle : rotation)
  {
    angle += std::min(part, 1.0) * (even - angle);
  }
  return rotation;
}
}
