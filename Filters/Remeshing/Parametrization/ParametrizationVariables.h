// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ParametrizationVariables_h
#define DirectionFields_ParametrizationVariables_h

#include "Charts/FeatureIsolines.h"
#include "Integers/IntegerElimination.h"
#include "Parametrization/RowDistances.h"

#include <map>
#include <vector>

namespace DirectionFields::Internal
{
/// A point of the grid's plane whose coordinates are sums of variables.
struct SymbolicGridPoint
{
  IntegerSum A;
  IntegerSum B;

  void Add(const SymbolicGridPoint& other, std::int64_t factor);
  /// zeta^turn times this.
  SymbolicGridPoint Turned(int turn, int degree) const;
};

/// The variables of a map: two coordinates of each vertex in its own chart, two of each jump, the
/// coordinate across each feature at a vertex, and the lengths of short features. Elimination
/// leaves the free ones.
class ParametrizationVariables
{
public:
  /// The mesh must live as long.
  explicit ParametrizationVariables(const CutMesh& mesh);

  /// Not 0 for each feature isoline that rounding could shorten to nothing.
  /// @param perLength 1 / h of each vertex, h the wanted length of an edge of the grid
  std::vector<char> ShortIsolines(const std::vector<double>& perLength) const;
  /// From now on the lengths of these feature isolines are variables, as far as they can be free,
  /// so that rounding can give each of them at least one edge.
  void BoundIsolines(const std::vector<char>& isShort);
  /// The same for these distances of cones and lines.
  void BoundDistances(const std::vector<RowDistance>& distances);

  /// The coordinates of a corner in the chart of its triangle.
  SymbolicGridPoint Corner(Index t, int c) const;

  const CutMesh& Mesh;
  int Degree;
  Index Vertices;
  /// Vertices that have to be grid points: cones, and the ends of features.
  std::vector<char> IsPoint;
  /// The variable of a vertex and the turn that makes it the second coordinate.
  std::map<std::pair<Index, int>, Index> AcrossFeature;
  IntegerElimination Solved;
  std::vector<FeatureIsoline> Isolines;
  /// The variables that are to be at least 1; those among them that are distances.
  std::vector<Index> Bounded;
  std::vector<Index> BoundedDistances;

private:
  SymbolicGridPoint Vertex(Index v) const { return { { { 2 * v, 1 } }, { { 2 * v + 1, 1 } } }; }
  SymbolicGridPoint Jumps(const SymbolicTransition& t) const;
  /// By how much the two coordinates change along an isoline, the first one in its direction.
  SymbolicGridPoint Along(const CutMesh::IsolineEdge& edge) const;
  std::vector<char> Flags();
  /// Makes a sum a variable with a bound, if it depends on integers only, and on few.
  void Bound(IntegerSum length);
  void DropSolvedBounds();
  void FixOrigin();
  void FixCones();
};
}

#endif
