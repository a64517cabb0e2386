// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Geometry/RootOfArea.h"
#include "Streamlines.h"
#include "Streamlines/EvenStreamlines.h"
#include "Streamlines/LineSeeds.h"
#include "Streamlines/MotorcycleGraph.h"
#include "Streamlines/StreamlinePoints.h"
#include "Support/Threads.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace DirectionFields
{
namespace
{
/// Default and least spacing, as parts of the root of the area of all components; the default of
/// the longest length, of that of the line's own one.
constexpr double DefaultSpacing = 1.0 / 40.0;
constexpr double LeastSpacing = 1.0 / 1000.0;
constexpr double DefaultLength = 20.0;
/// The most squares of the side of the spacing that evenly spaced lines may fill, all families
/// together: with some seven points each they take two gigabytes.
constexpr double MostSquares = 1e6;
/// Evenly spaced lines are no shorter than this part of the spacing, which is no number of the
/// fifths that they are cut at: rounding must not decide.
constexpr double LeastOfSpacing = 0.9;
/// Lines on a small component may be as short as this part of the root of its area.
constexpr double LeastPart = 0.25;
/// How near a line must come to a singularity to end there, as a part of the size of its triangle.
/// For the graph it is more, so that lines between two singularities are found to be one.
constexpr double GraphCapture = 0.1;
constexpr double ProgressRead = 0.05;
constexpr double ProgressTraced = 0.9;

/// Throws std::invalid_argument with a sentence for the user; NaN is in no range.
void Check(const StreamlineOptions& options)
{
  const auto require = [](bool condition, const char* message)
  {
    if (!condition)
    {
      throw std::invalid_argument(message);
    }
  };
  require(options.Spacing >= 0.0, "Spacing must be 0 or more.");
  require(
    options.Ratio >= 0.1 && options.Ratio <= 0.9, "SeparatingDistanceRatio must be 0.1 to 0.9.");
  require(options.MaximumLength >= 0.0, "MaximumStreamlineLength must be 0 or more.");
  require(options.MinimumLength >= 0.0, "MinimumStreamlineLength must be 0 or more.");
  require(options.MaximumLength == 0.0 || options.MinimumLength <= options.MaximumLength,
    "No line is as long as MinimumStreamlineLength where MaximumStreamlineLength is less. Lower the "
    "one or raise the other.");
  require(options.MaximumNumber >= 1 && options.MaximumNumber <= 10000000,
    "Maximum Number Of Lines must be 1 to 10000000.");
  require(options.Offset >= -1.0 && options.Offset <= 1.0, "Offset must be -1 to 1.");
}

class StreamlineTracing
{
public:
  StreamlineTracing(const GivenField& field, const StreamlineOptions& options)
    : Field(field)
    , Options(options)
    , Zeros(field)
    , Limit(field.GetMesh().GetNumberOfTriangles())
    , Traced{ field, this->Zeros, this->Limit }
    , Spacing(SpacingFor(field, options))
  {
  }

  const SingularPoints& GetZeros() const { return this->Zeros; }
  double GetSpacing() const { return this->Spacing; }

  std::vector<TracedStreamline> Trace(
    const std::vector<StreamlineSeed>& seeds, const Progress& progress)
  {
    switch (this->Options.Seeds)
    {
      case SeedType::Points:
        return this->FromPoints(seeds, progress);
      case SeedType::Singularities:
        return this->FromSingularities(progress);
      case SeedType::EvenlySpaced:
        break;
    }
    return this->Evenly(progress);
  }

private:
  double Unit(Index c) const { return this->Field.GetGeometry().Lengths.Unit[c]; }
  /// The root of the component's area, in the unit of the surface.
  double Extent(Index c) const
  {
    return this->Unit(c) * std::sqrt(this->Field.GetGeometry().Lengths.ComponentArea[c]);
  }
  /// One for all components.
  static double SpacingFor(const GivenField& field, const StreamlineOptions& options)
  {
    const double extent = Internal::RootOfArea(field.GetGeometry().Lengths);
    if (!(options.Spacing > 0.0))
    {
      return DefaultSpacing * extent;
    }
    Eigen::AlignedBox3d box;
    for (const Vector3& position : field.GetGeometry().Positions)
    {
      box.extend(position);
    }
    // Lines farther apart than the surface is long are as those at this distance, but their points,
    // a part of it above the surface, could be anywhere.
    const double most = extent + (box.isEmpty() ? 0.0 : box.sizes().stableNorm());
    return std::min(std::max(options.Spacing, LeastSpacing * extent), most);
  }
  double MaximumLength(Index c) const
  {
    return this->Options.MaximumLength > 0.0 ? this->Options.MaximumLength
                                             : DefaultLength * this->Extent(c);
  }
  /// The component of a triangle of the mesh.
  Index ComponentOf(Index triangle) const
  {
    const auto& components = this->Field.GetMesh().GetComponents();
    const auto after = std::upper_bound(components.begin(), components.end(), triangle,
      [](Index t, const TriangleMesh::Component& c) { return t < c.EndTriangle; });
    return static_cast<Index>(after - components.begin());
  }
  /// Not 0 for triangles of the mesh that belong to other pieces; empty for none.
  std::vector<char> Ghosts() const
  {
    const std::vector<char>& ghost = this->Field.GetSurface().Ghost;
    std::vector<char> excluded;
    if (!ghost.empty())
    {
      const TriangleMesh& mesh = this->Field.GetMesh();
      for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
      {
        excluded.push_back(ghost[mesh.InputTriangle(t)]);
      }
    }
    return excluded;
  }

  /// Throws std::invalid_argument where evenly spaced lines would have more points than there is
  /// memory for, most likely.
  void RequireFewPoints() const
  {
    const double most = MostSquares / NumberOfFamilies(this->Field.GetDegree());
    double squares = 0.0;
    for (Index c = 0; c < static_cast<Index>(this->Field.GetMesh().GetComponents().size()); ++c)
    {
      squares +=
        Internal::FilledSquares(this->Field, c, this->Spacing / this->Unit(c), most - squares);
    }
    if (squares > most)
    {
      throw std::invalid_argument(
        "The lines are so close, or the surface is so thin, that they would "
        "have many million points. Raise Spacing.");
    }
  }

  std::vector<TracedStreamline> Evenly(const Progress& progress)
  {
    this->RequireFewPoints();
    const auto components = static_cast<Index>(this->Field.GetMesh().GetComponents().size());
    const std::vector<char> ghosts = this->Ghosts();
    std::vector<TracedStreamline> lines;
    for (Index c = 0; c < components; ++c)
    {
      EvenOptions even;
      even.Spacing = this->Spacing;
      even.Ratio = this->Options.Ratio;
      even.MaximumLength = this->MaximumLength(c);
      even.MinimumLength = this->Options.MinimumLength > 0.0
        ? this->Options.MinimumLength
        : std::min({ LeastOfSpacing * even.Spacing, LeastPart * this->Extent(c),
            LeastOfSpacing * even.MaximumLength });
      even.MaximumNumber = this->Options.MaximumNumber - static_cast<Index>(lines.size());
      if (even.MaximumNumber <= 0)
      {
        break;
      }
      if (even.MinimumLength > even.MaximumLength)
      {
        // All of them would be left out.
        continue;
      }
      std::vector<TracedStreamline> more = TraceEvenStreamlines(this->Field, this->Zeros, c, even,
        ghosts, progress.Part(static_cast<double>(c) / components, (c + 1.0) / components));
      for (TracedStreamline& line : more)
      {
        line.Seed = static_cast<Index>(lines.size());
        lines.push_back(std::move(line));
      }
    }
    return lines;
  }

  std::vector<TracedStreamline> FromSingularities(const Progress& progress)
  {
    const std::vector<char>& ghost = this->Field.GetSurface().Ghost;
    const auto count = static_cast<Index>(this->Zeros.GetZeros().size());
    std::vector<std::vector<ZeroRay>> rays(count);
    ParallelFor(count, 16,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          rays[i] = this->Zeros.Rays(i);
        }
      });
    if (this->Options.StopAtCrossings)
    {
      this->Traced.Capture = GraphCapture;
    }
    // A graph needs all lines; the singularities of ghosts are others' else.
    std::vector<std::vector<ZeroRay>> raysOf(this->Field.GetMesh().GetComponents().size());
    for (Index i = 0; i < count; ++i)
    {
      const Index triangle = this->Zeros.GetZeros()[i].Triangle;
      const bool isOwn = ghost.empty() || ghost[this->Field.GetMesh().InputTriangle(triangle)] == 0;
      if (isOwn || this->Options.StopAtCrossings)
      {
        auto& of = raysOf[this->ComponentOf(triangle)];
        of.insert(of.end(), rays[i].begin(), rays[i].end());
      }
    }
    std::vector<TracedStreamline> lines;
    for (std::size_t c = 0; c < raysOf.size(); ++c)
    {
      const auto component = static_cast<Index>(c);
      for (TracedStreamline& line : this->FromRays(component, raysOf[c], progress))
      {
        line.Component = component;
        lines.push_back(std::move(line));
      }
      progress.Report((c + 1.0) / raysOf.size());
    }
    return lines;
  }

  std::vector<TracedStreamline> FromRays(
    Index component, const std::vector<ZeroRay>& rays, const Progress& progress) const
  {
    const double most = this->MaximumLength(component) / this->Unit(component);
    if (rays.empty())
    {
      return {};
    }
    if (this->Options.StopAtCrossings)
    {
      return TraceMotorcycleGraph(this->Traced, rays, most, progress.Part(0.0, 0.0));
    }
    return this->TraceAll(static_cast<Index>(rays.size()), progress,
      [&](Index i) { return TraceRay(this->Traced, rays[i], most); });
  }

  std::vector<TracedStreamline> FromPoints(
    const std::vector<StreamlineSeed>& seeds, const Progress& progress) const
  {
    const int families = NumberOfFamilies(this->Field.GetDegree());
    std::vector<std::pair<Index, int>> starts;
    for (Index i = 0; i < static_cast<Index>(seeds.size()); ++i)
    {
      const bool isOnMesh =
        seeds[i].Triangle != None && this->Field.GetMeshTriangles()[seeds[i].Triangle] != None;
      for (int k = 0; isOnMesh && k < families; ++k)
      {
        starts.emplace_back(i, k);
      }
    }
    std::vector<TracedStreamline> lines =
      this->TraceAll(static_cast<Index>(starts.size()), progress,
        [&](Index i)
        { return this->FromPoint(seeds[starts[i].first], starts[i].first, starts[i].second); });
    lines.erase(std::remove_if(lines.begin(), lines.end(),
                  [](const TracedStreamline& line) { return line.Pieces.empty(); }),
      lines.end());
    return lines;
  }

  /// The line along direction k of a seed; without pieces where there is none.
  TracedStreamline FromPoint(const StreamlineSeed& seed, Index number, int k) const
  {
    TracedStreamline line;
    const Index triangle = this->Field.GetMeshTriangles()[seed.Triangle];
    std::array<double, 3> weights;
    for (int c = 0; c < 3; ++c)
    {
      // Off the corners, where directions are defined.
      weights[this->Field.MeshCorner(triangle, c)] =
        (std::max(seed.Weights[c], 0.0) + 1e-6) / (1.0 + 3e-6);
    }
    const FieldInterpolant power(this->Field.GetGeometry(), this->Field.GetDegree(),
      this->Field.GetSection().data(), triangle);
    const Complex place = power.Flat().Place(weights);
    const Complex value = power.At(place);
    if (value == 0.0)
    {
      return line;
    }
    const double angle = (std::arg(value) + 2.0 * Pi * k) / this->Field.GetDegree();
    const LineStart start{ triangle, place, std::polar(1.0, angle), 1 };
    const LineStart back{ triangle, place, -start.Direction, -1 };
    const Index component = this->ComponentOf(triangle);
    const double most = this->MaximumLength(component) / this->Unit(component);
    const IntegrationDirection direction =
      this->Field.GetDegree() == 1 ? this->Options.Direction : IntegrationDirection::Both;
    if (direction == IntegrationDirection::Forward)
    {
      line = TraceLine(this->Traced, start, most);
    }
    else if (direction == IntegrationDirection::Backward)
    {
      line = Joined(TraceLine(this->Traced, back, most), TracedStreamline());
    }
    else
    {
      line = Joined(
        TraceLine(this->Traced, back, 0.5 * most), TraceLine(this->Traced, start, 0.5 * most));
    }
    line.Seed = number;
    line.Component = component;
    return line;
  }

  /// As many lines as may be, on all threads.
  template <typename Body>
  std::vector<TracedStreamline> TraceAll(
    Index count, const Progress& progress, const Body& trace) const
  {
    constexpr Index atOnce = 256;
    const Index most = std::min(count, this->Options.MaximumNumber);
    std::vector<TracedStreamline> lines(most);
    for (Index first = 0; first < most; first += atOnce)
    {
      progress.RequireToGoOn();
      ParallelFor(std::min(atOnce, most - first), 1,
        [&](Index begin, Index end)
        {
          for (Index i = first + begin; i < first + end; ++i)
          {
            lines[i] = trace(i);
          }
        });
    }
    return lines;
  }

  const GivenField& Field;
  const StreamlineOptions& Options;
  SingularPoints Zeros;
  PieceLimit Limit;
  TracedField Traced;
  double Spacing;
};
}

Streamlines TraceStreamlines(const GivenField& field, const PointDirections& directions,
  const std::vector<StreamlineSeed>& seeds, const StreamlineOptions& options,
  const ProgressFunction& progress)
{
  Check(options);
  const Progress steps(progress);
  try
  {
    StreamlineTracing tracing(field, options);
    steps.Report(ProgressRead);
    std::vector<TracedStreamline> traced =
      tracing.Trace(seeds, steps.Part(ProgressRead, ProgressTraced));
    const bool isLimited = static_cast<Index>(traced.size()) >= options.MaximumNumber;
    if (isLimited)
    {
      traced.erase(traced.begin() + options.MaximumNumber, traced.end());
    }
    const auto& units = field.GetGeometry().Lengths.Unit;
    traced.erase(std::remove_if(traced.begin(), traced.end(),
                   [&](const TracedStreamline& line)
                   { return line.Length() * units[line.Component] < options.MinimumLength; }),
      traced.end());
    Streamlines result = ToStreamlines(
      field, directions, tracing.GetZeros(), traced, options.Offset * tracing.GetSpacing());
    result.Spacing = tracing.GetSpacing();
    result.IsLimited = isLimited;
    steps.Report(1.0);
    return result;
  }
  catch (const Stopped&)
  {
    Streamlines nothing;
    nothing.Aborted = true;
    return nothing;
  }
}
}
