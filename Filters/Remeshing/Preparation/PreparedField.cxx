// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Preparation/PreparedField.h"

#include "Guidance/Guidance.h"

#include <utility>

namespace DirectionFields::Internal
{
PreparedField::PreparedField(const Surface& input, int degree, const FeatureSettings& settings,
  WorkingLengths lengths, const std::vector<Vector3>& given, const ShapeAlignment& alignment,
  const Progress& progress)
  : Degree(degree)
  , Lengths(std::move(lengths))
  , Given(given)
  , Alignment(alignment)
  , Prepared(input, degree, settings, this->Lengths, progress.Part(0.0, PreparingShare))
  , InputTriangles(this->Prepared.GetTriangles())
  , IsFeature(this->Prepared.FindFeatures(settings))
  , IsFrameless(FramelessVertices(this->GetGeometry(), degree, this->IsFeature))
  , Section(given.empty()
        ? OwnField(this->Prepared.GetSurface(), this->GetGeometry(), this->IsFeature,
            { degree, settings.AreKept, alignment }, progress.Part(0.4, 0.95))
        : this->GivenField())
  , Matching(this->GetGeometry(), degree, this->Section)
  , Joints(this->GetGeometry().Mesh, this->Prepared.GetOriginals())
  , Caches(this->GetGeometry().Mesh.GetComponents().size())
{
  progress.Report(1.0);
}

bool PreparedField::IsFor(int degree, const FeatureSettings& settings,
  const WorkingLengths& lengths, const std::vector<Vector3>& given,
  const ShapeAlignment& alignment) const
{
  return this->Degree == degree && this->Given == given && this->Lengths == lengths &&
    (!given.empty() || this->Alignment == alignment) &&
    this->IsFeature == this->Prepared.FindFeatures(settings);
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
