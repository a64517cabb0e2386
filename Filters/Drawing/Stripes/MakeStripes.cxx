// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Geometry/RootOfArea.h"
#include "Stripes.h"
#include "Stripes/PhaseDiffusion.h"
#include "Stripes/PhaseSmoothing.h"
#include "Stripes/StripeBands.h"
#include "Stripes/StripeLines.h"
#include "Stripes/StripePoints.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>

namespace DirectionFields
{
namespace
{
/// The default spacing is the root of the area over this.
constexpr double SpacingsPerSize = 40.0;
constexpr double MostCrossings = 1e8;
/// Components with more nodes are relaxed one after the other.
constexpr Index ManyNodes = 100000;
// Where the phases of the progress end: setting up, relaxing, cutting.
constexpr double ProgressWanted = 0.1;
constexpr double ProgressRelaxed = 0.8;
/// The part of the time of the phases that their relaxation takes; the rest goes into smoothing
/// them.
constexpr double RelaxedPart = 0.7;

void CheckOptions(const StripeOptions& options)
{
  if (!(options.Spacing >= 0.0) || !std::isfinite(options.Spacing))
  {
    throw std::invalid_argument("Spacing must be a length that is not negative.");
  }
  if (!(std::abs(options.LineOffset) <= 1.0))
  {
    throw std::invalid_argument("Line Offset must be from -1 to 1.");
  }
}

double DefaultSpacing(const SurfaceGeometry& geometry)
{
  return Internal::RootOfArea(geometry.Lengths) / SpacingsPerSize;
}

double FrequencyOf(double spacing)
{
  return spacing > 0.0 && std::isfinite(spacing) ? 1.0 / spacing : 0.0;
}

void RequireFewCrossings(const WantedPhases& wanted)
{
  const TriangleMesh& mesh = wanted.GetMesh();
  const double crossings = ParallelSum(mesh.GetNumberOfEdges(), MediumPiece, 0.0,
    [&](Index begin, Index end)
    {
      double sum = 0.0;
      for (Index e = begin; e < end; ++e)
      {
        sum += std::abs(wanted.Along(mesh.HalfEdge(e)).Increment);
      }
      return sum;
    });
  if (!(crossings <= MostCrossings))
  {
    throw std::invalid_argument(
      "The stripes are so narrow that their lines would have more than a hundred million "
      "points. Raise Spacing.");
  }
}

/// Whether a phase has a sign: then any offset will do.
bool HasOneSheet(const WantedPhases& wanted)
{
  return std::none_of(wanted.GetComponents().begin(), wanted.GetComponents().end(),
    [](const WantedPhases::Component& component) { return component.HasTwoSheets; });
}

double UsableOffset(const WantedPhases& wanted, double offset)
{
  return wanted.GetField().GetDegree() == 1 && HasOneSheet(wanted) ? offset
                                                                   : 0.5 * std::round(2.0 * offset);
}

/// Calls body(component, progress) for each component, small ones on several threads at once, where
/// nothing may be reported.
template <typename Body>
void ForComponents(const WantedPhases& wanted, const Progress& progress, const Body& body)
{
  const double all = std::max<double>(1.0, wanted.GetNumberOfNodes());
  wanted.GetMesh().ForEachComponent(
    [&](Index c)
    {
      const WantedPhases::Component& component = wanted.GetComponents()[c];
      body(component,
        component.Nodes() > ManyNodes
          ? progress.Part(component.FirstNode / all, component.EndNode / all)
          : Progress());
    });
  progress.Report(1.0);
}

/// Phases that miss little of the wanted steps, and how much that is.
std::vector<double> FindPhases(const WantedPhases& wanted, const Progress& progress, double& misfit)
{
  std::vector<double> phases(wanted.GetNumberOfNodes());
  ForComponents(wanted, progress.Part(0.0, RelaxedPart),
    [&](const WantedPhases::Component& component, const Progress& part)
    {
      const PhaseDiffusion relaxation(wanted, component);
      ComplexVector psi = relaxation.Start();
      relaxation.Relax(part, psi);
      const std::vector<double> own = relaxation.Phases(psi);
      std::copy(own.begin(), own.end(), phases.begin() + component.FirstNode);
    });
  misfit = Misfit(wanted, phases);
  std::vector<double> smooth = phases;
  ForComponents(wanted, progress.Part(RelaxedPart, 1.0),
    [&](const WantedPhases::Component& component, const Progress& part)
    { SmoothPhases(wanted, component, part, smooth); });
  const double smoothMisfit = Misfit(wanted, smooth);
  if (smoothMisfit < misfit)
  {
    misfit = smoothMisfit;
    return smooth;
  }
  return phases;
}

template <typename Value, typename At>
void SetAll(const std::vector<std::int64_t>& points, std::vector<Value>& values, const At& at)
{
  values.resize(points.size());
  ParallelFor(static_cast<Index>(points.size()), MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index k = begin; k < end; ++k)
      {
        values[k] = at(points[k]);
      }
    });
}

void AddLines(const StripePieces& pieces, const std::vector<char>& ghost, StripePattern& pattern)
{
  StripeLines lines(pieces, ghost);
  const StripePoints points(pieces);
  SetAll(lines.Points, pattern.LinePoints, [&](std::int64_t p) { return points.At(p); });
  SetAll(lines.Points, pattern.LinePositions, [&](std::int64_t p) { return points.Position(p); });
  SetAll(lines.Points, pattern.LineNormals, [&](std::int64_t p) { return points.Normal(p); });
  pattern.LineOffsets = std::move(lines.Offsets);
  pattern.Closed = std::move(lines.Closed);
  pattern.EndSingularities = std::move(lines.EndCenters);
  pattern.Arc.resize(pattern.LinePositions.size());
  for (std::size_t i = 0; i + 1 < pattern.LineOffsets.size(); ++i)
  {
    double arc = 0.0;
    for (std::int64_t p = pattern.LineOffsets[i]; p < pattern.LineOffsets[i + 1]; ++p)
    {
      if (p > pattern.LineOffsets[i])
      {
        arc += (pattern.LinePositions[p] - pattern.LinePositions[p - 1]).stableNorm();
      }
      pattern.Arc[p] = arc;
    }
    pattern.Length.push_back(arc);
  }
}

void AddBands(const StripePieces& pieces, const std::vector<char>& ghost, bool withPhases,
  StripePattern& pattern)
{
  StripeBands bands(pieces, ghost, withPhases);
  const StripePoints points(pieces);
  SetAll(bands.Points, pattern.BandPoints, [&](std::int64_t p) { return points.At(p); });
  SetAll(bands.Points, pattern.BandPositions, [&](std::int64_t p) { return points.Position(p); });
  SetAll(bands.Points, pattern.BandNormals, [&](std::int64_t p) { return points.Normal(p); });
  pattern.BandCorners = std::move(bands.Corners);
  pattern.BandOffsets = std::move(bands.Offsets);
  pattern.Stripe = std::move(bands.Stripe);
  pattern.BandTriangle = std::move(bands.Triangle);
  pattern.BandPhases = std::move(bands.Phases);
}

void AddSingularities(const GivenField& field, const StripePieces& pieces, StripePattern& pattern)
{
  const std::vector<int> indices = field.Indices();
  const TriangleMesh& mesh = field.GetMesh();
  for (const StripePieces::Center& center : pieces.GetCenters())
  {
    Vector3 position = Vector3::Zero();
    for (int c = 0; c < 3; ++c)
    {
      position += field.GetGeometry().Positions[mesh.Tail(3 * center.Triangle + c)] / 3.0;
    }
    pattern.Singularities.push_back({ position, mesh.InputTriangle(center.Triangle),
      static_cast<int>(center.Gain), indices[center.Triangle] });
    const std::vector<char>& ghost = field.GetSurface().Ghost;
    if (ghost.empty() || !ghost[mesh.InputTriangle(center.Triangle)])
    {
      pattern.BranchPoints += center.Gain != 0 ? 1 : 0;
      pattern.CrowdedBranchPoints += std::abs(center.Gain) > 1 ? 1 : 0;
    }
  }
}

/// Throws Stopped.
StripePattern Pattern(const GivenField& field, const StripeOptions& options,
  const std::function<double(Index point)>& spacing, const Progress& progress)
{
  StripePattern pattern;
  std::function<double(Index)> frequency;
  if (spacing)
  {
    frequency = [&spacing](Index point) { return FrequencyOf(spacing(point)); };
  }
  else
  {
    pattern.Spacing = options.Spacing > 0.0 ? options.Spacing : DefaultSpacing(field.GetGeometry());
    frequency = [value = FrequencyOf(pattern.Spacing)](Index) { return value; };
  }
  const WantedPhases wanted(field, options.Direction, frequency);
  RequireFewCrossings(wanted);
  progress.Report(ProgressWanted);
  std::vector<double> phases =
    FindPhases(wanted, progress.Part(ProgressWanted, ProgressRelaxed), pattern.Misfit);
  pattern.LineOffset = UsableOffset(wanted, options.LineOffset);
  const StripePhases steps(wanted, std::move(phases), pattern.LineOffset);
  const std::vector<char>& ghost = field.GetSurface().Ghost;
  progress.Report(ProgressRelaxed);
  {
    const StripeLevels levels(steps, LevelKind::Lines);
    const StripePieces pieces(levels);
    AddLines(pieces, ghost, pattern);
    AddSingularities(field, pieces, pattern);
  }
  progress.Report(0.5 * (ProgressRelaxed + 1.0));
  if (options.Bands)
  {
    const StripeLevels levels(steps, LevelKind::Borders);
    const StripePieces pieces(levels);
    AddBands(pieces, ghost, options.BandPhases, pattern);
  }
  progress.Report(1.0);
  return pattern;
}
}

StripePattern MakeStripes(const GivenField& field, const StripeOptions& options,
  const std::function<double(Index point)>& spacing, const ProgressFunction& progress)
{
  CheckOptions(options);
  try
  {
    return Pattern(field, options, spacing, Progress(progress));
  }
  catch (const Stopped&)
  {
    StripePattern nothing;
    nothing.Aborted = true;
    return nothing;
  }
}
}
