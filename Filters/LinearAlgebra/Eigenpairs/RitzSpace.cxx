// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Eigenpairs/RitzSpace.h"

#include "Matrices/VectorOperations.h"

#include <algorithm>
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

/// v^* x of the given member v of each section.
Eigen::VectorXcd InnerProducts(const std::vector<SectionProducts>& sections,
  ComplexVector SectionProducts::*member, const ComplexVector& x)
{
  const auto count = static_cast<Eigen::Index>(sections.size());
  return ParallelSum<Eigen::VectorXcd>(static_cast<Index>(x.size()), VectorPiece,
    Eigen::VectorXcd::Zero(count),
    [&](Index begin, Index end)
    {
      Eigen::VectorXcd part(count);
      for (Eigen::Index k = 0; k < count; ++k)
      {
        part[k] =
          (sections[k].*member).segment(begin, end - begin).dot(x.segment(begin, end - begin));
      }
      return part;
    });
}

/// The linear combination of the given member of all sections, at the rows begin to end - 1.
ComplexVector LinearCombination(const std::vector<SectionProducts>& sections,
  ComplexVector SectionProducts::*member, const Eigen::VectorXcd& coefficients, Index begin,
  Index end)
{
  ComplexVector sum = ComplexVector::Zero(end - begin);
  for (std::size_t k = 0; k < sections.size(); ++k)
  {
    sum += coefficients[static_cast<Eigen::Index>(k)] *
      (sections[k].*member).segment(begin, end - begin);
  }
  return sum;
}

constexpr auto Members = { &SectionProducts::Vector, &SectionProducts::Energy,
  &SectionProducts::Mass };
}

RitzSpace::RitzSpace(const Operators& operators)
  : Matrices(operators)
{
}

void RitzSpace::Add(ComplexVector section)
{
  if (this->Size() == MostSections)
  {
    this->Forget();
  }
  const auto count = static_cast<Eigen::Index>(this->Basis.size());
  const double length = Norm(section);
  // Twice is enough (Kahan and Parlett).
  for (int pass = 0; pass < 2; ++pass)
  {
    const Eigen::VectorXcd along = InnerProducts(this->Basis, &SectionProducts::Mass, section);
    ForRows(section,
      [&](Index begin, Index end)
      {
        section.segment(begin, end - begin) -=
          LinearCombination(this->Basis, &SectionProducts::Vector, along, begin, end);
      });
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
      for (const auto member : Members)
      {
        (added.*member).segment(begin, end - begin) *= perLength;
      }
    });
  this->Basis.push_back(std::move(added));
  const SectionProducts& last = this->Basis.back();
  const auto extend = [&](SmallMatrix& matrix, const ComplexVector& products)
  {
    const Eigen::VectorXcd column = InnerProducts(this->Basis, &SectionProducts::Vector, products);
    matrix.conservativeResize(count + 1, count + 1);
    matrix.col(count) = column;
    matrix.row(count) = column.adjoint();
  };
  extend(this->Energy, last.Energy);
  extend(this->Mass, last.Mass);
  this->Pairs = RayleighRitz(this->Energy, this->Mass, this->Size());
}

SectionProducts RitzSpace::First() const
{
  SectionProducts first;
  for (const auto member : Members)
  {
    (first.*member).resize(this->Basis.front().Vector.size());
  }
  ForRows(first.Vector,
    [&](Index begin, Index end)
    {
      for (const auto member : Members)
      {
        (first.*member).segment(begin, end - begin) =
          LinearCombination(this->Basis, member, this->Pairs.Vectors.col(0), begin, end);
      }
    });
  return first;
}

void RitzSpace::WriteNext(SectionBlock& block) const
{
  const int count = std::min<int>(Width, static_cast<int>(this->Pairs.Values.size()));
  ParallelFor(block.Rows(), VectorPiece,
    [&](Index begin, Index end)
    {
      for (int b = 1; b < count; ++b)
      {
        const auto write = [&](ComplexVector SectionProducts::*member, CompactSections& to)
        {
          const ComplexVector part =
            LinearCombination(this->Basis, member, this->Pairs.Vectors.col(b), begin, end);
          for (Index v = begin; v < end; ++v)
          {
            SetSectionValue(to, v, b, part[v - begin]);
          }
        };
        write(&SectionProducts::Vector, block.Vectors);
        write(&SectionProducts::Energy, block.Energy);
      }
    });
}

void RitzSpace::Forget()
{
  const SmallMatrix kept =
    this->Pairs.Vectors.leftCols(std::min<Eigen::Index>(KeptSections, this->Pairs.Vectors.cols()));
  const auto rows = static_cast<Index>(this->Basis.front().Vector.size());
  ParallelFor(rows, VectorPiece,
    [&](Index begin, Index end)
    {
      for (const auto member : Members)
      {
        Eigen::MatrixXcd old(end - begin, this->Size());
        for (int k = 0; k < this->Size(); ++k)
        {
          old.col(k) = (this->Basis[k].*member).segment(begin, end - begin);
        }
        for (Eigen::Index k = 0; k < kept.cols(); ++k)
        {
          (this->Basis[k].*member).segment(begin, end - begin).noalias() = old * kept.col(k);
        }
      }
    });
  this->Basis.resize(kept.cols());
  this->Energy = SmallMatrix(this->Pairs.Values.head(kept.cols()).cast<Complex>().asDiagonal());
  this->Mass = SmallMatrix::Identity(kept.cols(), kept.cols());
}
}
