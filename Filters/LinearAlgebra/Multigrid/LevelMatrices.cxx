// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Multigrid/LevelMatrices.h"

#include "Matrices/SparseColumns.h"
#include "Multigrid/SectionBlock.h"
#include "Support/Threads.h"

namespace DirectionFields::Internal
{
template <int B>
void LevelMatrices::Multiply(const float* x, float* ax, float* mx) const
{
  const CompactMatrix& energy = this->Energy;
  ParallelFor(energy.Rows(), CompactMatrix::PieceRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        CompactValues<B> a;
        CompactValues<B> m;
        a.AddReal(energy.Diagonal[v], x, v);
        m.AddReal(this->MassDiagonal[v], x, v);
        for (Index k = energy.Begin[v]; k < energy.Begin[v + 1]; ++k)
        {
          a.Add(energy.Value[k], x, energy.Column[k]);
          m.Add(this->MassValue[k], x, energy.Column[k]);
        }
        a.Store(ax, v);
        m.Store(mx, v);
      }
    });
}

template void LevelMatrices::Multiply<4>(const float*, float*, float*) const;

void Multiply(const Operators& operators, const float* x, float* ax, float* mx)
{
  constexpr int width = SectionBlock::Width;
  ForEachRow(operators.Energy.cols(),
    [energy = SparseColumns(operators.Energy), mass = operators.Mass.valuePtr(), x, ax, mx](Index v)
    {
      Eigen::Array4d real = Eigen::Array4d::Zero();
      Eigen::Array4d imaginary = Eigen::Array4d::Zero();
      // In M x no digits cancel: single precision will do.
      CompactValues<width> m;
      for (Index k = energy.Begin[v]; k < energy.Begin[v + 1]; ++k)
      {
        const Complex value = energy.Value[k];
        const CompactValues<width> from(x, energy.Row[k]);
        const Eigen::Array4d re = from.Real.cast<double>();
        const Eigen::Array4d im = from.Imaginary.cast<double>();
        real += value.real() * re + value.imag() * im;
        imaginary += value.real() * im - value.imag() * re;
        m.Add(CompactComplex(std::conj(mass[k])), from);
      }
      CompactValues<width> a;
      a.Real = real.cast<float>();
      a.Imaginary = imaginary.cast<float>();
      a.Store(ax, v);
      m.Store(mx, v);
    });
}
}
