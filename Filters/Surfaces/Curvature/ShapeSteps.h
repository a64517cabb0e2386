// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ShapeSteps_h
#define DirectionFields_ShapeSteps_h

#include "Curvature/ShapeAverages.h"
#include "Curvature/ShapeFit.h"
#include "Geometry/SurfaceGeometry.h"
#include "Mesh/PieceOfSurface.h"
#include "Support/Threads.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Shapes on their way to larger and larger surroundings, of which each step takes the means with
/// the neighbours. Vertices are open while they take part in the steps; those that are closed keep
/// a shape, which their neighbours go on to use.
class ShapeSteps
{
public:
  /// A step adds the same number to the mean squared distance of the vertices in the mean, in
  /// squared edges; for the points of a fitted quadric that distance is FitRadius^2 / 2.
  static constexpr double FitRadius = 1.5;
  /// The steps after which values come from this squared radius more, in edges.
  static int StepsOver(double squaredRadius);

  /// The means at the fitted vertices of a component, and about the variances that are left.
  void Write(const TriangleMesh::Component& component, std::vector<Shape>& shapes) const;

protected:
  /// All vertices with a shape are open.
  ShapeSteps(
    const SurfaceGeometry& geometry, const std::vector<Shape>& shapes, const PieceOfSurface& piece);

  bool IsAnyOpen() const { return this->Piece.Any(!this->Open.empty()); }

  /// Averages the open vertices.
  void Step(int steps);

  /// Keeps a shape at an open vertex; ForgetClosed is to be called afterwards.
  void Close(Index v, const WeightedShape& value);
  void ForgetClosed();
  /// Closes decided vertices with the shapes that are kept, as far as they are out of reach of
  /// those that go on for so many steps more.
  void CloseDecided(const std::vector<char>& isDecided, int steps);

  /// Lets the means of what is still open end at the surface's boundary, where errors of heights do
  /// not cancel in integrals. Vertices there take the means of their neighbours.
  void EndAtBoundary(const SurfaceGeometry& geometry);

  template <typename Body>
  void ForOpen(const Body& body) const
  {
    ParallelFor(static_cast<Index>(this->Open.size()), MediumPiece,
      [&](Index begin, Index end)
      {
        for (Index k = begin; k < end; ++k)
        {
          body(this->Open[k]);
        }
      });
  }

  /// Replaces the numbers of the open vertices by means with those of open neighbours, of so many
  /// steps.
  void Average(std::vector<float>& numbers, int steps) const;

  /// Numbers of the open vertices, averaged over their surroundings.
  template <typename Number>
  std::vector<float> Around(const Number& number) const
  {
    // So many that a few vertices do not decide.
    constexpr int steps = 4;
    std::vector<float> numbers(this->Current.size());
    this->ForOpen([&](Index v) { numbers[v] = number(v); });
    this->Average(numbers, steps);
    return numbers;
  }

  /// The squared changes of the open vertices since then, averaged over their surroundings.
  std::vector<float> Changes(const std::vector<WeightedShape>& then) const;

  static double SquaredDistance(const WeightedShape& a, const WeightedShape& b);

  const PieceOfSurface& Piece;
  ShapeAverages Mean;
  std::vector<WeightedShape> Current;
  std::vector<WeightedShape> Scratch;
  /// The averages that paid.
  std::vector<WeightedShape> Kept;
  /// The vertices of the piece that are averaged on; IsOpen also tells those next to them.
  std::vector<Index> Open;
  std::vector<char> IsOpen;
  /// How many steps each vertex has come.
  std::vector<int> Steps;
};
}

#endif
