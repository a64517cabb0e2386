// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Placements_h
#define DirectionFields_Placements_h

#include "DirectionField.h"
#include "PrescribedSingularities/SingularityEditor.h"

#include <random>
#include <vector>

/// Singularities for tests of prescribed ones.
namespace Placements
{
using namespace DirectionFields;

inline EditOptions With(RotationObjective objective)
{
  EditOptions options;
  options.Objective = objective;
  return options;
}

inline Vector3 Middle(const Surface& surface, std::size_t t)
{
  const Triangle& triangle = surface.Triangles[t];
  return (surface.Points[triangle[0]] + surface.Points[triangle[1]] + surface.Points[triangle[2]]) /
    3.0;
}

/// Singularities of index 1 or -1 in different triangles, anywhere within them, whose sum is the one given.
inline std::vector<WantedSingularity> Random(
  const Surface& surface, int sum, int pairs, std::mt19937& random)
{
  const int count = std::abs(sum) + 2 * pairs;
  std::uniform_int_distribution<std::size_t> triangles(0, surface.Triangles.size() - 1);
  std::uniform_real_distribution<double> weight(0.1, 1.0);
  std::vector<std::size_t> taken;
  std::vector<WantedSingularity> wanted;
  while (static_cast<int>(wanted.size()) < count)
  {
    const std::size_t t = triangles(random);
    if (std::find(taken.begin(), taken.end(), t) != taken.end())
    {
      continue;
    }
    taken.push_back(t);
    const Vector3 weights(weight(random), weight(random), weight(random));
    Vector3 position = Vector3::Zero();
    for (int c = 0; c < 3; ++c)
    {
      position += weights[c] / weights.sum() * surface.Points[surface.Triangles[t][c]];
    }
    const int k = static_cast<int>(wanted.size());
    const int index = k < std::abs(sum) ? (sum > 0 ? 1 : -1) : (k % 2 == 0 ? 1 : -1);
    wanted.push_back({ position, index });
  }
  // An odd number in front of the pairs leaves them as many of each sign all the same.
  return wanted;
}

/// The singularities of a field as Direction Field gives them.
inline std::vector<WantedSingularity> Of(const Surface& surface, const Result& field)
{
  std::vector<WantedSingularity> wanted;
  for (std::size_t t = 0; t < field.SingularityIndex.size(); ++t)
  {
    if (field.SingularityIndex[t] != 0)
    {
      wanted.push_back({ Middle(surface, t), field.SingularityIndex[t] });
    }
  }
  return wanted;
}

inline int Sum(const std::vector<int>& values)
{
  int sum = 0;
  for (const int value : values)
  {
    sum += value;
  }
  return sum;
}
}

#endif
