// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_StripeLevels_h
#define DirectionFields_StripeLevels_h

#include "Stripes/WantedPhases.h"

#include <array>
#include <cstdint>
#include <vector>

namespace DirectionFields::Internal
{
/// The steps that phases take along the edges of a surface: of all that lead to the phase at the
/// end, up to whole cycles, the one nearest to the wanted step. Several cycles along an edge are as
/// good as none.
class StripePhases
{
public:
  /// @param phases over all nodes, in cycles, finite
  /// @param offset in cycles: lines have this phase; 0 or 1/2 where a component has two sheets
  StripePhases(const WantedPhases& wanted, std::vector<double> phases, double offset);

  const WantedPhases& GetWanted() const { return this->Wanted; }
  double GetOffset() const { return this->Offset; }
  /// The phase of a node, moved by up to a millionth of a cycle so that neither lines nor the
  /// borders of bands run through nodes.
  double Phase(Index node) const { return this->Phases[node]; }
  /// The step along a half-edge as Use names it ends at this many cycles more than the phase of its
  /// head, which is negative where the edge flips.
  std::int64_t Cycles(Index edge) const { return this->EdgeCycles[edge]; }

private:
  const WantedPhases& Wanted;
  double Offset;
  std::vector<double> Phases;
  LargeArray<std::int64_t> EdgeCycles;
};

/// The levels that are cut out of a stripe pattern.
enum class LevelKind
{
  /// The middles of stripes: one level a cycle.
  Lines,
  /// Their borders, a quarter of a cycle from the middles: two levels a cycle.
  Borders
};

/// Where the levels of a function of the phase, the whole numbers, cross the edges of a surface.
/// All that tells how often, and in which order, are whole numbers, which the two triangles at an
/// edge share.
class StripeLevels
{
public:
  StripeLevels(const StripePhases& phases, LevelKind kind);

  const WantedPhases& GetWanted() const { return this->Phases.GetWanted(); }
  /// All crossings of edges, numbered edge by edge.
  std::int64_t GetNumberOfCrossings() const { return this->First.back(); }

  /// A side of a triangle or of a piece of one: the levels that cross it, as the numbers of their
  /// points.
  struct Side
  {
    std::int64_t First = 0;
    /// How many there are; negative for levels that are crossed downwards.
    std::int64_t Signed = 0;
    /// The last point is the first one.
    bool IsBackward = false;

    std::int64_t Count() const { return this->Signed < 0 ? -this->Signed : this->Signed; }
    std::int64_t Point(std::int64_t k) const
    {
      return this->First + (this->IsBackward ? this->Count() - 1 - k : k);
    }
    Side Reversed() const { return { this->First, -this->Signed, !this->IsBackward }; }
  };

  /// A triangle with the values of the function at its corners, as seen from the first one. The
  /// function of the second sheet is Mirror - y.
  struct Corners
  {
    /// The last one is the first corner after a turn.
    std::array<std::int64_t, 4> Floor;
    std::array<double, 4> Value;
    std::array<Side, 3> Sides;
    /// The turn ends on the other sheet.
    bool Flips;
    /// The number of levels gained by a turn that does not flip.
    std::int64_t Gain() const { return this->Floor[3] - this->Floor[0]; }
  };
  Corners At(Index triangle) const;

  /// Where a crossing is: on this half-edge of the mesh, at this part of it from its tail.
  struct Place
  {
    Index HalfEdge;
    double Part;
  };
  /// Calls body(point, place) for all crossings of an edge.
  template <typename Body>
  void ForCrossings(Index edge, const Body& body) const
  {
    const Index h = this->GetWanted().GetMesh().HalfEdge(edge);
    const std::int64_t count = this->First[edge + 1] - this->First[edge];
    if (count == 0)
    {
      return;
    }
    const double begin = this->Value(this->GetWanted().Node(this->GetWanted().GetMesh().Tail(h)));
    const double end = this->EndValue(edge);
    const bool up = end > begin;
    const double first = std::floor(begin) + (up ? 1.0 : 0.0);
    for (std::int64_t k = 0; k < count; ++k)
    {
      const double level = first + (up ? 1.0 : -1.0) * static_cast<double>(k);
      body(this->First[edge] + k, Place{ h, (level - begin) / (end - begin) });
    }
  }

  /// The phase of a value in cycles from the middle of a line.
  double Phase(double value) const { return (value - this->Zero) / this->Factor; }

private:
  double Value(Index node) const { return this->Factor * this->Phases.Phase(node) + this->Shift; }
  /// At the end of an edge's half-edge.
  double EndValue(Index edge) const;
  std::int64_t EndFloor(Index edge) const;
  /// The whole cycles of the end value over that of the head, in this function.
  std::int64_t EndTurns(Index edge) const;

  const StripePhases& Phases;
  /// The function is Factor phase + Shift; Zero is its value at the middle of a line, and Mirror -
  /// y that of the second sheet, up to an even number.
  std::int64_t Factor;
  double Shift;
  double Zero;
  std::int64_t Mirror;
  LargeArray<std::int64_t> First;
};
}

#endif
