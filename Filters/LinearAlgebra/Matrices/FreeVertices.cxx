// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Matrices/FreeVertices.h"

#include "Matrices/SparseProducts.h"
#include "Matrices/VectorOperations.h"

#include <cstddef>

namespace DirectionFields::Internal
{
FreeVertices::FreeVertices(const std::vector<Index>& given, Index count)
  : Number(count, 0)
{
  for (const Index v : given)
  {
    this->Number[v] = None;
  }
  for (Index v = 0; v < count; ++v)
  {
    if (this->Number[v] != None)
    {
      this->Number[v] = static_cast<Index>(this->Vertices.size());
      this->Vertices.push_back(v);
    }
  }
}

SparseMatrix FreeVertices::Principal(const SparseMatrix& matrix) const
{
  return SelectedColumns(matrix, this->Vertices, static_cast<Index>(this->Vertices.size()),
    [number = this->Number.data()](Index row) { return number[row]; });
}

SparseMatrix FreeVertices::Columns(const SparseMatrix& matrix) const
{
  return SelectedColumns(matrix, this->Vertices);
}

ComplexVector FreeVertices::Gathered(const ComplexVector& all) const
{
  ComplexVector free = Uninitialized(static_cast<Eigen::Index>(this->Vertices.size()));
  ForRows(free,
    [&](Index begin, Index end)
    {
      for (Index k = begin; k < end; ++k)
      {
        free[k] = all[this->Vertices[k]];
      }
    });
  return free;
}

ComplexVector FreeVertices::Scattered(const GivenValues& given) const
{
  ComplexVector all = Zeros(static_cast<Eigen::Index>(this->Number.size()));
  for (std::size_t k = 0; k < given.Vertices.size(); ++k)
  {
    all[given.Vertices[k]] = given.Values[static_cast<Eigen::Index>(k)];
  }
  return all;
}

ComplexVector FreeVertices::Joined(const ComplexVector& free, const GivenValues& given) const
{
  ComplexVector all = this->Scattered(given);
  ForRows(free,
    [&](Index begin, Index end)
    {
      for (Index k = begin; k < end; ++k)
      {
        all[this->Vertices[k]] = free[k];
      }
    });
  return all;
}
}
