// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "OwnField/OwnField.h"

#include "Computation/ComponentFields.h"
#include "Computation/Guide.h"
#include "Computation/Stages.h"
#include "Features/KeptFeatures.h"
#include "Guidance/Guidance.h"
#include "OwnField/FreeEnds.h"
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

/// Replaces the guidance of vertices where there is a direction.
void Replace(const TriangleMesh& mesh, const std::vector<Vector3>& directions, Guidance& guidance)
{
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (!directions[v].isZero(0.0))
    {
      guidance.Vectors[mesh.Point(v)] = directions[v];
    }
  }
}

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
  Replace(geometry.Mesh, aroundHoles, guidance);
  Replace(geometry.Mesh, directions, guidance);
  Replace(geometry.Mesh, inCorners, guidance);
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
  Guidance guidance = GuidanceFor(*surface, geometry, isFeature, settings, known);
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
  constexpr double afterEnergy = 0.55;
  EnergyStage& energy = stages.GetEnergy(options, progress.Part(0.0, afterEnergy));
  const auto solve = [&](const Progress& part)
  {
    const Guide guide(stages, options, guidance, notes);
    return SolveComponents(stages, energy, guide, {}, options, false, part).Section;
  };
  constexpr double afterFirst = 0.95;
  std::vector<Complex> section = solve(progress.Part(afterEnergy, afterFirst));
  if (known.empty() && settings.FollowsFeatures)
  {
    const FreeEnds ends(stages.GetGeometry(), settings.Degree, isFeature, section, settings.Face);
    if (!ends.IsEmpty())
    {
      Replace(geometry.Mesh, ends.Directions(), guidance);
      section = solve(progress.Part(afterFirst, 1.0));
    }
  }
  if (!sizes.empty())
  {
    TurnToFrames(stages.GetGeometry(), geometry, settings.Degree, section);
  }
  return section;
}
}
