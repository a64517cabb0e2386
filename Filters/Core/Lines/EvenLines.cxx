// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Lines/EvenLines.h"

#include "Lines/LineSeeds.h"
#include "Lines/SpacedLine.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Lines that are traced at once, at most, and as a part of the lines at hand. While these are few, those
/// that are traced at once come into each other's way, and what is cut off is lost work. It is the same
/// number for any number of threads.
constexpr std::size_t MostAtOnce = 48;
constexpr std::size_t PartAtOnce = 6;
/// Places that are looked at at once for gaps.
constexpr Index PlacesAtOnce = 1 << 13;
constexpr Index FewPlaces = 256;
/// Seeds are at least this part of the spacing away from other lines: the distance through space, from a
/// point that is the spacing away along the surface, is a little less than that.
constexpr double SeedPart = 0.95;
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
  EvenTracing(const GivenField& field, const FieldZeros& zeros, Index component,
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
  }

  std::vector<TracedLine> Run(const Progress& progress)
  {
    const std::vector<SeedPlace> places =
      SeedPlaces(this->Field, this->Component, this->Options.Spacing, this->Excluded);
    const int families = NumberOfFamilies(this->Field.GetDegree());
    const auto count = static_cast<Index>(places.size());
    std::vector<char> isOpen;
    for (Index first = 0; first < count && !this->IsFull(); first += PlacesAtOnce)
    {
      const Index end = std::min(count, first + PlacesAtOnce);
      isOpen.assign((end - first) * families, 0);
      ParallelFor(end - first, FewPlaces,
        [&](Index from, Index to)
        {
          for (Index i = from; i < to; ++i)
          {
            for (int k = 0; k < families; ++k)
            {
              isOpen[i * families + k] = this->IsOpen(StartAt(this->Field, places[first + i], k));
            }
          }
        });
      for (Index i = 0; i < static_cast<Index>(isOpen.size()) && !this->IsFull(); ++i)
      {
        const LineStart start = isOpen[i]
          ? StartAt(this->Field, places[first + i / families], i % families)
          : LineStart();
        if (isOpen[i] && this->IsOpen(start))
        {
          this->Take(this->Spaced.Trace(start, this->Grid));
          this->FollowFronts(progress);
        }
      }
      progress.Report(static_cast<double>(end) / count);
    }
    return std::move(this->Lines);
  }

private:
  bool IsFull() const { return static_cast<Index>(this->Lines.size()) >= this->Options.MostLines; }

  bool IsOpen(const LineStart& start) const
  {
    const double spacing = this->Options.Spacing;
    const LineSample sample = this->Spaced.SampleAt(start, 0.0);
    return !this->Grid.IsNear(sample, SeedPart * spacing) &&
      !this->Dead.IsNear(sample, DeadPart * spacing);
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

  /// Cuts off what has come too close to other lines, and keeps the line if it is long enough.
  void Take(SpacedLine&& line)
  {
    this->Spaced.Cut(line, this->Grid);
    if (line.Length() * this->Unit < this->Options.LeastLength || line.IsEmpty())
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
  std::vector<TracedLine> Lines;
  std::vector<std::vector<LineStart>> Marks;
  std::deque<Front> Fronts;
};
}

std::vector<TracedLine> TraceEvenLines(const GivenField& field, const FieldZeros& zeros,
  Index component, const EvenOptions& options, const std::vector<char>& excluded,
  const Progress& progress)
{
  return EvenTracing(field, zeros, component, options, excluded).Run(progress);
}
}
