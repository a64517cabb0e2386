// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Streamlines/MotorcycleGraph.h"

#include "Streamlines/LineMeetings.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
constexpr double Never = std::numeric_limits<double>::infinity();
/// The first round's length, in mean edges.
constexpr double FirstRound = 8.0;
/// The pieces that a line has at most after the first round. Each round that this has kept short
/// doubles it: lines that wind around have many more pieces than those that they will end at.
constexpr std::size_t FirstPieces = 4096;
/// The most meetings that are looked at in one round, for all lines and for each one. Where there
/// are more, most of them are of lines that have ended before, and a shorter round leaves them out.
constexpr std::size_t MostMeetings = 100000;
constexpr std::size_t MostMeetingsOfLine = 256;
/// The part by which trails go on beyond their ends, against rounding.
constexpr double BeyondEnd = 1e-6;
/// A line runs into a singularity along a ray of it if it comes from that direction within this
/// angle.
constexpr double SameRay = Pi;

/// A line that is traced on from round to round.
struct Motorcycle
{
  ZeroRay Ray;
  std::unique_ptr<StreamlineTrace> Trace;
  TracedStreamline Line;
  /// The length at which the trace begins.
  double Before = 0.0;
  /// The line that is this one turned around; None without one.
  Index Reverse = None;
  /// When it stops, and at which line, as of the last round.
  double End = Never;
  Index Stopper = None;
  bool MeetsReverse = false;

  bool IsTraced() const { return this->Line.Ends[1] != StreamlineEnd::None; }
  /// When it stops if no other line stops it.
  double OwnEnd() const { return this->IsTraced() ? this->Line.Length() : Never; }
};

class Motorcycles
{
public:
  Motorcycles(const TracedField& field, const std::vector<ZeroRay>& rays, double mostLength)
    : Traced(field)
    , MaximumLength(mostLength)
    , Riders(rays.size())
  {
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      Motorcycle& rider = this->Riders[i];
      rider.Ray = rays[i];
      const RayStart start = StartOf(field, rays[i]);
      rider.Line = BeginOf(rays[i], start);
      rider.Before = rider.Line.Length();
      if (start.Start.Triangle != None)
      {
        rider.Trace = std::make_unique<StreamlineTrace>(field, start.Start);
        rider.Trace->StartAtZero(start.FreeUntil);
      }
    }
  }

  std::vector<TracedStreamline> Run(const Progress& progress)
  {
    double before = 0.0;
    double step = FirstRound;
    while (true)
    {
      double time = before + step;
      const double all = std::min(2.0 * time, this->MaximumLength);
      const double traced = this->TraceTo(all);
      this->FindReverses();
      if (traced < all)
      {
        // Lines are known to twice the time: those of a pair meet in the middle.
        time = std::min(time, 0.5 * traced);
        this->MostPieces *= 2;
        this->LeavesOutTrails = true;
      }
      if (!(time > before))
      {
        progress.RequireToGoOn();
        continue;
      }
      while (!this->FindEnds(time))
      {
        progress.RequireToGoOn();
        this->LeavesOutTrails = true;
        time = this->Between(before, time);
      }
      std::size_t riding = 0;
      for (const Motorcycle& rider : this->Riders)
      {
        riding += rider.End > time ? 1 : 0;
      }
      if (riding == 0 || time >= this->MaximumLength)
      {
        break;
      }
      progress.Report(1.0 - static_cast<double>(riding) / this->Riders.size());
      step = std::min(2.0 * (time - before), time);
      before = time;
    }
    return this->Finished();
  }

private:
  /// The middle of a round that is too long.
  double Between(double begin, double end) const
  {
    const double middle = begin + 0.5 * (end - begin);
    if (!(middle > begin && middle < end))
    {
      this->Traced.Limit.RequireFew(std::numeric_limits<std::size_t>::max());
    }
    return middle;
  }

  /// Traces lines to a length, or until they have as many pieces as they may.
  /// @return the length that all have, but for those that end before
  double TraceTo(double length)
  {
    ParallelFor(static_cast<Index>(this->Riders.size()), 1,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          Motorcycle& rider = this->Riders[i];
          if (rider.End < Never || rider.IsTraced())
          {
            continue;
          }
          TracedStreamline& line = rider.Line;
          while (line.Length() < length && line.Pieces.size() < this->MostPieces)
          {
            std::optional<LinePiece> piece = rider.Trace->Next();
            if (!piece)
            {
              line.Ends[1] = rider.Trace->End();
              line.Zeros[1] = rider.Trace->EndZero();
              break;
            }
            if (line.Pieces.size() % PieceLimit::PerCall == PieceLimit::PerCall - 1)
            {
              this->Traced.Limit.Count(line.Pieces.size());
            }
            piece->Arc += rider.Before;
            line.Pieces.push_back(*piece);
          }
          if (!rider.IsTraced() && line.Length() >= this->MaximumLength)
          {
            line.Ends[1] = StreamlineEnd::Length;
          }
        }
      });
    for (const Motorcycle& rider : this->Riders)
    {
      if (rider.End == Never && !rider.IsTraced())
      {
        length = std::min(length, rider.Line.Length());
      }
    }
    return length;
  }

  /// Turns each line that has run into a singularity into the one that comes from there.
  void FindReverses()
  {
    for (Index i = 0; i < static_cast<Index>(this->Riders.size()); ++i)
    {
      Motorcycle& rider = this->Riders[i];
      if (rider.Line.Zeros[1] == None || rider.Reverse != None)
      {
        continue;
      }
      const Index other = this->RayAlong(rider.Line);
      if (other == None || other == i || this->Riders[other].Reverse != None)
      {
        continue;
      }
      Motorcycle& reverse = this->Riders[other];
      const double length = rider.Line.Length();
      reverse.Line.Pieces.clear();
      for (auto piece = rider.Line.Pieces.rbegin(); piece != rider.Line.Pieces.rend(); ++piece)
      {
        reverse.Line.Pieces.push_back(piece->Reversed());
        reverse.Line.Pieces.back().Arc += length;
      }
      reverse.Line.Ends[1] = StreamlineEnd::Singularity;
      reverse.Line.Zeros[1] = rider.Line.Zeros[0];
      rider.Reverse = other;
      reverse.Reverse = i;
    }
  }

  /// The ray of the singularity at a line's end that the line has come along.
  Index RayAlong(const TracedStreamline& line) const
  {
    const LinePiece& last = line.Pieces.back();
    const SingularPoint& zero = this->Traced.Zeros.GetZeros()[line.Zeros[1]];
    Complex from = last.Begin;
    if (last.Triangle != zero.Triangle)
    {
      from = Mirrored(this->Traced.Field, last.Triangle, from);
    }
    const double angle = std::arg(from - zero.Place);
    const auto before = [](const Motorcycle& rider, Index number)
    { return rider.Ray.Zero < number; };
    auto at = std::lower_bound(this->Riders.begin(), this->Riders.end(), line.Zeros[1], before);
    Index nearest = None;
    double least = SameRay;
    for (; at != this->Riders.end() && at->Ray.Zero == line.Zeros[1]; ++at)
    {
      const double turn = std::abs(std::arg(std::polar(1.0, at->Ray.Angle - angle)));
      // The one that the field runs against, for odd n.
      const bool fits = this->Traced.Field.GetDegree() % 2 == 0 || at->Ray.Sense == -line.Sense;
      if (fits && turn < least)
      {
        least = turn;
        nearest = static_cast<Index>(at - this->Riders.begin());
      }
    }
    return nearest;
  }

  /// How far others can meet a line, up to a time.
  double TrailOf(const Motorcycle& rider, double time) const
  {
    return this->LeavesOutTrails && rider.Reverse == None
      ? std::min(time, (1.0 + BeyondEnd) * rider.End)
      : time;
  }

  /// Finds when each line stops, up to a time.
  /// @return false where so many lines meet that nothing was done
  bool FindEnds(double time)
  {
    std::vector<Trail> trails;
    for (const Motorcycle& rider : this->Riders)
    {
      trails.push_back({ &rider.Line.Pieces, this->TrailOf(rider, time) });
    }
    std::optional<std::vector<Meeting>> found = FindMeetings(
      this->Traced.Field, trails, [this](Index a, Index b) { return this->Riders[a].Reverse == b; },
      MostMeetings + MostMeetingsOfLine * this->Riders.size());
    if (!found)
    {
      return false;
    }
    std::vector<Meeting>& meetings = *found;
    for (Index i = 0; i < static_cast<Index>(this->Riders.size()); ++i)
    {
      Motorcycle& rider = this->Riders[i];
      const bool isPair = rider.Reverse != None;
      rider.End = isPair || rider.OwnEnd() > time ? Never : rider.OwnEnd();
      rider.Stopper = None;
      rider.MeetsReverse = false;
      const double half = 0.5 * rider.Line.Length();
      if (isPair && rider.Reverse > i && half <= time)
      {
        meetings.push_back({ i, rider.Reverse, half, half });
      }
    }
    this->AddMeetingsOfPairs(meetings);
    std::stable_sort(meetings.begin(), meetings.end(),
      [](const Meeting& a, const Meeting& b) { return a.Late < b.Late; });
    for (const Meeting& meeting : meetings)
    {
      Motorcycle& rider = this->Riders[meeting.Line];
      Motorcycle& other = this->Riders[meeting.Other];
      if (meeting.Late > time || rider.End <= meeting.Late || other.End < meeting.Early)
      {
        continue;
      }
      if (rider.Reverse == meeting.Other && meeting.Late == 0.5 * rider.Line.Length())
      {
        if (other.End > meeting.Early)
        {
          rider.End = meeting.Late;
          other.End = meeting.Early;
          rider.MeetsReverse = other.MeetsReverse = true;
        }
        continue;
      }
      rider.End = meeting.Late;
      rider.Stopper = meeting.Other;
    }
    // No shorter streamline can still come in between; a streamline of a pair ends in its
    // singularity where the other one was stopped.
    for (Motorcycle& rider : this->Riders)
    {
      if (rider.End == Never && rider.OwnEnd() <= time)
      {
        rider.End = rider.OwnEnd();
      }
    }
    return true;
  }

  /// Where a line of a pair crosses itself, the other one crosses it: that is the same line turned
  /// around.
  void AddMeetingsOfPairs(std::vector<Meeting>& meetings) const
  {
    const std::size_t count = meetings.size();
    for (std::size_t m = 0; m < count; ++m)
    {
      const Meeting own = meetings[m];
      const Index reverse = this->Riders[own.Line].Reverse;
      if (own.Line == own.Other && reverse != None)
      {
        const double there = this->Riders[own.Line].Line.Length() - own.Late;
        meetings.push_back(own.Early > there ? Meeting{ own.Line, reverse, own.Early, there }
                                             : Meeting{ reverse, own.Line, there, own.Early });
      }
    }
  }

  std::vector<TracedStreamline> Finished()
  {
    // Of two that are one edge the second is left out.
    std::vector<Index> number(this->Riders.size(), None);
    Index count = 0;
    for (Index i = 0; i < static_cast<Index>(this->Riders.size()); ++i)
    {
      const Motorcycle& rider = this->Riders[i];
      number[i] = rider.MeetsReverse && rider.Reverse < i ? number[rider.Reverse] : count++;
    }
    std::vector<TracedStreamline> lines;
    for (Index i = 0; i < static_cast<Index>(this->Riders.size()); ++i)
    {
      Motorcycle& rider = this->Riders[i];
      if (number[i] != static_cast<Index>(lines.size()))
      {
        continue;
      }
      TracedStreamline& line = rider.Line;
      if (!rider.MeetsReverse && rider.End < line.Length())
      {
        Cut(line, rider.End);
        line.Ends[1] = StreamlineEnd::Crossing;
        line.Zeros[1] = None;
        line.Crossed[1] = rider.Stopper == None ? None : number[rider.Stopper];
      }
      lines.push_back(std::move(line));
    }
    return lines;
  }

  static void Cut(TracedStreamline& line, double length)
  {
    // On an edge, up to rounding, it ends in the triangle where it was found to meet the other one.
    const double rounding = 1e-8 * (1.0 + length);
    while (line.Pieces.size() > 1 && line.Pieces.back().Arc > length + rounding)
    {
      line.Pieces.pop_back();
    }
    LinePiece& last = line.Pieces.back();
    const double whole = last.Length();
    const double part = whole > 0.0 ? std::clamp((length - last.Arc) / whole, 0.0, 1.0) : 1.0;
    last.End = last.Begin + part * (last.End - last.Begin);
    const Complex direction =
      last.BeginDirection + part * (last.EndDirection - last.BeginDirection);
    last.EndDirection = direction / std::abs(direction);
  }

  const TracedField& Traced;
  double MaximumLength;
  std::vector<Motorcycle> Riders;
  /// The most pieces of a line as of this round.
  std::size_t MostPieces = FirstPieces;
  /// Whether the parts of lines behind their ends are left out of the search for meetings. They
  /// change nothing but the time, unless a pair is found later.
  bool LeavesOutTrails = false;
};
}

std::vector<TracedStreamline> TraceMotorcycleGraph(const TracedField& field,
  const std::vector<ZeroRay>& rays, double mostLength, const Progress& progress)
{
  return Motorcycles(field, rays, mostLength).Run(progress);
}
}
