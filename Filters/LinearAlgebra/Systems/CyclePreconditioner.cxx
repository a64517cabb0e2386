// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Systems/CyclePreconditioner.h"

#include "Matrices/VectorOperations.h"

#include <algorithm>

namespace DirectionFields::Internal
{
namespace
{
constexpr int Width = SectionBlock::Width;
/// V-cycles may lack this part of the inverse on the lowest sections before it is added.
constexpr double NegligibleLack = 0.1;
}

CyclePreconditioner::CyclePreconditioner(
  const Hierarchy& hierarchy, double shift, const LowestSections& lowest)
  : Cycles(hierarchy, std::max(0.0, shift))
  , Corrected(hierarchy.GetLevels().front().Rows())
{
  if (lowest.Values.size() == 0 || !(lowest.Values.minCoeff() + shift > 0.0))
  {
    return;
  }
  const Eigen::ArrayXd value = lowest.Values.array() + shift;
  const Eigen::ArrayXd lack =
    1.0 - value / (lowest.Values.array() + this->Cycles.GetCoarsestShift());
  if (lack.maxCoeff() > NegligibleLack)
  {
    this->Lowest = lowest.Vectors.data();
    this->PerValue = lack / value;
  }
}

CyclePreconditioner::Result CyclePreconditioner::Apply(const CompactVector& r)
{
  Result result;
  this->Cycles.Apply<1>(reinterpret_cast<const float*>(r.data()),
    reinterpret_cast<float*>(this->Corrected.data()), 0, &result.Product);
  result.Corrected = this->Corrected.data();
  result.Lowest = this->Lowest;
  if (!this->Lowest)
  {
    return result;
  }
  const WideSum products = ParallelSum<WideSum>(static_cast<Index>(r.size()), VectorPiece, {},
    [lowest = this->Lowest, from = r.data()](Index begin, Index end)
    {
      WideSum sum;
      for (Index v = begin; v < end; ++v)
      {
        sum.Add({ lowest, v }, Complex(from[v]));
      }
      return sum;
    });
  for (int b = 0; b < Width; ++b)
  {
    result.Real[b] = this->PerValue[b] * products.Value(b).real();
    result.Imaginary[b] = this->PerValue[b] * products.Value(b).imag();
    result.Product += this->PerValue[b] * std::norm(products.Value(b));
  }
  return result;
}
}
