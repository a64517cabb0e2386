// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_GraphLaplacian_h
#define DirectionFields_GraphLaplacian_h

#include "Support/LargeArray.h"
#include "Types.h"

namespace DirectionFields::Internal
{
/// The Laplacian L of a graph with weighted edges, x^T L x = sum w_ij (x_i - x_j)^2, in single
/// precision: real and without any transport, hence with a quarter of the numbers of the matrices
/// of sections. Compressed rows; the diagonal stands apart.
struct GraphLaplacian
{
  struct Edge
  {
    Index Tail;
    Index Head;
    double Weight;
  };
  GraphLaplacian() = default;
  /// @param edgeAt edgeAt(e) is edge e. Those from a row to itself count for nothing; several edges
  ///               between the same rows add up.
  template <typename EdgeAt>
  GraphLaplacian(Index rows, Index edges, const EdgeAt& edgeAt);

  /// The entries of row v are those from Begin[v] to Begin[v + 1].
  LargeArray<Index> Begin;
  LargeArray<Index> Column;
  /// Weights w_ij; the entries of the matrix are -w_ij.
  LargeArray<float> Weight;
  LargeArray<float> Diagonal;

  Index Rows() const { return static_cast<Index>(this->Diagonal.size()); }
  Index Entries() const { return this->Begin.empty() ? 0 : this->Begin.back(); }
  /// Makes entries of one row and column one.
  void Merge();
};

/// The same as sweeps go through it. How many entries a row has is hard to predict, and a branch
/// that goes wrong takes longer than a few products: each loop is filled up to a multiple of Width
/// by entries of weight 0 in the row's own column.
struct SweptLaplacian
{
  /// The number of rows of a block; a block is swept by itself.
  static constexpr Index BlockRows = 4096;
  /// The number of rows of a piece, where rows do not depend on each other.
  static constexpr Index PieceRows = 2048;
  static constexpr Index Width = 4;

  explicit SweptLaplacian(const GraphLaplacian& matrix);

  /// The entries of row v from Begin[v] to Lower[v] are those in columns of its block before v,
  /// those from there to Inside[v] in columns of its block after v, and those from there to Begin[v
  /// + 1] in columns of other blocks.
  LargeArray<Index> Begin;
  LargeArray<Index> Lower;
  LargeArray<Index> Inside;
  LargeArray<Index> Column;
  LargeArray<float> Weight;
  LargeArray<float> Diagonal;

  Index Rows() const { return static_cast<Index>(this->Diagonal.size()); }
  Index Entries() const { return this->Begin.back(); }
  /// y = L x, by differences of x, so that constants give zero; in double precision. Returns x^T y.
  double Multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;
};

/// The sum of weight times x over entries, whose number is a multiple of SweptLaplacian::Width.
inline float SumOfProducts(
  const float* weights, const Index* columns, Index begin, Index end, const float* x)
{
  float even = 0.0F;
  float odd = 0.0F;
  for (Index k = begin; k < end; k += SweptLaplacian::Width)
  {
    even += weights[k] * x[columns[k]] + weights[k + 1] * x[columns[k + 1]];
    odd += weights[k + 2] * x[columns[k + 2]] + weights[k + 3] * x[columns[k + 3]];
  }
  return even + odd;
}

template <typename EdgeAt>
GraphLaplacian::GraphLaplacian(Index rows, Index edges, const EdgeAt& edgeAt)
  : Begin(static_cast<std::size_t>(rows) + 1, 0)
  , Diagonal(rows, 0.0F)
{
  for (Index e = 0; e < edges; ++e)
  {
    const Edge edge = edgeAt(e);
    const Index counts = edge.Tail != edge.Head ? 1 : 0;
    this->Begin[edge.Tail] += counts;
    this->Begin[edge.Head] += counts;
  }
  Index end = 0;
  for (Index v = 0; v <= rows; ++v)
  {
    end += this->Begin[v];
    this->Begin[v] = end;
  }
  this->Column.resize(end);
  this->Weight.resize(end);
  // Rows are filled from their ends, so that Begin is right at last.
  for (Index e = edges; e-- > 0;)
  {
    const Edge edge = edgeAt(e);
    if (edge.Tail == edge.Head)
    {
      continue;
    }
    const auto weight = static_cast<float>(edge.Weight);
    const Index out = --this->Begin[edge.Tail];
    this->Column[out] = edge.Head;
    this->Weight[out] = weight;
    const Index in = --this->Begin[edge.Head];
    this->Column[in] = edge.Tail;
    this->Weight[in] = weight;
    this->Diagonal[edge.Tail] += weight;
    this->Diagonal[edge.Head] += weight;
  }
}
}

#endif
