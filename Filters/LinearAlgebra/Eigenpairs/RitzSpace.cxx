// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Eigenpairs/RitzSpace.h"

#include "Matrices/VectorOperations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// A section of unit length is new where projection leaves more of it than this: the rest is
/// rounding.
constexpr double LeastNew = 1e-10;
/// Where the first projection leaves more of it than this, a second one would add no digit.
constexpr double LargePart = 0.5;
constexpr int Width = SectionBlock::Width;

}

RitzSpace::RitzSpace(const Operators& operators)
  : Matrices(operators)
  , Basis(operators.Energy.rows(), MostSections)
{
}

void RitzSpace::Add(ComplexVector section)
{
  if (this->Count == MostSections)
  {
    this->Forget();
  }
  const double length = Norm(section);
  // Twice is enough (Kahan and Parlett).
  for (int pass = 0; this->Count > 0 && pass < 2; ++pass)
  {
    const ComplexVector mass = Product(this->Matrices.Mass, section);
    const SmallMatrix along = this->InnerProducts({ &mass });
    ForRows(section,
      [&](Index begin, Index end)
      { section.segment(begin, end - begin).noalias() -= this->Rows(begin, end) * along.col(0); });
    if (Norm(section) > LargePart * length)
    {
      break;
    }
  }
  if (!(Norm(section) > LeastNew * length))
  {
    return;
  }
  SectionProducts added(this->Matrices, std::move(section));
  const double perLength = 1.0 / std::sqrt(RealDot(added.Vector, added.Mass));
  ForRows(added.Vector,
    [&](Index begin, Index end)
    {
      this->Basis.col(this->Count).segment(begin, end - begin) =
        perLength * added.Vector.segment(begin, end - begin);
    });
  ++this->Count;
  const SmallMatrix products = perLength * this->InnerProducts({ &added.Energy, &added.Mass });
  const auto extend = [&](SmallMatrix& matrix, int column)
  {
    matrix.conservativeResize(this->Count, this->Count);
    matrix.rightCols(1) = products.col(column);
    matrix.bottomRows(1) = products.col(column).adjoint();
  };
  extend(this->Energy, 0);
  extend(this->Mass, 1);
  this->Pairs = RayleighRitz(this->Energy, this->Mass, this->Count);
}

SmallMatrix RitzSpace::InnerProducts(std::initializer_list<const ComplexVector*> vectors) const
{
  const auto columns = static_cast<Eigen::Index>(vectors.size());
  return ParallelSum<SmallMatrix>(static_cast<Index>(this->Basis.rows()), VectorPiece,
    SmallMatrix::Zero(this->Count, columns),
    [&](Index begin, Index end)
    {
      SmallMatrix part(this->Count, columns);
      Eigen::Index column = 0;
      for (const ComplexVector* vector : vectors)
      {
        part.col(column++).noalias() =
          this->Rows(begin, end).adjoint() * vector->segment(begin, end - begin);
      }
      return part;
    });
}

SectionProducts RitzSpace::First(SectionBlock& next) const
{
  const int count = std::min<int>(Width, static_cast<int>(this->Pairs.Values.size()));
  std::array<ComplexVector, Width> sections;
  for (int b = 0; b < count; ++b)
  {
    Resize(sections[b], this->Basis.rows());
  }
  ForRows(sections[0],
    [&](Index begin, Index end)
    {
      const Eigen::MatrixXcd part = this->Rows(begin, end) * this->Pairs.Vectors.leftCols(count);
      for (int b = 0; b < count; ++b)
      {
        sections[b].segment(begin, end - begin) = part.col(b);
      }
    });
  for (int b = 1; b < count; ++b)
  {
    const ComplexVector energy = Product(this->Matrices.Energy, sections[b]);
    ForRows(energy,
      [&](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          SetSectionValue(next.Vectors, v, b, sections[b][v]);
          SetSectionValue(next.Energy, v, b, energy[v]);
        }
      });
  }
  return SectionProducts(this->Matrices, std::move(sections[0]));
}

void RitzSpace::Forget()
{
  const auto kept = std::min<Eigen::Index>(KeptSections, this->Pairs.Vectors.cols());
  ParallelFor(static_cast<Index>(this->Basis.rows()), VectorPiece,
    [&](Index begin, Index end)
    {
      const Eigen::MatrixXcd part = this->Rows(begin, end) * this->Pairs.Vectors.leftCols(kept);
      this->Basis.block(begin, 0, end - begin, kept) = part;
    });
  this->Count = static_cast<int>(kept);
  this->Energy = SmallMatrix(this->Pairs.Values.head(kept).cast<Complex>().asDiagonal());
  this->Mass = SmallMatrix::Identity(kept, kept);
}
}
