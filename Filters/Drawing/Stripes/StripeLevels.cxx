// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Stripes/StripeLevels.h"

#include "Support/Threads.h"

#include <cmath>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Lines keep this distance from nodes, in cycles.
constexpr double Clearance = 1e-6;

/// The phase, moved away from the multiples of a quarter beyond the offset.
double Cleared(double phase, double offset)
{
  const double quarters = 4.0 * (phase - offset);
  const double rest = quarters - std::floor(quarters);
  const double clear = 4.0 * Clearance;
  if (rest < clear)
  {
    return phase + 0.25 * (clear - rest);
  }
  return rest > 1.0 - clear ? phase - 0.25 * (rest - 1.0 + clear) : phase;
}

std::int64_t FloorOf(double value)
{
  return static_cast<std::int64_t>(std::floor(value));
}
}

StripePhases::StripePhases(const WantedPhases& wanted, std::vector<double> phases, double offset)
  : Wanted(wanted)
  , Offset(offset)
  , Phases(std::move(phases))
  , EdgeCycles(wanted.GetMesh().GetNumberOfEdges())
{
  ParallelFor(wanted.GetNumberOfNodes(), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        this->Phases[v] = Cleared(this->Phases[v], offset);
      }
    });
  const TriangleMesh& mesh = wanted.GetMesh();
  ParallelFor(mesh.GetNumberOfEdges(), MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index e = begin; e < end; ++e)
      {
        const Index h = mesh.HalfEdge(e);
        this->EdgeCycles[e] = 0;
        if (wanted.Use(h).HalfEdge == h)
        {
          const WantedPhases::Step step = wanted.Along(h);
          const double atHead = this->Phases[wanted.Node(mesh.Head(h))];
          const double atTail = this->Phases[wanted.Node(mesh.Tail(h))];
          this->EdgeCycles[e] =
            std::llround(atTail + step.Increment - (step.Flips ? -atHead : atHead));
        }
      }
    });
}

StripeLevels::StripeLevels(const StripePhases& phases, LevelKind kind)
  : Phases(phases)
  , Factor(kind == LevelKind::Lines ? 1 : 2)
  , Shift(kind == LevelKind::Lines ? -phases.GetOffset() : 0.5 - 2.0 * phases.GetOffset())
  , Zero(kind == LevelKind::Lines ? 0.0 : 0.5)
  , Mirror(kind == LevelKind::Lines ? 0 : 1)
{
  const TriangleMesh& mesh = this->GetWanted().GetMesh();
  this->First.resize(mesh.GetNumberOfEdges() + 1);
  this->First[0] = 0;
  ParallelFor(mesh.GetNumberOfEdges(), MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index e = begin; e < end; ++e)
      {
        const Index h = mesh.HalfEdge(e);
        this->First[e + 1] = this->GetWanted().Use(h).HalfEdge == h
          ? std::abs(this->EndFloor(e) - FloorOf(this->Value(this->GetWanted().Node(mesh.Tail(h)))))
          : 0;
      }
    });
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    this->First[e + 1] += this->First[e];
  }
}

std::int64_t StripeLevels::EndTurns(Index edge) const
{
  const Index h = this->GetWanted().GetMesh().HalfEdge(edge);
  const std::int64_t cycles = this->Factor * this->Phases.Cycles(edge);
  // On the other sheet Factor (-phase) + Shift is Mirror - y and these whole numbers more.
  return this->GetWanted().Along(h).Flips ? cycles + std::llround(2.0 * this->Shift) - this->Mirror
                                          : cycles;
}

double StripeLevels::EndValue(Index edge) const
{
  const Index h = this->GetWanted().GetMesh().HalfEdge(edge);
  const double atHead = this->Value(this->GetWanted().Node(this->GetWanted().GetMesh().Head(h)));
  return (this->GetWanted().Along(h).Flips ? static_cast<double>(this->Mirror) - atHead : atHead) +
    static_cast<double>(this->EndTurns(edge));
}

std::int64_t StripeLevels::EndFloor(Index edge) const
{
  const Index h = this->GetWanted().GetMesh().HalfEdge(edge);
  const std::int64_t atHead =
    FloorOf(this->Value(this->GetWanted().Node(this->GetWanted().GetMesh().Head(h))));
  // No value is a whole number.
  return (this->GetWanted().Along(h).Flips ? this->Mirror - 1 - atHead : atHead) +
    this->EndTurns(edge);
}

StripeLevels::Corners StripeLevels::At(Index triangle) const
{
  const WantedPhases& wanted = this->GetWanted();
  const TriangleMesh& mesh = wanted.GetMesh();
  Corners corners{};
  bool onSecond = false;
  corners.Floor[0] = FloorOf(this->Value(wanted.Node(mesh.Tail(3 * triangle))));
  for (int c = 0; c <= 3; ++c)
  {
    const Index h = 3 * triangle + c % 3;
    const double value = this->Value(wanted.Node(mesh.Tail(h)));
    const double rest = value - std::floor(value);
    corners.Value[c] = static_cast<double>(corners.Floor[c]) + (onSecond ? 1.0 - rest : rest);
    if (c == 3)
    {
      break;
    }
    const WantedPhases::EdgeUse use = wanted.Use(h);
    const Index edge = mesh.Edge(use.HalfEdge);
    const bool flips = wanted.Along(h).Flips;
    const std::int64_t rise =
      this->EndFloor(edge) - FloorOf(this->Value(wanted.Node(mesh.Tail(use.HalfEdge))));
    // Against the edge's direction the levels are crossed the other way, but seen from the other
    // sheet, too, where it flips.
    const std::int64_t along = use.Along || flips ? rise : -rise;
    corners.Sides[c] = { this->First[edge], onSecond ? -along : along, !use.Along };
    corners.Floor[c + 1] = corners.Floor[c] + corners.Sides[c].Signed;
    onSecond = onSecond != flips;
  }
  corners.Flips = onSecond;
  return corners;
}
}
