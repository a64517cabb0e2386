// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SpacedLine_h
#define DirectionFields_SpacedLine_h

#include "Streamlines/LineGrid.h"
#include "Streamlines/TracedStreamline.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Lengths are in the unit of the surface.
struct EvenOptions
{
  /// The distance at which streamlines of a family start beside each other.
  double Spacing = 1.0;
  /// They end where their distance falls below this part of the spacing.
  double Ratio = 0.5;
  double MaximumLength = 0.0;
  /// Shorter lines are left out.
  double MinimumLength = 0.0;
  Index MaximumNumber = 0;
};

/// Half of a streamline that keeps its distance: from the seed in one direction.
struct SpacedHalf
{
  /// A sample of the line, a fraction of the spacing after the last one, or less where it turns.
  struct Mark
  {
    LineSample Sample;
    /// The piece that the sample is on, and the part of the piece before it.
    std::size_t Piece;
    double Part;
    LineStart Place;
  };
  std::vector<LinePiece> Pieces;
  std::vector<Mark> Marks;
  StreamlineEnd End = StreamlineEnd::None;
  Index Zero = None;
  bool IsClosed = false;

  /// Leaves out everything after the first marks.
  void Keep(std::size_t marks);
};

/// A line that keeps its distance from others, as two halves that can be cut still.
struct SpacedLine
{
  LineStart Seed;
  SpacedHalf Forward, Backward;

  bool IsEmpty() const { return this->Forward.Pieces.empty() && this->Backward.Pieces.empty(); }
  /// In the unit of the component.
  double Length() const;
  void InsertInto(LineGrid& grid) const;
  /// Places all along the line from which lines beside it may start, with directions along it.
  std::vector<LineStart> Places() const;
  TracedStreamline Joined() &&;
};

/// Traces lines that keep their distance from others.
class SpacedTracing
{
public:
  /// All must outlive this.
  SpacedTracing(const GivenField& field, const SingularPoints& zeros, Index component,
    const EvenOptions& options);

  LineGrid MakeGrid() const;
  /// The line at a place.
  LineSample SampleAt(const LineStart& start, double arc) const;
  /// With the direction of the field that is nearest to the given one; for odd n it runs with the
  /// field.
  LineStart Aligned(const LineStart& start) const;
  /// A streamline in both directions from a seed until it is too close to a sample in the grid, or
  /// to itself.
  SpacedLine Trace(const LineStart& seed, const LineGrid& grid) const;
  /// Cuts a streamline where it is too close to a sample that the grid has by now.
  void Cut(SpacedLine& line, const LineGrid& grid) const;

private:
  void TraceHalf(const LineStart& start, int sense, double mostLength, const LineGrid& grid,
    LineGrid& own, SpacedHalf& half) const;
  /// Whether a sample is too close to lines in the grid, or to the line itself further back.
  bool IsTooClose(const LineSample& sample, const LineGrid& grid, const LineGrid& own,
    const LineSample& first) const;
  /// Ends a line where its last piece comes back to its first sample; false where it does not.
  bool Closes(const LineSample& first, SpacedHalf& half) const;
  Vector3 PositionOf(Index triangle, const Complex& place) const;

  const GivenField& Field;
  PieceLimit Limit;
  TracedField Traced;
  const EvenOptions& Options;
  Index Component;
  double Unit;
  /// The cosine of the angle that a line turns between samples at most.
  double LeastTurn;
};
}

#endif
