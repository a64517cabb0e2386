// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Preparation/PreparedField.h"

#include "Computation/ComponentFields.h"
#include "Computation/Guide.h"
#include "Computation/Stages.h"
#include "Guidance/Guidance.h"

#include <string>
#include <utility>

namespace DirectionFields::Internal
{
PreparedField::PreparedField(const Surface& input, int degree, const FeatureSettings& settings,
  std::vector<double> longest, const std::vector<Vector3>& given, const Progress& progress)
  : Degree(degree)
  , Longest(std::move(longest))
  , Given(given)
  , Prepared(input, degree, settings, this->Longest, progress.Part(0.0, PreparingShare))
  , InputTriangles(this->Prepared.GetTriangles())
  , IsFeature(this->Prepared.FindFeatures(settings))
  , IsFrameless(FramelessVertices(this->GetGeometry(), degree, this->IsFeature))
  , Section(
      given.empty() ? this->SmoothestField(settings, progress.Part(0.4, 0.95)) : this->GivenField())
  , Matching(this->GetGeometry(), degree, this->Section)
  , Joints(this->GetGeometry().Mesh, this->Prepared.GetOriginals())
  , Caches(this->GetGeometry().Mesh.GetComponents().size())
{
  progress.Report(1.0);
}

bool PreparedField::IsFor(int degree, const FeatureSettings& settings,
  const std::vector<double>& longest, const std::vector<Vector3>& given) const
{
  return this->Degree == degree && this->Given == given && this->Longest == longest &&
    this->IsFeature == this->Prepared.FindFeatures(settings);
}

Guidance PreparedField::AlongFeatures() const
{
  const SurfaceGeometry& geometry = this->GetGeometry();
  const std::vector<Vector3> directions = FeatureDirections(geometry, this->IsFeature);
  Guidance guidance;
  guidance.Vectors.assign(this->Prepared.GetSurface()->Points.size(), Vector3::Zero());
  for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
  {
    if (!directions[v].isZero(0.0))
    {
      guidance.Vectors[geometry.Mesh.Point(v)] = directions[v];
    }
  }
  return guidance;
}

std::vector<Complex> PreparedField::SmoothestField(
  const FeatureSettings& settings, const Progress& progress) const
{
  progress.Report(0.0);
  Options options;
  options.Degree = this->Degree;
  options.ConstrainBoundary = true;
  options.ConstrainGuidance = settings.AreKept;
  options.MergePoints = MergePoints::Off;
  options.UnitLength = true;
  std::vector<std::string> notes;
  const Guidance guidance = this->AlongFeatures();
  Stages stages(this->Prepared.GetSurface());
  const Guide guide(stages, options, guidance, notes);
  constexpr double afterEnergy = 0.55;
  EnergyStage& energy = stages.GetEnergy(options, progress.Part(0.0, afterEnergy));
  return SolveComponents(stages, energy, guide, {}, options, false, progress.Part(afterEnergy, 1.0))
    .Section;
}

std::vector<Complex> PreparedField::GivenField() const
{
  Guidance guidance;
  guidance.Vectors = this->Prepared.Continued(this->Given);
  std::vector<Complex> section = GuidanceSection(this->GetGeometry(), guidance, this->Degree);
  Continue(this->GetGeometry(), this->Degree, section);
  return section;
}
}
