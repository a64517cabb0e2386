// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remesh.h"

#include "Finishing/ThinParts.h"
#include "Preparation/WantedSizes.h"
#include "Sizes/SizeField.h"
#include "Support/Sentences.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace DirectionFields
{
namespace
{
using namespace Internal;

/// How often a mesh is made anew whose faces are farther from the surface than they are to be, for
/// an error and for a number of faces.
constexpr int MostCorrections = 2;
constexpr int CorrectionsOfAsMany = 1;
/// How much farther they may be.
constexpr double Missed = 1.1;
/// Sizes for a number of faces are corrected where faces are farther than this many times the error
/// that the sizes are for; at other places they get larger for it.
constexpr double Usual = 2.0;
/// A surface that takes so many times as many faces is rough, and more would only follow that.
constexpr double MostMore = 3.0;
/// What a mesh for a number of faces may have more.
constexpr double AboutAsMany = 1.05;
/// By how much a length is shortened in one round at most.
constexpr double MostShortened = 0.5;
/// The part of the progress of the first mesh.
constexpr double AfterFirstMesh = 0.96;

/// The same for progress that does not go back: where a solver did not converge or a map is bad
/// another one begins anew.
ProgressFunction Forward(const ProgressFunction& progress)
{
  if (!progress)
  {
    return progress;
  }
  return [&progress, furthest = 0.0](double done) mutable
  {
    furthest = std::max(furthest, done);
    return progress(furthest);
  };
}

/// A result whose places and lengths are those of the surface given.
RemeshResult InUnitOfSurface(RemeshResult&& result, const Vector3& origin, double unit)
{
  for (Vector3& point : result.Points)
  {
    point = unit * point + origin;
  }
  result.MaximumDistance *= unit;
  result.MaximumDistanceToMesh *= unit;
  result.MaximumBoundaryDistance *= unit;
  result.EdgeLength *= unit;
  return std::move(result);
}

/// The distance that few of them are larger than.
double HighOf(std::vector<double> distances)
{
  constexpr double part = 0.98;
  const auto at = distances.begin() +
    static_cast<std::ptrdiff_t>(part * static_cast<double>(distances.size() - 1));
  std::nth_element(distances.begin(), at, distances.end());
  return *at;
}

/// Shortens the lengths that sizes ask for where the distances between mesh and surface are larger
/// than they are to be, and lets them grow from there as they may. Without a number of faces that
/// is kept all are shortened by what most of the distances ask for.
void Shorten(const Surface& surface, const std::vector<double>& distances, double most,
  double gradation, bool keepsFaces, std::vector<double>& lengths)
{
  const double before = RelativeArea(surface, lengths);
  const double high = keepsFaces ? most : std::max(HighOf(distances), most);
  for (std::size_t p = 0; p < lengths.size(); ++p)
  {
    // Heights of chords grow with the square of their lengths. Where few faces have to be smaller
    // than those around them the map gives them a part of that only.
    const double own = most / std::max(distances[p], most);
    lengths[p] *= std::clamp(std::min(own, std::sqrt(most / high)), MostShortened, 1.0);
  }
  LimitGrowth(surface, std::log(gradation), lengths);
  const double longer = keepsFaces ? std::sqrt(RelativeArea(surface, lengths) / before) : 1.0;
  for (double& length : lengths)
  {
    length *= std::isfinite(longer) ? longer : 1.0;
  }
}
}

double GradationOfErrors(const RemeshOptions& options)
{
  constexpr double usual = 1.3;
  return options.Gradation > 1.0 ? options.Gradation : usual;
}

RemeshResult Remesh::MakeForError(const RemeshOptions& given, double error, double gradation,
  const std::vector<Vector3>& directions, const Progress& progress)
{
  RemeshOptions options = given;
  RemeshResult best = this->MakeForGiven(options, directions, progress.Part(0.0, AfterFirstMesh));
  const bool keepsFaces = !(given.MaximumError > 0.0);
  const double most = error / this->Unit * (keepsFaces ? Usual : 1.0);
  RemeshResult last = best;
  const double mostFaces =
    (keepsFaces ? AboutAsMany : MostMore) * static_cast<double>(best.Faces.size());
  const int rounds = keepsFaces ? CorrectionsOfAsMany : MostCorrections;
  for (int k = 0;
       k < rounds && !this->IsCostly && !best.Faces.empty() && best.MaximumDistance > Missed * most;
       ++k)
  {
    std::vector<double> lengths = options.Sizing;
    for (double& length : lengths)
    {
      length /= this->Unit;
    }
    Shorten(*this->Given, DistancesBothWays(*this->Given, last.Points, last.Faces, last.FaceSource),
      most, gradation, keepsFaces, lengths);
    for (std::size_t p = 0; p < lengths.size(); ++p)
    {
      options.Sizing[p] = lengths[p] * this->Unit;
    }
    const double begin = AfterFirstMesh + (1.0 - AfterFirstMesh) * k / rounds;
    last = this->MakeForGiven(
      options, directions, progress.Part(begin, begin + (1.0 - AfterFirstMesh) / rounds));
    if (static_cast<double>(last.Faces.size()) > mostFaces)
    {
      break;
    }
    if (last.MaximumDistance < best.MaximumDistance)
    {
      best = last;
    }
  }
  if (!keepsFaces && best.MaximumDistance > Missed * most)
  {
    best.Notes.push_back("Faces are up to " + Figure(best.MaximumDistance * this->Unit) +
      " from the surface, where Maximum Error asks for " + Figure(given.MaximumError) +
      ": more faces would be needed there than three times as many as the curvature asks for, as "
      "where the surface is rough, or thinner than faces are wide.");
  }
  return best;
}

RemeshResult Remesh::Compute(const RemeshOptions& given, const std::vector<Vector3>& directions,
  const ProgressFunction& progressFunction)
{
  Check(given, this->Given->Points.size(), this->Given->Triangles.size());
  Threads threads(given.NumberOfThreads);
  const Threads::Scope scope(threads);
  const ProgressFunction forward = Forward(progressFunction);
  const Progress progress(forward);
  try
  {
    double errorOfSizes = 0.0;
    this->RequirePossible(given);
    const RemeshOptions options = this->WithSizes(given, errorOfSizes);
    this->CutSurface(progress);
    RemeshResult result = given.SizeSource == SizeSource::Curvature && errorOfSizes > 0.0
      ? this->MakeForError(options, errorOfSizes, GradationOfErrors(given), directions, progress)
      : this->MakeForGiven(options, directions, progress);
    result.ErrorOfSizes = errorOfSizes;
    return InUnitOfSurface(std::move(result), this->Origin, this->Unit);
  }
  catch (const Stopped&)
  {
    RemeshResult result;
    result.Aborted = true;
    return result;
  }
}
}
