// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LaplacianHierarchy_h
#define DirectionFields_LaplacianHierarchy_h

#include "Laplacian/GraphLaplacian.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The matrix P that interpolates numbers of the next coarser level, and its transpose, which takes
/// residuals there.
struct NumberProlongator
{
  /// The entries of row v are those from Begin[v] to End[v]; rows are filled up to a multiple of
  /// SweptLaplacian::Width by zeros, as in a SweptLaplacian.
  LargeArray<Index> Begin;
  LargeArray<Index> End;
  LargeArray<Index> Column;
  LargeArray<float> Value;
  LargeArray<Index> AdjointBegin;
  LargeArray<Index> AdjointColumn;
  LargeArray<float> AdjointValue;

  Index FineRows() const { return static_cast<Index>(this->Begin.size()) - 1; }
  Index CoarseRows() const { return static_cast<Index>(this->AdjointBegin.size()) - 1; }

  /// Fills in the transpose, its rows in ascending order of the fine rows.
  /// @param coarse the number of columns
  void AddAdjoint(Index coarse);
  /// x += P y
  void AddTo(float* x, const float* y) const;
  /// y = P^T x
  void Restrict(const float* x, float* y) const;
};

/// A hierarchy of ever smaller Laplacians by smoothed aggregation (P. Vaněk, J. Mandel, M. Brezina,
/// Algebraic Multigrid by Smoothed Aggregation, 1996), for functions on a surface. Hierarchy is the
/// one for sections, whose values are complex and are transported along edges: this one takes a
/// third of its time.
class LaplacianHierarchy
{
public:
  struct Level
  {
    SweptLaplacian Matrix;
    /// The share of each row in the whole mass.
    LargeArray<float> Mass;
    /// Interpolates from the next coarser level; empty on the coarsest.
    NumberProlongator FromCoarser;
  };

  /// The coarsest level has no more rows than this, where coarsening goes on to its end.
  static constexpr Index CoarsestRows = 150;

  /// @param finest of a connected graph
  /// @param mass   of each row, above 0
  LaplacianHierarchy(GraphLaplacian&& finest, const Eigen::VectorXd& mass);

  const std::vector<Level>& GetLevels() const { return this->Levels; }

private:
  std::vector<Level> Levels;
};
}

#endif
