// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "OwnField/OwnField.h"

#include "Computation/ComponentFields.h"
#include "Computation/Guide.h"
#include "Computation/Stages.h"
#include "Features/KeptFeatures.h"
#include "Guidance/Guidance.h"
#include "OwnField/SizeMetric.h"

#include <string>

namespace DirectionFields::Internal
{
namespace
{
/// The part of the cost of a singularity that is left where sizes vary: pairs that the sizes need
/// would not pay the rest.
constexpr double CostForSizes = 0.125;

/// Vectors along the features, at the points of the surface.
Guidance AlongFeatures(
  const Surface& surface, const SurfaceGeometry& geometry, const std::vector<char>& isFeature)
{
  const std::vector<Vector3> directions = FeatureDirections(geometry, isFeature);
  Guidance guidance;
  guidance.Vectors.assign(surface.Points.size(), Vector3::Zero());
  for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
  {
    if (!directions[v].isZero(0.0))
    {
      guidance.Vectors[geometry.Mesh.Point(v)] = directions[v];
    }
  }
  return guidance;
}
}

std::vector<Complex> OwnField(const std::shared_ptr<const Surface>& surface,
  const SurfaceGeometry& geometry, const std::vector<char>& isFeature,
  const OwnFieldSettings& settings, const Progress& progress)
{
  progress.Report(0.0);
  const std::vector<double> sizes = SizesOfMetric(geometry, settings.Sizes);
  Options options;
  options.Degree = settings.Degree;
  options.ConstrainBoundary = true;
  options.ConstrainGuidance = settings.FollowsFeatures;
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
  const Guidance guidance = AlongFeatures(*surface, geometry, isFeature);
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
