// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Streamlines/EvenStreamlines.h"

#include "Streamlines/LineSeeds.h"
#include "Streamlines/SpacedLine.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <tuple>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// The greatest number of streamlines traced at once, and their number as a part of the streamlines
/// at hand. While these are few, streamlines traced at once come too close to each other, and the
/// parts cut off are lost work. The number does not depend on that of the threads.
constexpr std::size_t MostAtOnce = 48;
constexpr std::size_t PartAtOnce = 6;
/// Places that are looked at at once for gaps, by one thread.
constexpr Index FewPlaces = 256;
/// Seeds are at least this part of the spacing away from other lines: the distance through space,
/// from a point that is the spacing away along the surface, is a little less than that.
constexpr double SeedPart = 0.95;
/// Where a line is this part of the spacing away from the point straight beside another line,
/// walking over the surface, which takes much longer, would give no seed either.
constexpr double SurelyTakenPart = 0.6;
/// No other seed is tried nearer to one whose line was too short.
constexpr double DeadPart = 0.25;

/// The seeds on one side of a line.
struct Front
{
  std::size_t Line;
  /// 1 on the left, -1 on the right.
  int Side;
  std::size_t Cursor = 0;
};

class EvenTracing
{
public:
  EvenTracing(const GivenField& field, const SingularPoints& zeros, Index component,
    const EvenOptions& options, const std::vector<char>& excluded)
    : Field(field)
    , Options(options)
    , Excluded(excluded)
    , Component(component)
    , Unit(field.GetGeometry().Lengths.Unit[component])
    , Spaced(field, zeros, component, options)
    , Grid(this->Spaced.MakeGrid())
    , Dead(this->Spaced.MakeGrid())
  {
    for (int k = 0; k < NumberOfFamilies(field.GetDegree()); ++k)
    {
      this->Turns.push_back(std::polar(1.0, 2.0 * Pi * k / field.GetDegree()));
    }
  }

  std::vector<TracedStreamline> Run(const Progress& progress)
  {
    std::vector<SeedPlace> places =
      SeedPlaces(this->Field, this->Component, this->Options.Spacing, this->Excluded);
    const auto isLater = [](const SeedPlace& a, const SeedPlace& b)
    {
      return std::make_tuple(a.Rank, b.Triangle, b.Vertex) <
        std::make_tuple(b.Rank, a.Triangle, a.Vertex);
    };
    std::make_heap(places.begin(), places.end(), isLater);
    const auto count = static_cast<double>(places.size());
    std::size_t linesThen = 0;
    while (!places.empty() && !this->IsFull())
    {
      std::pop_heap(places.begin(), places.end(), isLater);
      this->FollowFrom(places.back(), progress);
      places.pop_back();
      // The first line fills the surface with those beside it as a rule, and then there are few
      // places left.
      if (this->Lines.size() > 2 * linesThen)
      {
        linesThen = this->Lines.size();
        this->RemoveCovered(places);
        std::make_heap(places.begin(), places.end(), isLater);
      }
      progress.Report(1.0 - static_cast<double>(places.size()) / count);
    }
    return std::move(this->Lines);
  }

private:
  bool IsFull() const
  {
    return static_cast<Index>(this->Lines.size()) >= this->Options.MaximumNumber;
  }

  bool IsOpen(const LineStart& start) const
  {
    return this->IsOpen(this->Spaced.SampleAt(start, 0.0));
  }
  bool IsOpen(const LineSample& sample) const
  {
    const double spacing = this->Options.Spacing;
    return !this->Grid.IsNear(sample, SeedPart * spacing) &&
      !this->Dead.IsNear(sample, DeadPart * spacing);
  }

  /// Traces the lines at a place that are not there yet, one of each family, and all those beside
  /// them.
  void FollowFrom(const SeedPlace& place, const Progress& progress)
  {
    const int families = NumberOfFamilies(this->Field.GetDegree());
    for (int k = 0; k < families && !this->IsFull(); ++k)
    {
      const LineStart start = StartAt(this->Field, place, k);
      if (this->IsOpen(start))
      {
        this->Take(this->Spaced.Trace(start, this->Grid));
        this->FollowFronts(progress);
      }
    }
  }

  /// Leaves out places where there are lines of all families. There never are fewer lines, hence it
  /// does not matter when that happens.
  void RemoveCovered(std::vector<SeedPlace>& places) const
  {
    const auto count = static_cast<Index>(places.size());
    std::vector<char> isCovered(count);
    ParallelFor(count, FewPlaces,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          isCovered[i] = this->IsCovered(places[i]) ? 1 : 0;
        }
      });
    std::size_t left = 0;
    for (Index i = 0; i < count; ++i)
    {
      if (isCovered[i] == 0)
      {
        places[left++] = places[i];
      }
    }
    places.resize(left);
  }

  bool IsCovered(const SeedPlace& place) const
  {
    const int degree = this->Field.GetDegree();
    const SurfaceGeometry& geometry = this->Field.GetGeometry();
    LineSample sample;
    Vector3 ahead;
    Vector3 left;
    if (place.Vertex != None)
    {
      // Without the triangle, which takes much longer.
      const Complex direction =
        std::polar(1.0, std::arg(this->Field.GetSection()[place.Vertex]) / degree);
      const Vector3 x = geometry.Frames.X[place.Vertex];
      const Vector3 y = geometry.Frames.Y(place.Vertex);
      sample.Position = geometry.Positions[place.Vertex];
      sample.Normal = geometry.Frames.Normal[place.Vertex];
      ahead = direction.real() * x + direction.imag() * y;
    }
    else
    {
      sample = this->Spaced.SampleAt(StartAt(this->Field, place, 0), 0.0);
      ahead = sample.Tangent;
    }
    left = sample.Normal.cross(ahead);
    for (int k = 0; k < NumberOfFamilies(degree); ++k)
    {
      sample.Tangent = this->Turns[k].real() * ahead + this->Turns[k].imag() * left;
      if (this->IsOpen(sample))
      {
        return false;
      }
    }
    return true;
  }

  bool MayStart(const LineStart& start) const
  {
    return start.Triangle != None && this->Field.GetMesh().IsFront(start.Triangle) &&
      (this->Excluded.empty() || this->Excluded[start.Triangle] == 0);
  }

  /// The next seed of a front that is open; nothing where the front has no more.
  std::optional<LineStart> NextSeed(Front& front) const
  {
    const std::vector<LineStart>& marks = this->Marks[front.Line];
    while (front.Cursor < marks.size())
    {
      LineStart start = marks[front.Cursor++];
      const Complex side(0.0, front.Side);
      start.Direction *= side;
      LineSample beside = this->Spaced.SampleAt(start, 0.0);
      beside.Position += this->Options.Spacing * beside.Tangent;
      beside.Tangent = beside.Normal.cross(beside.Tangent);
      if (this->Grid.IsNear(beside, SurelyTakenPart * this->Options.Spacing))
      {
        continue;
      }
      start = WalkStraight(this->Field, start, this->Options.Spacing / this->Unit);
      start.Direction *= std::conj(side);
      if (!this->MayStart(start))
      {
        continue;
      }
      start = this->Spaced.Aligned(start);
      if (this->IsOpen(start))
      {
        return start;
      }
    }
    return std::nullopt;
  }

  std::size_t NumberAtOnce() const
  {
    return std::clamp(this->Lines.size() / PartAtOnce, std::size_t(1), MostAtOnce);
  }

  /// Traces lines beside all there are until no seed is left.
  void FollowFronts(const Progress& progress)
  {
    while (!this->Fronts.empty() && !this->IsFull())
    {
      progress.RequireToGoOn();
      const std::size_t count = std::min(this->Fronts.size(), this->NumberAtOnce());
      std::vector<Front> fronts(this->Fronts.begin(), this->Fronts.begin() + count);
      this->Fronts.erase(this->Fronts.begin(), this->Fronts.begin() + count);
      std::vector<std::optional<SpacedLine>> attempts(count);
      ParallelFor(static_cast<Index>(count), 1,
        [&](Index begin, Index end)
        {
          for (Index i = begin; i < end; ++i)
          {
            if (const std::optional<LineStart> start = this->NextSeed(fronts[i]))
            {
              attempts[i] = this->Spaced.Trace(*start, this->Grid);
            }
          }
        });
      for (std::size_t i = 0; i < count; ++i)
      {
        if (attempts[i])
        {
          // There may be more seeds behind this one.
          this->Fronts.push_back(fronts[i]);
          if (this->IsOpen(attempts[i]->Seed) && !this->IsFull())
          {
            this->Take(std::move(*attempts[i]));
          }
        }
      }
    }
  }

  /// Cuts off the parts of a streamline that are too close to others, and keeps it if it is long
  /// enough.
  void Take(SpacedLine&& line)
  {
    this->Spaced.Cut(line, this->Grid);
    if (line.Length() * this->Unit < this->Options.MinimumLength || line.IsEmpty())
    {
      this->Dead.Insert(this->Spaced.SampleAt(line.Seed, 0.0));
      return;
    }
    line.InsertInto(this->Grid);
    this->Marks.push_back(line.Places());
    const std::size_t number = this->Lines.size();
    this->Lines.push_back(std::move(line).Joined());
    this->Lines.back().Component = this->Component;
    this->Lines.back().Seed = static_cast<Index>(number);
    this->Fronts.push_back({ number, 1 });
    this->Fronts.push_back({ number, -1 });
  }

  const GivenField& Field;
  const EvenOptions& Options;
  const std::vector<char>& Excluded;
  Index Component;
  double Unit;
  SpacedTracing Spaced;
  LineGrid Grid;
  /// Seeds of lines that were too short.
  LineGrid Dead;
  /// From the first direction to that of each family.
  std::vector<Complex> Turns;
  std::vector<TracedStreamline> Lines;
  std::vector<std::vector<LineStart>> Marks;
  std::deque<Front> Fronts;
};
}

std::vector<TracedStreamline> TraceEvenStreamlines(const GivenField& field,
  const SingularPoints& zeros, Index component, const EvenOptions& options,
  const std::vector<char>& excluded, const Progress& progress)
{
  return EvenTracing(field, zeros, component, options, excluded).Run(progress);
}
}
