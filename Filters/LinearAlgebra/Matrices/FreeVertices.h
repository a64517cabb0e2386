// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FreeVertices_h
#define DirectionFields_FreeVertices_h

#include "Types.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Vertices with given representation vectors.
struct GivenValues
{
  std::vector<Index> Vertices;
  /// One for each of Vertices.
  ComplexVector Values;
};

/// The vertices of a component whose values are not given, numbered among themselves in their
/// order: the index f in K_ff u_f = b_f - K_fc u_c. The index c stands for the given ones.
class FreeVertices
{
public:
  /// @param given different vertices in any order
  /// @param count the vertices of the component
  FreeVertices(const std::vector<Index>& given, Index count);

  /// The free vertices, ascending.
  const std::vector<Index>& GetVertices() const { return this->Vertices; }
  bool IsEmpty() const { return this->Vertices.empty(); }
  bool IsFree(Index v) const { return this->Number[v] != None; }

  /// K_ff, the rows and columns of the free vertices.
  SparseMatrix Principal(const SparseMatrix& matrix) const;
  /// K_f, the columns of the free vertices.
  SparseMatrix Columns(const SparseMatrix& matrix) const;

  /// The values at the free vertices among those at all vertices.
  ComplexVector Gathered(const ComplexVector& all) const;
  /// The given values at their vertices and zero at the free ones.
  ComplexVector Scattered(const GivenValues& given) const;
  /// The free values at the free vertices and the given ones at theirs.
  ComplexVector Joined(const ComplexVector& free, const GivenValues& given) const;

private:
  std::vector<Index> Vertices;
  /// The number of each vertex of the component among the free ones; None for given vertices.
  std::vector<Index> Number;
};
}

#endif
