// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Preparation/AffordableFeatures.h"

#include "Charts/FeatureLines.h"
#include "Geometry/DihedralAngles.h"
#include "Mesh/MergePoints.h"
#include "Support/Sentences.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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

AccidentalFeatures::AccidentalFeatures(const SurfaceGeometry& geometry, double angle)
  : Wanted(angle)
{
  constexpr std::size_t bands = 6;
  constexpr double step = 1.125;
  constexpr double least = 0.02;
  const std::vector<double> dihedral = DihedralAngles(geometry);
  std::array<double, bands> lengths{};
  double all = 0.0;
  for (Index e = 0; e < geometry.Mesh.GetNumberOfEdges(); ++e)
  {
    const double times = std::abs(dihedral[e]) * 180.0 / Pi / angle;
    if (!(times > 1.0))
    {
      continue;
    }
    const Index h = geometry.Mesh.HalfEdge(e);
    const double length =
      (geometry.Positions[geometry.Mesh.Head(h)] - geometry.Positions[geometry.Mesh.Tail(h)])
        .norm();
    const double band = std::log(times) / std::log(step);
    all += length;
    if (band < static_cast<double>(bands))
    {
      lengths[static_cast<std::size_t>(band)] += length;
    }
  }
  this->IsAny = all > 0.0 &&
    std::all_of(lengths.begin(), lengths.end(), [&](double each) { return each > least * all; });
}

std::string AccidentalFeatures::Sentence() const
{
  return "No edges are features: the surface bends at its edges by all angles around the Feature "
         "Angle of " +
    Figure(this->Wanted) +
    " degrees, as bent ones of few triangles do, and faces along them would be triangles or "
    "folded. Curves that are given, as those of Feature Edges, are kept all the same.";
}
}
