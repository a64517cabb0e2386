// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_PreparedField_h
#define DirectionFields_PreparedField_h

#include "Charts/FieldMatching.h"
#include "Distance/ClosestPoints.h"
#include "Features/KeptFeatures.h"
#include "OwnField/OwnField.h"
#include "Parametrization/ParametrizationCache.h"
#include "Preparation/PreparedSurface.h"
#include "Preparation/Seams.h"
#include "Progress.h"

#include <utility>
#include <vector>

namespace DirectionFields::Internal
{
/// What a field of the mesher's own is drawn to.
struct OwnShape
{
  // NOLINTNEXTLINE(google-explicit-constructor): an alignment alone is enough.
  OwnShape(const ShapeAlignment& alignment, std::vector<double> sizes = {})
    : Alignment(alignment)
    , Sizes(std::move(sizes))
  {
  }
  ShapeAlignment Alignment;
  /// The wanted size at each point of the input, as OwnFieldSettings::Sizes.
  std::vector<double> Sizes;

  bool operator==(const OwnShape& other) const
  {
    return this->Alignment == other.Alignment && this->Sizes == other.Sizes;
  }
};

/// A prepared surface with a field on it: everything about a mesh that does not depend on the
/// wanted length of its edges, but of how lengths at one place are to those at another one.
class PreparedField
{
public:
  /// The part of the constructor's progress after which the surface is prepared.
  static constexpr double PreparingShare = 0.3;

  /// Throws MeshError and Stopped.
  /// @param degree    4 or 6
  /// @param given     any of the directions of a field at each point of the input; empty for an
  ///                  OwnField
  /// @param own       how that is made
  PreparedField(const Surface& input, int degree, KeptEdges kept, WorkingLengths lengths,
    const std::vector<Vector3>& given, OwnShape own, const Progress& progress);

  /// Whether the same field would be prepared from these.
  bool IsFor(int degree, const KeptEdges& kept, const WorkingLengths& lengths,
    const std::vector<Vector3>& given, const OwnShape& own) const;

  const PreparedSurface& GetSurface() const { return this->Prepared; }
  const SurfaceGeometry& GetGeometry() const { return this->Prepared.GetGeometry(); }
  /// The field, over the vertices of the prepared surface.
  const std::vector<Complex>& GetSection() const { return this->Section; }
  const FieldMatching& GetMatching() const { return this->Matching; }
  const std::vector<char>& GetFeatures() const { return this->IsFeature; }
  const std::vector<char>& GetFrameless() const { return this->IsFrameless; }
  /// Not 0 for the vertices of the boundary where lines end, as SharpCorners::IsEnd.
  const std::vector<char>& GetCorners() const { return this->IsCorner; }
  /// The part of the length of features and boundary, from 0 to 1, that a given field crosses
  /// (CrossedFeatures); 0 for an OwnField, which follows them. Near these the field is not the
  /// given one but turns along them.
  double GetPartCrossed() const { return this->PartCrossed; }
  const Seams& GetSeams() const { return this->Joints; }
  /// The triangles of the input.
  const ClosestPoints& GetInputTriangles() const { return this->InputTriangles; }
  /// One for each component.
  std::vector<ParametrizationCache>& GetCaches() { return this->Caches; }

  /// Singularities that the surface did not need before it was smoothed; 0 where it was not.
  Index GetNeedless() const { return this->Needless; }
  /// The area of the prepared surface as part of its area before it was smoothed.
  double GetAreaLeft() const;

private:
  /// @param known as OwnField
  std::vector<Complex> ComputeField(
    const Progress& progress, const std::vector<Vector3>& known = {}) const;
  /// The given field, along features that it crosses, and continued to places where none is given.
  std::vector<Complex> GivenField(const Progress& progress);
  /// Smooths the surface, more and more, until its field has few singularities that it does not
  /// need: those of noise are no shape that the faces could show. It stops before that where the
  /// shape itself would go.
  void SmoothForField(const Progress& progress);
  /// The part of the vertices that smoothing has moved by more than a face.
  double PartMoved() const;
  /// By how much there are more singularities, away from features, than all together make up.
  Index CountNeedless() const;

  int Degree;
  KeptEdges Kept;
  WorkingLengths Lengths;
  std::vector<Vector3> Given;
  OwnShape Own;
  PreparedSurface Prepared;
  ClosestPoints InputTriangles;
  std::vector<char> IsFeature;
  std::vector<char> IsFrameless;
  std::vector<char> IsCorner;
  double PartCrossed = 0.0;
  std::vector<Complex> Section;
  FieldMatching Matching;
  Seams Joints;
  std::vector<ParametrizationCache> Caches;
  Index Needless = 0;
};
}

#endif
