// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Preparation/PreparedField.h"

#include "Guidance/Guidance.h"
#include "OwnField/CrossedFeatures.h"
#include "OwnField/SharpCorners.h"
#include "Refinement/LongEdges.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace DirectionFields::Internal
{
PreparedField::PreparedField(const Surface& input, int degree, KeptEdges kept,
  WorkingLengths lengths, const std::vector<Vector3>& given, OwnShape own, const Progress& progress)
  : Degree(degree)
  , Kept(std::move(kept))
  , Lengths(std::move(lengths))
  , Given(given)
  , Own(std::move(own))
  , Prepared(input, degree, this->Kept, this->Lengths, progress.Part(0.0, PreparingShare))
  , InputTriangles(this->Prepared.GetGivenTriangles())
  , IsFeature(this->Prepared.FindFeatures(this->Kept.Features))
  , IsFrameless(FramelessVertices(this->GetGeometry(), degree, this->IsFeature))
  , IsCorner(SharpCorners(this->GetGeometry(), degree, this->IsFeature, this->Lengths.Face).IsEnd)
  , Section(given.empty() ? this->ComputeField(progress.Part(0.4, 0.95))
                          : this->GivenField(progress.Part(0.4, 0.95)))
  , Matching(this->GetGeometry(), degree, this->Section)
  , Joints(this->GetGeometry().Mesh, this->Prepared.GetOriginals())
  , Caches(this->GetGeometry().Mesh.GetComponents().size())
{
  if (given.empty() && this->Lengths.MostNeedless != None)
  {
    this->SmoothForField(progress.Part(0.95, 1.0));
  }
  progress.Report(1.0);
}

namespace
{
double AreaOf(const TriangleMesh& mesh, const std::vector<Vector3>& positions)
{
  double area = 0.0;
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    const Vector3& p = positions[mesh.Tail(3 * t)];
    area +=
      0.5 * (positions[mesh.Tail(3 * t + 1)] - p).cross(positions[mesh.Tail(3 * t + 2)] - p).norm();
  }
  return area;
}
}

double PreparedField::GetAreaLeft() const
{
  if (this->Needless == 0)
  {
    return 1.0;
  }
  const TriangleMesh& mesh = this->GetGeometry().Mesh;
  const double before = AreaOf(mesh, this->Prepared.GetGivenPositions());
  return before > 0.0 ? AreaOf(mesh, this->GetGeometry().Positions) / before : 1.0;
}

double PreparedField::PartMoved() const
{
  const std::vector<Vector3> before = this->Prepared.GetGivenPositions();
  const std::vector<Vector3>& after = this->GetGeometry().Positions;
  Index moved = 0;
  for (std::size_t v = 0; v < after.size(); ++v)
  {
    moved += (after[v] - before[v]).norm() > this->Lengths.Face ? 1 : 0;
  }
  return static_cast<double>(moved) / static_cast<double>(std::max<std::size_t>(1, after.size()));
}

Index PreparedField::CountNeedless() const
{
  const TriangleMesh& mesh = this->GetGeometry().Mesh;
  std::vector<char> isOnFeature(mesh.GetNumberOfVertices(), 0);
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    if (this->IsFeature[e] != 0)
    {
      isOnFeature[mesh.Tail(mesh.HalfEdge(e))] = isOnFeature[mesh.Head(mesh.HalfEdge(e))] = 1;
    }
  }
  Index sum = 0;
  Index all = 0;
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    const bool isApart = isOnFeature[mesh.Tail(3 * t)] == 0 &&
      isOnFeature[mesh.Tail(3 * t + 1)] == 0 && isOnFeature[mesh.Tail(3 * t + 2)] == 0;
    sum += isApart ? this->Matching.SingularityIndex[t] : 0;
    all += isApart ? std::abs(this->Matching.SingularityIndex[t]) : 0;
  }
  return all - std::abs(sum);
}

std::vector<Complex> PreparedField::ComputeField(
  const Progress& progress, const std::vector<Vector3>& known) const
{
  const bool followsFeatures = this->Kept.Features.AreKept || this->Kept.HasHard();
  return OwnField(this->Prepared.GetSurface(), this->GetGeometry(), this->IsFeature,
    { this->Degree, followsFeatures, this->Own.Alignment, this->Lengths.Face,
      this->Own.Sizes.empty() ? this->Own.Sizes : this->Prepared.Continued(this->Own.Sizes) },
    known, progress);
}

void PreparedField::SmoothForField(const Progress& progress)
{
  constexpr int firstSteps = 4;
  constexpr int mostRounds = 6;
  // Singularities of noise go at once, those of a shape together with it. So a round that moves a
  // larger part of the vertices by more than a face is undone, unless it takes away the noise of a
  // rough surface.
  constexpr double mostMoved = 0.05;
  constexpr double mostLeft = 0.6;
  int steps = firstSteps;
  // Singularities of a shape are on surfaces that are not rough.
  constexpr Index fewNeedless = 32;
  Index most = this->Prepared.IsRough() ? std::min(fewNeedless, this->Lengths.MostNeedless)
                                        : this->Lengths.MostNeedless;
  Index needless = this->CountNeedless();
  for (int k = 0; k < mostRounds && needless > most; ++k)
  {
    const std::shared_ptr<const Surface> surface = this->Prepared.GetSurface();
    const std::vector<char> isFeature = this->IsFeature;
    const std::vector<char> isFrameless = this->IsFrameless;
    const std::vector<Complex> section = this->Section;
    const FieldMatching matching = this->Matching;
    this->Prepared.Smooth(this->IsFeature, steps);
    this->IsFeature = this->Prepared.FindFeatures(this->Kept.Features);
    this->IsFrameless = FramelessVertices(this->GetGeometry(), this->Degree, this->IsFeature);
    this->Section = this->ComputeField(
      progress.Part(static_cast<double>(k) / mostRounds, (k + 1.0) / mostRounds));
    this->Matching = FieldMatching(this->GetGeometry(), this->Degree, this->Section);
    const Index left = this->CountNeedless();
    const bool isNoise = this->Prepared.IsRough() &&
      static_cast<double>(left) <= mostLeft * static_cast<double>(needless);
    if (!isNoise && this->PartMoved() > mostMoved)
    {
      this->Prepared.MoveTo(surface);
      this->IsFeature = isFeature;
      this->IsFrameless = isFrameless;
      this->Section = section;
      this->Matching = matching;
      return;
    }
    this->Needless = std::max(this->Needless, needless);
    needless = left;
    most = this->Lengths.MostNeedless;
    steps *= 4;
  }
}

bool PreparedField::IsFor(int degree, const KeptEdges& kept, const WorkingLengths& lengths,
  const std::vector<Vector3>& given, const OwnShape& own) const
{
  // The surface may have been prepared for its features, but for the shortest length.
  const bool hasSameFeatures = this->Kept.Features.AreKept == kept.Features.AreKept &&
    this->Kept.Features.Angle == kept.Features.Angle &&
    this->Kept.Features.MinimumLength == kept.Features.MinimumLength;
  const bool hasSameRoom = this->Kept.SoftRoom == kept.SoftRoom ||
    (this->Kept.SoftRoom > 0.0 && kept.SoftRoom > 0.0 && !this->Prepared.DependsOnRoom());
  return this->Degree == degree && hasSameFeatures && hasSameRoom &&
    this->Kept.Regions == kept.Regions && this->Kept.Curves == kept.Curves &&
    this->Kept.Points == kept.Points && this->Given == given && this->Lengths == lengths &&
    (!given.empty() || this->Own == own) &&
    this->IsFeature == this->Prepared.FindFeatures(kept.Features);
}

std::vector<Complex> PreparedField::GivenField(const Progress& progress)
{
  // Over this distance, in lengths of edges, the field turns to features that it crosses.
  constexpr double turning = 4.0;
  constexpr double leastCrossed = 0.01;
  const SurfaceGeometry& geometry = this->GetGeometry();
  std::vector<Index> inCorners;
  const SharpCorners corners(geometry, this->Degree, this->IsFeature, this->Lengths.Face);
  for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
  {
    if (!corners.Directions[v].isZero(0.0))
    {
      inCorners.push_back(v);
    }
  }
  const bool isFinished = inCorners.empty() && !this->Prepared.IsRefined();
  Guidance guidance;
  guidance.Vectors = isFinished ? this->Prepared.Continued(this->Given)
                                : this->Prepared.ContinuedToCopies(this->Given);
  std::vector<Complex> section = GuidanceSection(geometry, guidance, this->Degree);
  const CrossedFeatures crossed(geometry, this->Degree, this->IsFeature, section);
  this->PartCrossed = crossed.GetPart();
  // On round bodies the given field is a better guide than jagged edges.
  const bool turns =
    this->PartCrossed > leastCrossed && !this->Prepared.IsRough() && IsMostlyFlat(geometry);
  const bool isKnown =
    std::any_of(section.begin(), section.end(), [](const Complex& u) { return u != 0.0; });
  if (!isKnown || (isFinished && !turns))
  {
    Continue(geometry, this->Degree, section);
    return section;
  }
  const std::vector<char> isNear =
    crossed.FindNear(turns ? turning * this->Lengths.Face : 0.0, inCorners);
  std::vector<Vector3> known(section.size(), Vector3::Zero());
  for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
  {
    const bool isGiven = isNear[v] == 0 && section[v] != 0.0;
    known[v] = isGiven ? guidance.Vectors[geometry.Mesh.Point(v)] : crossed.GetAlong()[v];
  }
  return this->ComputeField(progress, known);
}
}
