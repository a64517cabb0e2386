// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_QualityReport_h
#define DirectionFields_QualityReport_h

#include "Quality/FaceQuality.h"

#include <string>
#include <vector>

namespace DirectionFields
{
/// What a program that computes on a mesh asks of its faces. 0 is no limit.
struct QualityLimits
{
  /// Range 0 to 1.
  double MinimumScaledJacobian = 0.0;
  /// At least 0; no face keeps one below 1.
  double MaximumAspectRatio = 0.0;
  /// Range 0 to 2.
  double MaximumWarpage = 0.0;

  bool HasAny() const
  {
    return MinimumScaledJacobian > 0.0 || MaximumAspectRatio > 0.0 || MaximumWarpage > 0.0;
  }
};

/// What the faces of a mesh are like altogether, and which of them fail. Without faces the figures
/// are those of squares.
struct QualityReport
{
  double LeastScaledJacobian = 1.0;
  double MeanScaledJacobian = 1.0;
  double LargestAspectRatio = 1.0;
  double LargestWarpage = 0.0;
  /// Whether there are limits.
  bool IsLimited = false;
  /// Of each face 1 if it keeps all limits, else 0; empty without limits.
  std::vector<char> Pass;
  Index FailedFaces = 0;
  /// For the user if there are such faces, with a remedy.
  std::vector<std::string> Sentences;
};

/// Throws std::invalid_argument, its text a sentence for the user, for limits out of range.
QualityReport ReportQuality(const FaceQuality& quality, const QualityLimits& limits = {});
}

#endif
