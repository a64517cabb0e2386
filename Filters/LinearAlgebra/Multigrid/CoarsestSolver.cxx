// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Multigrid/CoarsestSolver.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace DirectionFields::Internal
{
namespace
{
/// The part of an error that pairs of sweeps may leave: the levels above correct the rest.
constexpr double WantedPart = 0.3;
/// Pairs of sweeps after which the reduction of the error by one more is near the worst.
constexpr int PairsToContract = 8;

double Norm(const CompactSections& x)
{
  return std::sqrt(std::inner_product(x.begin(), x.end(), x.begin(), 0.0));
}
}

CoarsestSolver::CoarsestSolver(
  const LevelMatrices& matrices, const LargeArray<float>& lumpedMass, double shift)
  : Matrices(matrices)
{
  if (matrices.Energy.Rows() <= MostDenseRows)
  {
    this->Factor(shift);
    return;
  }
  this->Diagonal = SweepDiagonal(matrices.Energy, lumpedMass, static_cast<float>(shift));
  this->Contract();
  // Where the errors do not get smaller that is rounding, or the matrix is nearly singular: pairs
  // of sweeps are positive definite all the same.
  this->Usable = std::isfinite(this->Contraction) && this->Contraction < 1.01;
  const double least = std::numeric_limits<double>::min();
  this->Pairs = this->Contraction < 1.0
    ? static_cast<int>(
        std::clamp(std::ceil(std::log(WantedPart) / std::log(std::max(this->Contraction, least))),
          1.0, static_cast<double>(MostPairs)))
    : MostPairs;
}

void CoarsestSolver::Factor(double shift)
{
  const CompactMatrix& energy = this->Matrices.Energy;
  const Index n = energy.Rows();
  Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Zero(n, n);
  for (Index i = 0; i < n; ++i)
  {
    matrix(i, i) = energy.Diagonal[i] + shift * this->Matrices.MassDiagonal[i];
    for (Index k = energy.Begin[i]; k < energy.Begin[i + 1]; ++k)
    {
      matrix(i, energy.Column[k]) =
        Complex(energy.Value[k]) + shift * Complex(this->Matrices.MassValue[k]);
    }
  }
  const Eigen::LLT<Eigen::MatrixXcd> factor(matrix);
  this->Usable = factor.info() == Eigen::Success && factor.matrixLLT().allFinite();
  this->DenseFactor = factor.matrixLLT();
}

void CoarsestSolver::Contract()
{
  const CompactMatrix& energy = this->Matrices.Energy;
  const auto n = static_cast<std::size_t>(energy.Rows());
  const CompactSections zero(2 * n, 0.0f);
  CompactSections error(2 * n);
  for (std::size_t v = 0; v < n; ++v)
  {
    error[2 * v] = static_cast<float>(std::cos(2.4 * static_cast<double>(v)));
    error[2 * v + 1] = static_cast<float>(std::sin(2.4 * static_cast<double>(v)));
  }
  double before = 1.0;
  for (int pair = 0; pair < PairsToContract; ++pair)
  {
    before = Norm(error);
    Sweep<1>(energy, this->Diagonal, SweepOrder::Down, zero.data(), error.data());
    Sweep<1>(energy, this->Diagonal, SweepOrder::Up, zero.data(), error.data());
  }
  this->Contraction = before > 0.0 ? Norm(error) / before : 0.0;
}

template <int B>
void CoarsestSolver::Solve(const float* b, float* y, double* product) const
{
  if (this->Pairs == 0)
  {
    this->SolveByFactor<B>(b, y, product);
    return;
  }
  const CompactMatrix& energy = this->Matrices.Energy;
  SweepFromZero<B>(energy, this->Diagonal, b, y);
  for (int pair = 1; pair < this->Pairs; ++pair)
  {
    Sweep<B>(energy, this->Diagonal, SweepOrder::Up, b, y);
    Sweep<B>(energy, this->Diagonal, SweepOrder::Down, b, y);
  }
  Sweep<B>(energy, this->Diagonal, SweepOrder::Up, b, y, nullptr, product);
}

template <int B>
void CoarsestSolver::SolveByFactor(const float* b, float* y, double* product) const
{
  const auto n = static_cast<Index>(this->DenseFactor.rows());
  Eigen::Matrix<Complex, Eigen::Dynamic, B> solution(n, B);
  for (Index v = 0; v < n; ++v)
  {
    for (int k = 0; k < B; ++k)
    {
      solution(v, k) = Complex(b[2 * B * v + k], b[2 * B * v + B + k]);
    }
  }
  const auto lower = this->DenseFactor.triangularView<Eigen::Lower>();
  lower.solveInPlace(solution);
  lower.adjoint().solveInPlace(solution);
  for (Index v = 0; v < n; ++v)
  {
    for (int k = 0; k < B; ++k)
    {
      y[2 * B * v + k] = static_cast<float>(solution(v, k).real());
      y[2 * B * v + B + k] = static_cast<float>(solution(v, k).imag());
    }
  }
  if (product)
  {
    *product = std::inner_product(b, b + 2 * B * n, y, 0.0);
  }
}

template void CoarsestSolver::Solve<1>(const float*, float*, double*) const;
template void CoarsestSolver::Solve<4>(const float*, float*, double*) const;
}
