// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Guidance/CurveSamples.h"

#include <algorithm>

namespace DirectionFields::Internal
{
namespace
{
/// The most samples; curves that ask for more are sampled less densely.
constexpr double MostSamples = 2e6;
/// The most samples of a segment, or six for each triangle where that is more: no segment within
/// the box of a connected surface has as many, since the box is no longer than all edges together.
/// One that goes far beyond, as to a point out of place, costs no more than the surface does.
constexpr double LeastMostInSegment = 1e4;
}

CurveSteps::CurveSteps(
  const std::vector<std::vector<Vector3>>& curves, double step, std::size_t triangles)
{
  double total = 0.0;
  for (const std::vector<Vector3>& curve : curves)
  {
    ForEachSegment(curve, [&](const Vector3&, const Vector3&, double length) { total += length; });
  }
  this->Longest = std::max(step, total / MostSamples);
  this->MostInSegment = std::max(LeastMostInSegment, 6.0 * static_cast<double>(triangles));
}

Index CurveSteps::PiecesOf(double length) const
{
  return static_cast<Index>(
    std::clamp(std::ceil(length / this->Longest), 1.0, this->MostInSegment));
}

std::vector<CurveSample> SamplesOf(
  const std::vector<std::vector<Vector3>>& curves, const CurveSteps& steps)
{
  std::vector<CurveSample> samples;
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    ForEachSegment(curves[c],
      [&](const Vector3& start, const Vector3& end, double length)
      {
        const Index pieces = steps.PiecesOf(length);
        const Vector3 tangent = (end - start) / pieces;
        for (Index k = 0; k < pieces; ++k)
        {
          samples.push_back({ start + (k + 0.5) * tangent, tangent, c });
        }
      });
  }
  return samples;
}
}
