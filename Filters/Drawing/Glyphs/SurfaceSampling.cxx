// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Glyphs/SurfaceSampling.h"

#include "Glyphs/DiskGrid.h"
#include "Paths/SurfacePath.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace DirectionFields::Internal
{
namespace
{
/// Candidates on a square of the spacing: their gaps are about a quarter of it.
constexpr double CandidateDensity = 12.0;
constexpr double FewestCandidates = 256.0;
/// Most candidates for each sample that is wanted. A smooth surface needs 20; where many sheets
/// share a room, their area asks for far more than there is room for.
constexpr double MostCandidates = 64.0;
/// Samples on a square of the spacing, as counted on smooth closed surfaces; and the same among the
/// vertices of a fine mesh, which are not moved.
constexpr double SampleDensity = 0.615;
constexpr double PointDensity = 0.66;
/// Sweeps of the relaxation, and how far it goes beyond the middle, which it reaches the sooner.
constexpr int Sweeps = 3;
constexpr double Overshoot = 1.5;
/// Rounds in which an automatic spacing is found, and the part of the maximum number of samples
/// that is near enough to it.
constexpr int MaximumRounds = 10;
/// The first of them suppose that the number goes by the square of the spacing.
constexpr int SquareRounds = 3;
constexpr double GoodPart = 0.93;
constexpr double WantedPart = 0.97;

struct Candidate
{
  SurfacePoint Point;
  DiskGrid::Cell Cell{};
  Vector3 Position;
  Eigen::Vector3f Normal;
};

/// 0 ... size - 1 in an order without any regularity for the eye, the same each time.
std::vector<Index> ScrambledOrder(std::size_t size)
{
  std::vector<Index> order(size);
  std::iota(order.begin(), order.end(), 0);
  // The generator splitmix64 (Steele, Lea, Flood 2014) in the shuffle of Fisher and Yates; the
  // standard library's is another in each implementation.
  std::uint64_t state = 0;
  for (std::size_t i = size; i > 1; --i)
  {
    state += 0x9e3779b97f4a7c15ull;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    z ^= z >> 31;
    std::swap(order[i - 1], order[z % i]);
  }
  return order;
}

bool IsIn(const std::vector<char>& set, Index i)
{
  return !set.empty() && set[i] != 0;
}

/// Candidates at equal steps of area, triangle by triangle; within one they fill it evenly.
std::vector<Candidate> SpreadCandidates(
  const SurfaceIncidence& surface, const std::vector<char>& excluded, double totalArea, Index count)
{
  std::vector<Candidate> candidates;
  candidates.reserve(static_cast<std::size_t>(count));
  const double step = totalArea / count;
  double passed = 0.0;
  Index made = 0;
  for (Index t = 0; t < surface.GetNumberOfTriangles() && made < count; ++t)
  {
    if (IsIn(excluded, t))
    {
      continue;
    }
    passed += surface.Area(t);
    for (; made < count && (made + 0.5) * step < passed; ++made)
    {
      // Multiples of these two numbers, modulo 1, fill the square evenly.
      double u = std::fmod((made + 0.5) * 0.7548776662466927, 1.0);
      double v = std::fmod((made + 0.5) * 0.5698402909980532, 1.0);
      if (u + v > 1.0)
      {
        u = 1.0 - u;
        v = 1.0 - v;
      }
      Candidate candidate;
      candidate.Point = { t, { 1.0 - u - v, u, v } };
      candidate.Position = candidate.Point.Position(surface);
      candidate.Normal = surface.Normal(t).cast<float>();
      candidates.push_back(candidate);
    }
  }
  return candidates;
}

/// A point of the mesh, with the normal of one of its triangles.
Candidate PointCandidate(const SurfaceIncidence& surface, Index point)
{
  const Index t = *surface.BeginTriangles(point);
  Candidate candidate;
  candidate.Point.Triangle = t;
  candidate.Point.Weights[surface.FindCorner(t, point)] = 1.0;
  candidate.Position = surface.GetSurface().Points[point];
  candidate.Normal = surface.Normal(t).cast<float>();
  return candidate;
}

/// Reports the progress of rounds whose number is not known.
class Rounds
{
public:
  explicit Rounds(const Progress& progress)
    : Listener(progress)
  {
  }

  /// The next round, or the first; each takes half of the remaining candidates.
  void Begin()
  {
    this->Done = this->End;
    this->End += 0.5 * (1.0 - this->End);
  }

  /// Tells where in the round the step is: in a phase, of several. Throws Stopped.
  void Step(std::size_t step, std::size_t steps, int phase, int phases) const
  {
    if (step % StepsPerReport == 0)
    {
      const double part = (phase + static_cast<double>(step) / std::max<std::size_t>(steps, 1));
      this->Listener.Report(this->Done + (this->End - this->Done) * part / phases);
    }
  }

private:
  static constexpr std::size_t StepsPerReport = 32768;

  const Progress& Listener;
  double Done = 0.0;
  double End = 0.0;
};

/// Takes candidates that keep their distance.
class Spreading
{
public:
  /// @param excluded not 0 for triangles without samples; empty for none
  Spreading(const SurfaceIncidence& surface, const std::vector<char>& excluded,
    std::vector<Candidate>& candidates, const Vector3& origin, double spacing, const Rounds& rounds)
    : Surface(surface)
    , Excluded(excluded)
    , Candidates(candidates)
    , Grid(origin, spacing, candidates.size() / 8)
    , Round(rounds)
  {
    // Candidates of one cell have the same neighbours, which are searched for once.
    for (Candidate& candidate : candidates)
    {
      candidate.Cell = this->Grid.CellAt(candidate.Position);
    }
    std::stable_sort(candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b) { return a.Cell < b.Cell; });
  }

  std::vector<Candidate> Samples;

  /// Takes all that there is room for.
  void Throw(const std::vector<Index>& order, int phase, int phases)
  {
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      this->Round.Step(i, order.size(), phase, phases);
      const Candidate& candidate = this->Candidates[order[i]];
      if (this->Grid.IsFree(candidate.Position, candidate.Normal))
      {
        this->Take(candidate);
      }
    }
  }

  /// Takes points of the mesh that are far from all samples: parts of the surface that are too
  /// small to have a candidate.
  void TakeRemotePoints()
  {
    for (Index i = 0; i < this->Surface.GetNumberOfPoints(); ++i)
    {
      if (this->Surface.IsUsed(i) && !IsIn(this->Excluded, *this->Surface.BeginTriangles(i)) &&
        this->Grid.IsEmptyAround(this->Surface.GetSurface().Points[i]))
      {
        this->Take(PointCandidate(this->Surface, i));
      }
    }
  }

  /// Moves the samples towards the middle of the candidates that are nearest to them.
  void Relax(int phase, int phases)
  {
    const std::size_t count = this->Candidates.size();
    std::vector<Vector3> sum(this->Samples.size(), Vector3::Zero());
    std::vector<Index> owned(this->Samples.size(), 0);
    std::vector<Index> around;
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Round.Step(i, count, phase, phases);
      const Candidate& candidate = this->Candidates[i];
      if (i == 0 || candidate.Cell != this->Candidates[i - 1].Cell)
      {
        this->Grid.FindAround(candidate.Cell, around);
      }
      const Index owner = this->Grid.Nearest(around, candidate.Position, candidate.Normal);
      if (owner != None)
      {
        sum[owner] += candidate.Position;
        ++owned[owner];
      }
    }
    for (std::size_t s = 0; s < this->Samples.size(); ++s)
    {
      const auto sample = static_cast<Index>(s);
      if (owned[s] > 0)
      {
        this->Move(sample, Overshoot * (sum[s] / owned[s] - this->Samples[s].Position));
      }
    }
  }

private:
  void Take(const Candidate& candidate)
  {
    this->Grid.Insert(candidate.Position, candidate.Normal);
    this->Samples.push_back(candidate);
  }

  /// Moves a sample if nothing is too near there, or else by half of that.
  void Move(Index sample, Vector3 by)
  {
    for (int attempt = 0; attempt < 2; ++attempt, by *= 0.5)
    {
      Candidate moved;
      moved.Point = Moved(this->Surface, this->Samples[sample].Point, by);
      moved.Position = moved.Point.Position(this->Surface);
      moved.Normal = this->Surface.Normal(moved.Point.Triangle).cast<float>();
      if (!IsIn(this->Excluded, moved.Point.Triangle) &&
        this->Grid.IsFree(moved.Position, moved.Normal, sample))
      {
        this->Grid.Move(sample, moved.Position, moved.Normal);
        this->Samples[sample] = moved;
        return;
      }
    }
  }

  const SurfaceIncidence& Surface;
  const std::vector<char>& Excluded;
  std::vector<Candidate>& Candidates;
  DiskGrid Grid;
  const Rounds& Round;
};

/// A spacing, and the number of its samples; 0 if none was tried.
struct Tried
{
  double Spacing = 0.0;
  double Count = 0.0;
};

/// The largest set of at most maximumNumber samples that spread(spacing) gives for some spacing
/// that is within bounds. The search starts from a spacing that should do.
template <typename Spread>
SurfaceSamples FitSpacing(double spacing, double least, double most, Index maximumNumber,
  Rounds& rounds, const Spread& spread)
{
  Tried tooMany, enough;
  spacing = std::min(spacing, most);
  SurfaceSamples best;
  for (int round = 0; round < MaximumRounds; ++round)
  {
    rounds.Begin();
    SurfaceSamples samples = spread(spacing);
    samples.Spacing = spacing;
    const std::size_t count = samples.Points.size();
    const auto wanted = static_cast<std::size_t>(maximumNumber);
    const bool fits = count <= wanted;
    // Too many are better than none, and are cut off in the end.
    if (best.Points.empty() ||
      (fits && (best.Points.size() > wanted || count > best.Points.size())))
    {
      best = std::move(samples);
    }
    if ((fits && (spacing <= least || count >= GoodPart * wanted)) || (!fits && spacing >= most))
    {
      break;
    }
    (fits ? enough : tooMany) = Tried{ spacing, std::max<double>(count, 1.0) };
    const double aim = WantedPart * wanted;
    if (round >= SquareRounds && enough.Count > 0.0 && tooMany.Count > aim &&
      tooMany.Spacing < enough.Spacing)
    {
      // Where sheets crowd a room, other powers of the spacing fit better than the square.
      const double part = std::log(tooMany.Count / aim) / std::log(tooMany.Count / enough.Count);
      spacing =
        tooMany.Spacing * std::pow(enough.Spacing / tooMany.Spacing, std::clamp(part, 0.1, 0.9));
    }
    else
    {
      // Few samples change in jumps: approach the aim from a little farther away each time.
      const double factor = std::sqrt(std::max<double>(count, 1.0) / aim);
      spacing *= std::clamp(factor, 0.5, 4.0) * (fits ? 1.0 : 1.0 + 0.01 * round);
    }
    spacing = std::clamp(spacing, least, most);
  }
  if (best.Points.size() > static_cast<std::size_t>(maximumNumber))
  {
    best.Points.resize(static_cast<std::size_t>(maximumNumber));
  }
  return best;
}

/// The box around all used points.
struct Box
{
  Vector3 Lower = Vector3::Constant(std::numeric_limits<double>::max());
  Vector3 Upper = -Lower;

  explicit Box(const SurfaceIncidence& surface)
  {
    for (Index i = 0; i < surface.GetNumberOfPoints(); ++i)
    {
      if (surface.IsUsed(i))
      {
        this->Lower = this->Lower.cwiseMin(surface.GetSurface().Points[i]);
        this->Upper = this->Upper.cwiseMax(surface.GetSurface().Points[i]);
      }
    }
  }

  double Diagonal() const { return (this->Upper - this->Lower).norm(); }
};
}

SurfaceSamples SampleSurface(const SurfaceIncidence& surface, const std::vector<char>& excluded,
  const SamplingOptions& options, const Progress& progress)
{
  double area = 0.0;
  for (Index t = 0; t < surface.GetNumberOfTriangles(); ++t)
  {
    area += IsIn(excluded, t) ? 0.0 : surface.Area(t);
  }
  if (!(area > 0.0) || !std::isfinite(area) || options.MaximumNumber < 1)
  {
    return {};
  }

  const Box box(surface);
  const double most = box.Diagonal();
  const double automatic = std::sqrt(SampleDensity * area / (WantedPart * options.MaximumNumber));
  const double least = std::clamp(options.Spacing, 0.0, most);
  // A spacing that is much less gives too many samples, and takes long.
  const double start = least > 0.6 * automatic ? least : automatic;
  Rounds rounds(progress);
  return FitSpacing(start, least, most, options.MaximumNumber, rounds,
    [&](double spacing)
    {
      const double wanted = CandidateDensity * area / (spacing * spacing);
      const double few = std::min(wanted, MostCandidates * options.MaximumNumber);
      auto candidates = SpreadCandidates(
        surface, excluded, area, static_cast<Index>(std::max(few, FewestCandidates)));
      const auto order = ScrambledOrder(candidates.size());
      constexpr int phases = Sweeps + 2;
      Spreading spreading(surface, excluded, candidates, box.Lower, spacing, rounds);
      spreading.Throw(order, 0, phases);
      for (int sweep = 0; sweep < Sweeps; ++sweep)
      {
        spreading.Relax(1 + sweep, phases);
      }
      spreading.Throw(order, phases - 1, phases);
      spreading.TakeRemotePoints();
      SurfaceSamples samples;
      for (const Candidate& sample : spreading.Samples)
      {
        samples.Points.push_back(sample.Point);
      }
      return samples;
    });
}

SurfaceSamples SamplePoints(const SurfaceIncidence& surface, const std::vector<char>& excluded,
  Index maximumNumber, const Progress& progress)
{
  std::vector<Index> points;
  for (Index i = 0; i < surface.GetNumberOfPoints(); ++i)
  {
    if (surface.IsUsed(i) && !IsIn(excluded, i))
    {
      points.push_back(i);
    }
  }
  if (maximumNumber < 1)
  {
    return {};
  }
  std::vector<Candidate> candidates;
  candidates.reserve(points.size());
  for (const Index i : points)
  {
    candidates.push_back(PointCandidate(surface, i));
  }
  SurfaceSamples samples;
  if (static_cast<Index>(points.size()) <= maximumNumber)
  {
    for (const Candidate& candidate : candidates)
    {
      samples.Points.push_back(candidate.Point);
    }
    return samples;
  }

  double area = 0.0;
  for (Index t = 0; t < surface.GetNumberOfTriangles(); ++t)
  {
    area += surface.Area(t);
  }
  const Box box(surface);
  const auto order = ScrambledOrder(candidates.size());
  const std::vector<char> none;
  Rounds rounds(progress);
  const double start = std::sqrt(PointDensity * area / (WantedPart * maximumNumber));
  return FitSpacing(start, 0.0, box.Diagonal(), maximumNumber, rounds,
    [&](double spacing)
    {
      SurfaceSamples subset;
      Spreading spreading(surface, none, candidates, box.Lower, spacing, rounds);
      spreading.Throw(order, 0, 1);
      for (const Candidate& sample : spreading.Samples)
      {
        subset.Points.push_back(sample.Point);
      }
      return subset;
    });
}
}
