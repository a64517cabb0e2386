// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "OwnField/OwnField.h"

#include "Computation/ComponentFields.h"
#include "Computation/Guide.h"
#include "Computation/Stages.h"
#include "Features/KeptFeatures.h"
#include "Guidance/Guidance.h"
#include "OwnField/HoleBands.h"
#include "OwnField/SharpCorners.h"
#include "OwnField/SizeMetric.h"

#include <algorithm>
#include <string>

namespace DirectionFields::Internal
{
namespace
{
/// The part of the cost of a singularity that is left where sizes vary: pairs that the sizes need
/// would not pay the rest.
constexpr double CostForSizes = 0.125;

/// The directions that are given, or else those along the features and around holes, and those in
/// sharp corners.
Guidance GuidanceFor(const Surface& surface, const SurfaceGeometry& geometry,
  const std::vector<char>& isFeature, const OwnFieldSettings& settings,
  const std::vector<Vector3>& known)
{
  std::vector<Vector3> directions = !known.empty() ? known
    : settings.FollowsFeatures
    ? FeatureDirections(geometry, isFeature)
    : std::vector<Vector3>(geometry.Mesh.GetNumberOfVertices(), Vector3::Zero());
  // Where sizes are given the room around a hole is theirs.
  const bool hasBands = known.empty() && settings.FollowsFeatures && settings.Sizes.empty();
  const std::vector<Vector3> aroundHoles = hasBands
    ? HoleBands(geometry, settings.Degree, isFeature, settings.Face)
    : std::vector<Vector3>(directions.size(), Vector3::Zero());
  const std::vector<Vector3> inCorners =
    SharpCorners(geometry, settings.Degree, isFeature, settings.Face).Directions;
  Guidance guidance;
  guidance.Vectors.assign(surface.Points.size(), Vector3::Zero());
  for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
  {
    const Vector3& direction = !inCorners[v].isZero(0.0) ? inCorners[v]
      : !directions[v].isZero(0.0)                       ? directions[v]
                                                         : aroundHoles[v];
    if (!direction.isZero(0.0))
    {
      guidance.Vectors[geometry.Mesh.Point(v)] = direction;
    }
  }
  return guidance;
}
}

std::vector<Complex> OwnField(const std::shared_ptr<const Surface>& surface,
  const SurfaceGeometry& geometry, const std::vector<char>& isFeature,
  const OwnFieldSettings& settings, const std::vector<Vector3>& known, const Progress& progress)
{
  progress.Report(0.0);
  const std::vector<double> sizes = SizesOfMetric(geometry, settings.Sizes);
  Options options;
  options.Degree = settings.Degree;
  options.ConstrainBoundary = known.empty();
  const Guidance guidance = GuidanceFor(*surface, geometry, isFeature, settings, known);
  options.ConstrainGuidance = std::any_of(guidance.Vectors.begin(), guidance.Vectors.end(),
    [](const Vector3& vector) { return !vector.isZero(0.0); });
  options.MergePoints = MergePoints::Off;
  options.UnitLength = true;
  if (settings.Alignment.Strength > 0.0)
  {
    options.Alignment = Alignment::PrincipalCurvature;
    options.AlignmentStrength = settings.Alignment.Strength;
    options.SingularityCost =
      (sizes.empty() ? 1.0 : CostForSizes) * settings.Alignment.SingularityCost;
  }
  std::vector<std::string> notes;
  Stages stages(surface, MergePoints::Off, sizes);
  const Guide guide(stages, options, guidance, notes);
  constexpr double afterEnergy = 0.55;
  EnergyStage& energy = stages.GetEnergy(options, progress.Part(0.0, afterEnergy));
  std::vector<Complex> section =
    SolveComponents(stages, energy, guide, {}, options, false, progress.Part(afterEnergy, 1.0))
      .Section;
  if (!sizes.empty())
  {
    TurnToFrames(stages.GetGeometry(), geometry, settings.Degree, section);
  }
  return section;
}
}
