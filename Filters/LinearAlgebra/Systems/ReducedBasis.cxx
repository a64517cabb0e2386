// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Systems/ReducedBasis.h"

#include "Matrices/VectorOperations.h"

#include <Eigen/Eigenvalues>

#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Combinations of unit vectors whose squared norm is less than this part of the largest are
/// rounding.
constexpr double Independent = 1e-12;

/// v^* x for each of the vectors v and each of the others, a column for each x.
Eigen::MatrixXcd Products(
  const std::vector<ComplexVector>& vectors, const std::vector<const ComplexVector*>& others)
{
  const auto rows = static_cast<Eigen::Index>(vectors.size());
  const auto columns = static_cast<Eigen::Index>(others.size());
  return ParallelSum<Eigen::MatrixXcd>(static_cast<Index>(others.front()->size()), VectorPiece,
    Eigen::MatrixXcd::Zero(rows, columns),
    [&](Index begin, Index end)
    {
      Eigen::MatrixXcd part(rows, columns);
      for (Eigen::Index i = 0; i < rows; ++i)
      {
        for (Eigen::Index k = 0; k < columns; ++k)
        {
          part(i, k) =
            vectors[i].segment(begin, end - begin).dot(others[k]->segment(begin, end - begin));
        }
      }
      return part;
    });
}

/// v^* x, the same to the last bit as among others.
Complex Product(const ComplexVector& v, const ComplexVector& x)
{
  return ParallelSum<Complex>(static_cast<Index>(v.size()), VectorPiece, 0.0,
    [&](Index begin, Index end)
    { return v.segment(begin, end - begin).dot(x.segment(begin, end - begin)); });
}

/// Another row and column of a Hermitian matrix; the oldest ones are left out.
void Extend(Eigen::MatrixXcd& matrix, const Eigen::VectorXcd& column, bool forget)
{
  const Eigen::Index old = matrix.rows() - (forget ? 1 : 0);
  Eigen::MatrixXcd extended(old + 1, old + 1);
  extended.topLeftCorner(old, old) = matrix.bottomRightCorner(old, old);
  extended.col(old) = column;
  extended.row(old) = column.adjoint();
  extended(old, old) = column[old].real();
  matrix = std::move(extended);
}
}

ReducedBasis::Guess ReducedBasis::Closest(double a, double m, const ComplexVector& b) const
{
  const auto zero = [&] { return Guess{ ComplexVector::Zero(b.size()) }; };
  if (this->Vectors.empty())
  {
    return zero();
  }
  const Eigen::VectorXcd products = Products(this->Vectors, { &b });
  for (std::size_t k = 0; k < this->Systems.size(); ++k)
  {
    const std::optional<System>& system = this->Systems[k];
    if (system && system->Energy == a && system->Mass == m &&
      system->Product == products[static_cast<Eigen::Index>(k)])
    {
      return { this->Vectors[k], true, system->Residual };
    }
  }
  const Eigen::MatrixXcd matrix = a * this->Energy + m * this->Mass;
  const Eigen::VectorXd perLength = matrix.diagonal().real().cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> spectrum(
    perLength.asDiagonal() * matrix * perLength.asDiagonal());
  if (!perLength.allFinite() || spectrum.info() != Eigen::Success)
  {
    return zero();
  }
  const Eigen::VectorXd& values = spectrum.eigenvalues();
  const Eigen::VectorXd inverse =
    (values.array() > Independent * values[values.size() - 1]).select(values.cwiseInverse(), 0.0);
  const Eigen::VectorXcd coefficients = perLength.asDiagonal() *
    (spectrum.eigenvectors() *
      (inverse.asDiagonal() *
        (spectrum.eigenvectors().adjoint() * (perLength.asDiagonal() * products))));
  Guess guess{ Uninitialized(b.size()) };
  ComplexVector& sum = guess.Vector;
  ForRows(sum,
    [&](Index begin, Index end)
    {
      auto part = sum.segment(begin, end - begin);
      part = coefficients[0] * this->Vectors[0].segment(begin, end - begin);
      for (std::size_t k = 1; k < this->Vectors.size(); ++k)
      {
        part +=
          coefficients[static_cast<Eigen::Index>(k)] * this->Vectors[k].segment(begin, end - begin);
      }
    });
  return guess;
}

void ReducedBasis::Add(
  const SectionProducts& u, double a, double m, const ComplexVector& b, double residual)
{
  this->Add(u);
  this->Systems.back() = { a, m, Product(u.Vector, b), residual };
}

void ReducedBasis::Add(const SectionProducts& u)
{
  const bool forget = this->Size() == MostVectors;
  if (forget)
  {
    this->Vectors.erase(this->Vectors.begin());
    this->Systems.erase(this->Systems.begin());
  }
  this->Vectors.push_back(Copied(u.Vector));
  const Eigen::MatrixXcd products = Products(this->Vectors, { &u.Energy, &u.Mass });
  this->Systems.emplace_back();
  Extend(this->Energy, products.col(0), forget);
  Extend(this->Mass, products.col(1), forget);
}
}
