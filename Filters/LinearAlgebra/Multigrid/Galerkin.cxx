// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Multigrid/Galerkin.h"

#include "Matrices/RowSum.h"

#include <array>

namespace DirectionFields::Internal
{
namespace
{
/// An entry of the energy and one of the mass, whose real and imaginary parts fit a register
/// together.
struct TwoEntries
{
  using Numbers = Eigen::Array4f;

  std::array<float, 4> Parts{};

  CompactComplex Energy() const { return { this->Parts[0], this->Parts[1] }; }
  CompactComplex Mass() const { return { this->Parts[2], this->Parts[3] }; }
  void Add(const Numbers& numbers)
  {
    Eigen::Map<Numbers> own(this->Parts.data());
    own += numbers;
  }
  TwoEntries& operator+=(const TwoEntries& other)
  {
    this->Add(Eigen::Map<const Numbers>(other.Parts.data()));
    return *this;
  }
};

/// Multiplies an entry of the energy and one of the mass by the same number.
class TwoFactors
{
public:
  TwoFactors(const CompactComplex& energy, const CompactComplex& mass)
    : Both(energy.real(), energy.imag(), mass.real(), mass.imag())
    , Turned(-energy.imag(), energy.real(), -mass.imag(), mass.real())
  {
  }
  TwoEntries::Numbers Times(const CompactComplex& other) const
  {
    return this->Both * other.real() + this->Turned * other.imag();
  }

private:
  TwoEntries::Numbers Both;
  /// Both numbers times i.
  TwoEntries::Numbers Turned;
};

/// The matrices of these rows, which are sorted and have their diagonal entries.
LevelMatrices ToLevelMatrices(const SummedRows<TwoEntries>& rows)
{
  const Index n = static_cast<Index>(rows.Size.size());
  const LargeArray<Index> rowBegin = rows.Begin();
  LevelMatrices coarse;
  coarse.Energy.Begin.resize(n + 1);
  coarse.Energy.Diagonal.resize(n);
  coarse.MassDiagonal.resize(n);
  coarse.Energy.Begin[n] = rowBegin[n] - n;
  ResizePadded(coarse.Energy.Column, rowBegin[n] - n);
  ResizePadded(coarse.Energy.Value, rowBegin[n] - n);
  coarse.MassValue.resize(rowBegin[n] - n);
  rows.ForEach(
    [&](Index row, Index k, const std::pair<Index, TwoEntries>& entry)
    {
      const Index start = rowBegin[row] - row;
      if (k == 0)
      {
        coarse.Energy.Begin[row] = start;
      }
      if (entry.first == row)
      {
        coarse.Energy.Diagonal[row] = entry.second.Energy().real();
        coarse.MassDiagonal[row] = entry.second.Mass().real();
        return;
      }
      const Index at = start + k - (entry.first > row ? 1 : 0);
      coarse.Energy.Column[at] = entry.first;
      coarse.Energy.Value[at] = entry.second.Energy();
      coarse.MassValue[at] = entry.second.Mass();
    });
  coarse.Energy.OrderByBlocks(&coarse.MassValue);
  return coarse;
}
}

LevelMatrices Coarsen(const LevelMatrices& matrices, const Prolongator& prolongator)
{
  const CompactMatrix& energy = matrices.Energy;
  // A P and M P. Their rows need no order, and columns may come several times.
  const SummedRows<TwoEntries> products(energy.Rows(), false,
    [&](Index i, RowSum<TwoEntries>& sum)
    {
      const auto add = [&](Index j, const CompactComplex& a, const CompactComplex& m)
      {
        const TwoFactors factors(a, m);
        for (Index k = prolongator.Begin[j]; k < prolongator.Begin[j + 1]; ++k)
        {
          sum[prolongator.Column[k]].Add(factors.Times(prolongator.Value[k]));
        }
      };
      add(i, energy.Diagonal[i], matrices.MassDiagonal[i]);
      for (Index k = energy.Begin[i]; k < energy.Begin[i + 1]; ++k)
      {
        add(energy.Column[k], energy.Value[k], matrices.MassValue[k]);
      }
    });
  const LargeArray<Index> begin = products.Begin();
  const SummedRows<TwoEntries> rows(prolongator.CoarseRows(), true,
    [&](Index row, RowSum<TwoEntries>& sum)
    {
      for (Index k = prolongator.AdjointBegin[row]; k < prolongator.AdjointBegin[row + 1]; ++k)
      {
        const Index i = prolongator.AdjointColumn[k];
        const Index piece = i / products.PieceRows;
        const auto* entry =
          products.Pieces[piece].data() + (begin[i] - begin[piece * products.PieceRows]);
        for (Index e = 0; e < products.Size[i]; ++e, ++entry)
        {
          const TwoFactors factors(entry->second.Energy(), entry->second.Mass());
          sum[entry->first].Add(factors.Times(prolongator.AdjointValue[k]));
        }
      }
    });
  return ToLevelMatrices(rows);
}
}
