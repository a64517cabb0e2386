// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Multigrid/SectionBlock.h"

#include "Support/Free.h"
#include "Support/Threads.h"

#include <algorithm>
#include <array>

namespace DirectionFields::Internal
{
namespace
{
constexpr int Width = SectionBlock::Width;
/// The products of this many rows are added up in single precision, their sums in double precision.
constexpr Index FewRows = 256;

using Values = CompactValues<Width>;

/// sum(i, j) += conj(a_i) b_j over the rows.
void AddProducts(const float* a, const float* b, Index begin, Index end, SmallMatrix& sum)
{
  for (Index first = begin; first < end; first += FewRows)
  {
    std::array<Values, Width> few;
    const Index last = std::min(end, first + FewRows);
    for (Index v = first; v < last; ++v)
    {
      const Values x(a, v);
      const Values y(b, v);
      for (int i = 0; i < Width; ++i)
      {
        few[i].Add(CompactComplex(x.Real[i], -x.Imaginary[i]), y);
      }
    }
    for (int i = 0; i < Width; ++i)
    {
      for (int j = 0; j < Width; ++j)
      {
        sum(i, j) += Complex(few[i].Real[j], few[i].Imaginary[j]);
      }
    }
  }
}
}

SectionBlock::SectionBlock(Index rows)
  : Vectors(static_cast<std::size_t>(2 * Width) * rows)
  , Energy(this->Vectors.size())
  , Mass(this->Vectors.size())
{
}

std::vector<SmallMatrix> InnerProducts(
  Index rows, const std::vector<std::pair<const CompactSections*, const CompactSections*>>& pairs)
{
  const auto count = static_cast<Eigen::Index>(pairs.size());
  const SmallMatrix all = ParallelSum<SmallMatrix>(rows, CompactMatrix::PieceRows,
    SmallMatrix::Zero(Width, Width * count),
    [&](Index begin, Index end) -> SmallMatrix
    {
      SmallMatrix part(Width, Width * count);
      for (Eigen::Index p = 0; p < count; ++p)
      {
        SmallMatrix sum = SmallMatrix::Zero(Width, Width);
        AddProducts(pairs[p].first->data(), pairs[p].second->data(), begin, end, sum);
        part.middleCols(Width * p, Width) = sum;
      }
      return part;
    });
  std::vector<SmallMatrix> products;
  for (Eigen::Index p = 0; p < count; ++p)
  {
    products.emplace_back(all.middleCols(Width * p, Width));
  }
  return products;
}

void SetLinearCombination(const std::vector<std::pair<const SectionBlock*, SmallMatrix>>& terms,
  SectionBlock& target, bool withMass)
{
  struct Factor
  {
    const SectionBlock* Block;
    std::array<Values, Width> Rows;
  };
  std::vector<Factor> factors;
  for (const auto& [block, matrix] : terms)
  {
    Factor factor{ block, {} };
    for (int i = 0; i < Width; ++i)
    {
      factor.Rows[i].Real = matrix.row(i).real().transpose().cast<float>();
      factor.Rows[i].Imaginary = matrix.row(i).imag().transpose().cast<float>();
    }
    factors.push_back(factor);
  }
  std::vector<CompactSections SectionBlock::*> members{ &SectionBlock::Vectors,
    &SectionBlock::Energy };
  if (withMass)
  {
    members.push_back(&SectionBlock::Mass);
  }
  else
  {
    Free(target.Mass);
  }
  ParallelFor(target.Rows(), CompactMatrix::PieceRows,
    [&](Index begin, Index end)
    {
      for (const auto member : members)
      {
        for (Index v = begin; v < end; ++v)
        {
          Values sum;
          for (const Factor& factor : factors)
          {
            const Values x((factor.Block->*member).data(), v);
            for (int i = 0; i < Width; ++i)
            {
              sum.Add(CompactComplex(x.Real[i], x.Imaginary[i]), factor.Rows[i]);
            }
          }
          sum.Store((target.*member).data(), v);
        }
      }
    });
}
}
