// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Preparation/AffordableFeatures.h"

#include "Charts/FeatureLines.h"
#include "Mesh/MergePoints.h"
#include "Support/Sentences.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Edges that are sharper than this are more than how finely a bent surface is cut into triangles.
constexpr double UsualAngle = 30.0;
/// How many angles, each this many times the one before, are between the least and the usual one.
constexpr int Angles = 16;
/// Features may meet at one point in this many faces, and at these numbers of points.
constexpr double FacesPerPoint = 20.0;
constexpr double FewPoints = 100.0;
constexpr double ManyPoints = 1000.0;

Index CountMeeting(const SurfaceGeometry& geometry, const FeatureSettings& settings, int degree)
{
  const std::vector<char> isFrameless =
    FramelessVertices(geometry, degree, FindFeatures(geometry, settings));
  return static_cast<Index>(std::count(isFrameless.begin(), isFrameless.end(), 1));
}
}

AffordableFeatures::AffordableFeatures(
  const Surface& input, const FeatureSettings& wanted, int degree, double faces)
  : Settings(wanted)
  , Wanted(wanted.Angle)
{
  this->Settings.Angle = std::max(LeastFeatureAngle, wanted.Angle);
  // Infinite where the points are so far apart that they are refused later.
  if (!wanted.AreKept || wanted.Angle >= UsualAngle || !std::isfinite(faces))
  {
    return;
  }
  MergedMesh merged = MergedMesh::AcrossSeams(input);
  const SurfaceGeometry geometry(std::move(merged.Mesh), input);
  const double most = std::clamp(faces / FacesPerPoint, FewPoints, ManyPoints);
  this->Meeting = CountMeeting(geometry, this->Settings, degree);
  if (this->Meeting <= most)
  {
    return;
  }
  const double least = this->Settings.Angle;
  int tooMany = 0;
  int few = Angles;
  while (few - tooMany > 1)
  {
    const int middle = (few + tooMany) / 2;
    this->Settings.Angle = least * std::pow(UsualAngle / least, double(middle) / Angles);
    (CountMeeting(geometry, this->Settings, degree) <= most ? few : tooMany) = middle;
  }
  this->Settings.Angle = least * std::pow(UsualAngle / least, double(few) / Angles);
}

std::vector<std::string> AffordableFeatures::Sentences() const
{
  if (this->Settings.Angle <= std::max(LeastFeatureAngle, this->Wanted))
  {
    return {};
  }
  return {
    "Features of a Feature Angle of " + Figure(this->Wanted) + " would meet or end at " +
    std::to_string(this->Meeting) + " points, more than the faces can follow. Those of less than " +
    Figure(this->Settings.Angle) +
    " degrees are left out. That angle, or a larger one, gives the same mesh without this sentence."
  };
}
}
