// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_StreamlineTrace_h
#define DirectionFields_StreamlineTrace_h

#include "Streamlines.h"
#include "Streamlines/SingularPoints.h"

#include <atomic>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace DirectionFields::Internal
{
/// A straight piece of a line within one triangle laid flat. Directions are unit numbers along the
/// line.
struct LinePiece
{
  Index Triangle = None;
  Complex Begin, End;
  Complex BeginDirection, EndDirection;
  /// The line's length up to Begin, in the unit of the component; behind its seed negative.
  double Arc = 0.0;

  double Length() const { return std::abs(this->End - this->Begin); }
  LinePiece Reversed() const
  {
    return { this->Triangle, this->End, this->Begin, -this->EndDirection, -this->BeginDirection,
      -this->Arc - this->Length() };
  }
};

/// Where a line starts.
struct LineStart
{
  Index Triangle = None;
  Complex Place;
  /// Of unit length: the line follows the field's direction that is nearest to it.
  Complex Direction;
  /// -1: the line runs against the field. For odd n only: for even n the opposite of a direction is
  /// one.
  int Sense = 1;
};

/// Keeps the pieces of lines, on all threads, few enough for the memory.
class PieceLimit
{
public:
  explicit PieceLimit(Index triangles);

  /// To be called for each line each time that PerCall more of its pieces are made. Throws
  /// std::invalid_argument where the line, or all lines together, have too many: that does not
  /// depend on the threads.
  /// @param ofLine the pieces that this line has
  void Count(std::size_t ofLine) const;
  /// The same for lines that may be cut off: it counts none of them.
  void RequireFew(std::size_t ofLine) const;
  static constexpr std::size_t PerCall = 1024;

private:
  std::size_t MostOfLine;
  mutable std::atomic<std::size_t> Counted{ 0 };
};

/// A field and its singularities, as lines are traced on.
struct TracedField
{
  const GivenField& Field;
  const SingularPoints& Zeros;
  const PieceLimit& Limit;
  /// No piece is longer, in the unit of the component. Short steps make smooth lines in large
  /// triangles.
  double LongestStep = 1e300;
  /// The distance at which a line runs into a singularity, as a part of the size of its triangle.
  double Capture = 0.01;

  /// The field's direction nearest to a given one; times the sense.
  static Complex DirectionNear(const Complex& power, int degree, const Complex& near, int sense);
};

/// A line that is followed piece by piece.
///
/// Within a triangle it is a solution of dz/ds = (the direction nearest to the last one), by the
/// classical Runge-Kutta method in the plane of the flat triangle with steps of a quarter of its
/// size. Where a step leaves the triangle, the place on the edge is that of the cubic through both
/// its ends with the directions there, and the line goes on in the next triangle from the same
/// place under the same angle against the edge: the field is continuous there (FieldInterpolant.h).
/// A line keeps a little off the vertices, and passes beside them.
class StreamlineTrace
{
public:
  StreamlineTrace(const TracedField& field, const LineStart& start);

  /// The next piece. Where there is none, End() says why.
  std::optional<LinePiece> Next();
  /// Leaves out the singularity that the line starts at until it is away from it.
  void StartAtZero(double arc);

  StreamlineEnd End() const { return this->Reason; }
  /// The singularity that the line has run into; None if it has not.
  Index EndZero() const { return this->RanInto; }
  Index Triangle() const { return this->Power.has_value() ? this->Current : None; }
  const Complex& Place() const { return this->At; }
  const Complex& Direction() const { return this->Heading; }

private:
  struct Step
  {
    Complex Place, BeginDirection, EndDirection;
    double Length;
  };
  void Enter(Index triangle);
  Complex DirectionAt(const Complex& place, const Complex& near) const;
  double StepLength() const;
  /// If a singularity of another triangle is near enough, the line runs straight into it.
  bool RunsIntoBeside();
  Step Advance(double length) const;
  /// The edge that a step leaves through, as its first corner, and cuts the step there; None if it
  /// stays.
  int CutAtExit(Step& step) const;
  /// Moves the end of a step into the triangle. Returns None: it does not leave.
  int MoveInside(Step& step) const;
  void Cross(int edge, const Step& step);

  const TracedField& Traced;
  std::optional<FieldInterpolant> Power;
  Index Current = None;
  Complex At, Heading;
  int Sense;
  double Size = 0.0;
  Index Zero = None;
  Complex ZeroPlace;
  std::pair<const ZeroBeside*, const ZeroBeside*> Beside = { nullptr, nullptr };
  /// The remaining straight pieces into a singularity, the last one first.
  std::vector<LinePiece> PiecesInto;
  double Done = 0.0;
  double FreeUntil = 0.0;
  int WithoutProgress = 0;
  /// How many steps there were, and the length when they were looked at last.
  Index Steps = 0;
  double LookedAt = 0.0;
  StreamlineEnd Reason = StreamlineEnd::None;
  Index RanInto = None;
};

/// Goes straight on over the surface for a length, in the unit of the component; as far as there is
/// surface.
/// @return the place and the direction at the end; Triangle is None where the walk has left the
///         surface
/// @param pieces receives the pieces of the walk where it is not null
LineStart WalkStraight(const GivenField& field, const LineStart& start, double length,
  std::vector<LinePiece>* pieces = nullptr);
}

#endif
