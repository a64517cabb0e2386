// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CurveSamples_h
#define DirectionFields_CurveSamples_h

#include "Types.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace DirectionFields::Internal
{
/// A piece of a curve.
struct CurveSample
{
  /// Its middle.
  Vector3 Place;
  /// Of the length of the piece.
  Vector3 Tangent;
  /// The number of its curve.
  std::size_t Curve;
};

/// Calls body(start, end, length) for all segments of finite places of a curve that have a length.
template <typename Body>
void ForEachSegment(const std::vector<Vector3>& curve, const Body& body)
{
  for (std::size_t i = 0; i + 1 < curve.size(); ++i)
  {
    const double length = (curve[i + 1] - curve[i]).stableNorm();
    if (std::isfinite(length) && length > 0.0)
    {
      body(curve[i], curve[i + 1], length);
    }
  }
}

/// How finely curves are sampled.
class CurveSteps
{
public:
  /// @param step      the longest piece wanted; longer ones are taken where there would be more
  ///                  than 2e6 of them
  /// @param triangles of the surface
  CurveSteps(const std::vector<std::vector<Vector3>>& curves, double step, std::size_t triangles);

  /// The number of equal pieces of a segment.
  Index PiecesOf(double length) const;

private:
  double Longest;
  double MostInSegment;
};

/// The pieces of curves.
std::vector<CurveSample> SamplesOf(
  const std::vector<std::vector<Vector3>>& curves, const CurveSteps& steps);
}

#endif
