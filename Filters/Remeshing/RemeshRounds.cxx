// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remesh.h"

#include "Finishing/CloserMesh.h"
#include "Finishing/FaceSources.h"
#include "Finishing/ThinParts.h"
#include "Preparation/AffordableFeatures.h"
#include "Preparation/PreparedField.h"
#include "Preparation/WantedSizes.h"
#include "Quality/FaceQuality.h"
#include "Sizes/BorderSizes.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace DirectionFields
{
namespace
{
/// How often a mesh with smaller faces at its thin parts is made.
constexpr int MostShrinkings = 3;
/// Distances that are a smaller part of the edge length are the same.
constexpr double Negligible = 1e-3;
/// Lengths of the grid's edges, as parts of the wanted one, for which a bad mesh is made anew.
constexpr std::array<double, 2> OtherLengths = { 0.98, 1.02 };

/// Whether faces that are turned over are a reason to make another mesh. Without lines that are
/// kept whatever the shape is, they are where the surface is too thin for its faces.
bool HasHardLines(const RemeshResult& mesh)
{
  return std::any_of(mesh.Chains.begin(), mesh.Chains.end(),
    [](const MeshChain& chain)
    { return chain.Kind == ChainKind::Border || chain.Kind == ChainKind::Curve; });
}

/// What soft features cost.
struct SoftFeatureStanding
{
  /// Where quads are wanted.
  Index Triangles;
  double LeastQuality;
  int MissedHoles;
  /// PreparedField::GetPartCrossed.
  double PartCrossed;
};

SoftFeatureStanding SoftFeatureStandingOf(
  const RemeshResult& mesh, Element element, double partCrossed)
{
  return { element == Element::Quads ? mesh.Triangles : 0, LeastQuality(mesh.Points, mesh.Faces),
    std::abs(mesh.EulerCharacteristicAfter - mesh.EulerCharacteristicBefore), partCrossed };
}

/// A mesh with a worse face than this may be better without soft features.
constexpr double InDoubt = 0.3;
/// Fields that are given cross soft features where that is more of their length.
constexpr double LeastCrossed = 0.01;

bool IsInDoubt(const SoftFeatureStanding& mesh)
{
  return mesh.Triangles > 0 || mesh.LeastQuality < InDoubt || mesh.MissedHoles > 0 ||
    mesh.PartCrossed > LeastCrossed;
}

/// Whether a mesh without soft features is the better one.
bool IsWorthLeavingOut(const SoftFeatureStanding& with, const SoftFeatureStanding& without)
{
  constexpr double leastGain = 0.02;
  if (without.MissedHoles != with.MissedHoles)
  {
    return without.MissedHoles < with.MissedHoles;
  }
  if (without.PartCrossed < with.PartCrossed - LeastCrossed)
  {
    return true;
  }
  return without.Triangles < with.Triangles ||
    (without.Triangles == with.Triangles && with.LeastQuality < InDoubt &&
      without.LeastQuality > with.LeastQuality + leastGain);
}

MeshStanding StandingOf(const RemeshResult& mesh)
{
  const auto points = std::count_if(mesh.Chains.begin(), mesh.Chains.end(),
    [](const MeshChain& chain) { return chain.Kind == ChainKind::Point; });
  const auto lost = static_cast<Index>(mesh.RegionsShown.Lost.size());
  return { std::max(mesh.MaximumDistance, mesh.MaximumDistanceToMesh),
    std::min(LeastQuality(mesh.Points, mesh.Faces),
      mesh.TurnedFaces > 0 && HasHardLines(mesh) ? 0.0 : 1.0),
    std::abs(mesh.EulerCharacteristicAfter - mesh.EulerCharacteristicBefore),
    Negligible * mesh.EdgeLength, mesh.RegionsShown.Regions - lost + static_cast<Index>(points) };
}

/// A sentence may be empty.
void AddSentence(const std::string& sentence, std::vector<std::string>& notes)
{
  if (!sentence.empty())
  {
    notes.push_back(sentence);
  }
}

/// The part of the progress in which the surface is looked at.
constexpr double BeforeFirst = 0.2;
/// Accidental features that meet or end at more points than these, and than one in twenty faces,
/// are left out if a mesh without them is good: each is a point of the grid that its neighbours
/// depend on.
constexpr double FewMeetingPoints = 100.0;
constexpr double PointsPerFace = 0.05;

/// The part of the faces that are triangles where quads are wanted, nearly flat, folded or turned
/// over.
double PartOfBadFaces(const RemeshResult& mesh, Element element)
{
  const FaceQuality quality = QualityOf(mesh.Points, mesh.Faces);
  const auto bad = (element == Element::Quads ? mesh.Triangles : 0) + mesh.TurnedFaces +
    std::count_if(quality.ScaledJacobian.begin(), quality.ScaledJacobian.end(),
      [](double each) { return each < LeastUsable; });
  const auto all = static_cast<double>(std::max<std::size_t>(1, mesh.Faces.size()));
  return static_cast<double>(bad) / all;
}

/// Whether a mesh without accidental features is taken before one with them is made.
bool IsGoodWithout(const RemeshResult& mesh, Element element)
{
  constexpr double fewBad = 0.01;
  constexpr double closeEnough = 1.5;
  return StandingOf(mesh).Farthest < closeEnough * mesh.EdgeLength &&
    PartOfBadFaces(mesh, element) <= fewBad;
}

/// Whether a mesh with accidental features, before any rounds, is better than the best one without.
bool IsBetterThanWithout(const RemeshResult& with, const RemeshResult& without, Element element)
{
  const MeshStanding standing = StandingOf(with);
  const MeshStanding other = StandingOf(without);
  return standing.MissedHoles <= other.MissedHoles && standing.KeptParts >= other.KeptParts &&
    standing.Farthest < std::max(with.EdgeLength, AboutAsClose * other.Farthest) &&
    PartOfBadFaces(with, element) < PartOfBadFaces(without, element);
}
}

std::vector<double> Remesh::LengthsAtArcs(const RemeshOptions& options) const
{
  if (!options.KeepThinParts || options.Regions.empty() || !options.Sizing.empty())
  {
    return {};
  }
  const double area =
    RelativeArea(*this->Input, std::vector<double>(this->Input->Points.size(), 1.0));
  return LengthsAtBorders(*this->Input, options.Regions, EdgeLengthFor(area, options));
}

RemeshOptions Remesh::MakeFirst(const RemeshOptions& options,
  const std::vector<Vector3>& directions, const ThinParts& thin, const Progress& progress,
  RemeshResult& result)
{
  this->MakeOnce(options, directions, thin, 1.0, progress, result);
  if (!this->Cache->GetSurface().HasSoft())
  {
    return options;
  }
  const auto standingOf = [&](const RemeshResult& mesh)
  { return SoftFeatureStandingOf(mesh, options.Element, this->Cache->GetPartCrossed()); };
  const SoftFeatureStanding with = standingOf(result);
  if (!IsInDoubt(with))
  {
    return options;
  }
  RemeshOptions without = options;
  without.KeepSoftFeatures = false;
  RemeshResult other;
  this->MakeOnce(without, directions, thin, 1.0, progress, other);
  if (!IsWorthLeavingOut(with, standingOf(other)))
  {
    return options;
  }
  result = std::move(other);
  return without;
}

bool Remesh::MakeRounds(const RemeshOptions& given, const std::vector<Vector3>& directions,
  const RemeshResult* without, const Progress& progress, RemeshResult& result)
{
  const std::vector<double> wanted = given.Sizing.empty()
    ? std::vector<double>()
    : ClampedSizes(given.Sizing, this->Input->Points.size());
  const double smallest = wanted.empty() ? 1.0 : *std::min_element(wanted.begin(), wanted.end());
  ThinParts thin(*this->Input, wanted, this->LengthsAtArcs(given));
  const RemeshOptions options =
    this->MakeFirst(given, directions, thin, progress.Part(0.0, AfterFirst), result);
  if (without && !IsBetterThanWithout(result, *without, given.Element))
  {
    return false;
  }
  const double edgeLength = result.EdgeLength;
  RemeshResult last;
  bool isLastTaken = true;
  // Roughness of the surface is no part of it that gets lost.
  const bool isRough = this->Cache->GetNeedless() > 0;
  // The boundary may make many more faces than are wanted, which are not to become more.
  constexpr double mostCrowded = 4.0;
  const bool isCrowded = !options.UseEdgeLength &&
    static_cast<double>(result.Faces.size()) > mostCrowded * options.NumberOfFaces;
  const int most = options.KeepThinParts && !isRough && !isCrowded ? MostShrinkings : 0;
  for (int k = 0; k < most; ++k)
  {
    const RemeshResult& former = k == 0 ? result : last;
    if (!(StandingOf(former).Farthest > smallest * edgeLength) ||
      !thin.Shrink(this->Cache->GetInputTriangles(),
        DistancesBothWays(*this->Input, former.Points, former.Faces, former.FaceSource),
        edgeLength))
    {
      break;
    }
    const auto afterRound = [](int round)
    { return AfterFirst + (AfterShrinkings - AfterFirst) * round / MostShrinkings; };
    RemeshResult smaller;
    this->MakeOnce(
      options, directions, thin, 1.0, progress.Part(afterRound(k), afterRound(k + 1)), smaller);
    AddSentence(thin.Sentence(this->Origin, this->Unit), smaller.Notes);
    last = std::move(smaller);
    isLastTaken = IsCloser(StandingOf(last), StandingOf(result));
    if (isLastTaken)
    {
      result = last;
    }
    else if (this->IsCostly)
    {
      break;
    }
  }
  // Other integers are as good for the energy, and by chance for the faces or not.
  const bool mayVary = !isRough && !isCrowded && !this->IsCostly && options.SmoothingIterations > 0;
  const auto isBad = [&](const MeshStanding& standing) {
    return standing.LeastQuality < LeastUsable || (!isLastTaken && standing.Farthest > edgeLength);
  };
  for (std::size_t k = 0; k < OtherLengths.size() && mayVary && isBad(StandingOf(result)); ++k)
  {
    const auto afterTrial = [](std::size_t trials)
    {
      return AfterShrinkings +
        (1.0 - AfterShrinkings) * static_cast<double>(trials) / OtherLengths.size();
    };
    RemeshResult other;
    this->MakeOnce(options, directions, thin, OtherLengths[k],
      progress.Part(afterTrial(k), afterTrial(k + 1)), other);
    AddSentence(thin.Sentence(this->Origin, this->Unit), other.Notes);
    if (IsCloser(StandingOf(other), StandingOf(result)))
    {
      result = std::move(other);
    }
  }
  return true;
}

std::string Remesh::AboutAccidental(
  const RemeshOptions& options, const std::vector<Vector3>& directions, const Progress& progress)
{
  if (!options.KeepFeatures)
  {
    return {};
  }
  const WantedSizes sizes =
    this->Prepare(options, directions, ThinParts(*this->Input, {}), progress);
  const double faces =
    RelativeArea(*this->Input, sizes.AtPoints) / (sizes.EdgeLength * sizes.EdgeLength);
  const std::vector<char>& isFrameless = this->Cache->GetFrameless();
  const auto meeting = std::count(isFrameless.begin(), isFrameless.end(), 1);
  if (!(static_cast<double>(meeting) > std::max(FewMeetingPoints, PointsPerFace * faces)))
  {
    return {};
  }
  const AccidentalFeatures accidental(this->Cache->GetGeometry(), options.FeatureAngle);
  return accidental.IsAny ? accidental.Sentence() : std::string();
}

void Remesh::Make(const RemeshOptions& options, const std::vector<Vector3>& directions,
  const Progress& progress, RemeshResult& result)
{
  const std::string sentence =
    this->AboutAccidental(options, directions, progress.Part(0.0, BeforeFirst));
  if (sentence.empty())
  {
    this->MakeRounds(options, directions, nullptr, progress, result);
    return;
  }
  // Tips of cones stay.
  RemeshOptions withoutFeatures = options;
  withoutFeatures.FeatureAngle = 180.0;
  withoutFeatures.KeepSoftFeatures = false;
  RemeshResult without;
  this->MakeRounds(withoutFeatures, directions, nullptr, progress, without);
  if (IsGoodWithout(without, options.Element) ||
    !this->MakeRounds(options, directions, &without, progress, result))
  {
    result = std::move(without);
    result.Notes.push_back(sentence);
  }
}
}
