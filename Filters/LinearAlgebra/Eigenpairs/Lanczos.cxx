// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Eigenpairs/Lanczos.h"

#include "Eigenpairs/HermitianSpectrum.h"
#include "Matrices/OperatorProducts.h"
#include "SparseCholesky/SupernodalCholesky.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Up to this dimension the dense solver is as fast and more robust.
constexpr Eigen::Index DenseRows = 48;
/// Dimension of the Krylov space at which it is restarted, and of the part that is kept.
constexpr int KrylovDimension = 24;
constexpr int KeptDimension = 8;
/// The iteration takes at least this many solves, even if the residual is small before.
constexpr int FewestSolves = 6;
/// Nor does it end while a step lets the smallest eigenvalue fall by more than this part of the
/// tolerance, or of the loosest one that still tells it from the next: residuals of sections whose
/// eigenvalues are next to nothing are small at once.
constexpr double MostRise = 0.1;
constexpr double LoosestTolerance = 1e-3;
/// A residual up to this is not reached before the smallest pair has come out, unless the shift
/// hides it.
constexpr double TellingResidual = 1e-5;
/// By how much less the residual has to be where that of another pair has passed for the smallest
/// one's.
constexpr double Tightening = 0.1;
/// The rounding errors of a factorization, relative to u^* diag(A) u.
constexpr double Rounding = 1e-14;

Eigenpair DenseEigenpair(
  const SparseMatrix& energy, const SparseMatrix& mass, const ComplexVector& start)
{
  const HermitianSpectrum spectrum{ Eigen::MatrixXcd(energy), Eigen::MatrixXcd(mass) };
  if (!spectrum.IsFound)
  {
    throw std::runtime_error("The eigenvalue problem of a small component has no solution.");
  }
  const Eigen::VectorXd& values = spectrum.Values;
  const double bound = values[0] + 1e-9 * values.cwiseAbs().maxCoeff();
  const Eigen::Index multiplicity = (values.array() <= bound).count();
  const auto space = spectrum.Vectors.leftCols(multiplicity);
  const ComplexVector coefficients = space.adjoint() * (mass * start);
  Eigenpair pair;
  pair.Vector = coefficients.norm() > 1e-9 * start.norm() ? ComplexVector(space * coefficients)
                                                          : ComplexVector(space.col(0));
  return pair;
}

/// Orthonormal basis V of a Krylov space of (A + shift M)^-1 M and that operator's matrix on it.
class KrylovSpace
{
public:
  KrylovSpace(const ComplexCholesky& factor, const SparseMatrix& mass, const ComplexVector& start)
    : Factor(factor)
    , Mass(mass)
    , Basis(mass.rows(), KrylovDimension + 1)
    , MassBasis(mass.rows(), KrylovDimension + 1)
    , Projected(Eigen::MatrixXcd::Zero(KrylovDimension + 1, KrylovDimension))
  {
    const ComplexVector massStart = mass * start;
    const double norm = std::sqrt(start.dot(massStart).real());
    this->Basis.col(0) = start / norm;
    this->MassBasis.col(0) = massStart / norm;
  }

  void Expand()
  {
    if (this->Dimension == KrylovDimension)
    {
      this->Restart();
    }
    const int j = this->Dimension;
    ComplexVector w = this->Factor.Solve(this->MassBasis.col(j));
    this->Projected.col(j).setZero();
    this->Projected.col(j).head(j + 1) = this->Orthogonalize(w, j + 1);
    ComplexVector massW = Product(this->Mass, w);
    double norm = std::sqrt(std::max(0.0, w.dot(massW).real()));
    // The part of w that was in the space is as long as its coefficients.
    if (norm <= 1e-14 * std::hypot(norm, this->Projected.col(j).norm()))
    {
      // The space is invariant: the remainder of w is rounding. The iteration continues in any
      // other direction.
      norm = 0.0;
      for (Eigen::Index k = 0; k < w.size(); ++k)
      {
        w[k] = std::polar(1.0, 2.4 * static_cast<double>(k) * static_cast<double>(j + 1));
      }
      this->Orthogonalize(w, j + 1);
      massW = Product(this->Mass, w);
      const double other = std::sqrt(w.dot(massW).real());
      w /= other;
      massW /= other;
    }
    else
    {
      w /= norm;
      massW /= norm;
    }
    this->Projected(j + 1, j) = norm;
    this->Basis.col(j + 1) = w;
    this->MassBasis.col(j + 1) = massW;
    ++this->Dimension;
    this->Diagonalize();
  }

  /// The part by which the last step has raised the largest Ritz value: 1 over the value of A +
  /// shift M for its smallest eigenvalue, so far.
  double Rise() const { return (this->Largest - this->LargestBefore) / this->Largest; }

  /// The operator applied to the Ritz vector of its largest eigenvalue: one step better than the
  /// vector itself, and free.
  ComplexVector Best() const
  {
    const int m = this->Dimension;
    return this->Basis.leftCols(m + 1) *
      (this->Projected.topLeftCorner(m + 1, m) * this->Ritz->Vectors.col(m - 1));
  }

private:
  Eigen::VectorXcd Orthogonalize(ComplexVector& w, int columns) const
  {
    // Twice is enough (Kahan and Parlett).
    Eigen::VectorXcd coefficients = this->MassBasis.leftCols(columns).adjoint() * w;
    w.noalias() -= this->Basis.leftCols(columns) * coefficients;
    const Eigen::VectorXcd correction = this->MassBasis.leftCols(columns).adjoint() * w;
    w.noalias() -= this->Basis.leftCols(columns) * correction;
    return coefficients + correction;
  }

  void Diagonalize()
  {
    const int m = this->Dimension;
    const Eigen::MatrixXcd square = this->Projected.topLeftCorner(m, m);
    this->Ritz.emplace(0.5 * (square + square.adjoint()));
    this->LargestBefore = this->Largest;
    this->Largest = this->Ritz->Values[m - 1];
  }

  void Restart()
  {
    const int m = this->Dimension;
    const int kept = KeptDimension;
    const Eigen::MatrixXcd vectors = this->Ritz->Vectors.rightCols(kept);
    const Eigen::RowVectorXcd last = this->Projected.row(m).head(m) * vectors;
    this->Basis.leftCols(kept) = (this->Basis.leftCols(m) * vectors).eval();
    this->MassBasis.leftCols(kept) = (this->MassBasis.leftCols(m) * vectors).eval();
    this->Basis.col(kept) = this->Basis.col(m).eval();
    this->MassBasis.col(kept) = this->MassBasis.col(m).eval();
    this->Projected.setZero();
    this->Projected.diagonal().head(kept) = this->Ritz->Values.tail(kept).cast<Complex>();
    this->Projected.row(kept).head(kept) = last;
    this->Dimension = kept;
  }

  const ComplexCholesky& Factor;
  const SparseMatrix& Mass;
  Eigen::MatrixXcd Basis;
  Eigen::MatrixXcd MassBasis;
  Eigen::MatrixXcd Projected;
  int Dimension = 0;
  double Largest = 0.0;
  double LargestBefore = 0.0;
  std::optional<HermitianSpectrum> Ritz;
};

/// Scales the vector to u^* M u = 1 and fills in the other figures.
void Measure(const SparseMatrix& energy, const SparseMatrix& mass, Eigenpair& pair)
{
  SectionProducts u;
  u.Vector = std::move(pair.Vector);
  u.Energy = Product(energy, u.Vector);
  u.Mass = Product(mass, u.Vector);
  const double perLength = 1.0 / std::sqrt(u.Vector.dot(u.Mass).real());
  for (ComplexVector* vector : { &u.Vector, &u.Energy, &u.Mass })
  {
    *vector *= perLength;
  }
  // A is positive semi-definite: values below zero are rounding.
  pair.Value = std::max(0.0, u.Vector.dot(u.Energy).real());
  pair.Residual = RelativeResidual(energy, u, pair.Value);
  pair.Vector = std::move(u.Vector);
}

/// Factors A plus the smallest multiple of M that makes it definite, at least NextToNothing, which
/// is returned. Throws std::runtime_error, and Stopped.
double FactorShifted(const SparseMatrix& energy, const SparseMatrix& mass,
  const EigenpairSettings& settings, const Progress& progress, ComplexCholesky& factor)
{
  double shift = settings.NextToNothing();
  while (!factor.Compute(energy + shift * mass, progress))
  {
    shift *= 100.0;
    if (shift > 1e3 * settings.Scale)
    {
      throw std::runtime_error("The energy matrix could not be factored: the mesh has triangles "
                               "of too different sizes or shapes. Remesh it more evenly.");
    }
  }
  return shift;
}

/// Whether no eigenvalue is below that of the pair by more than the settings let it. By Sylvester's
/// law of inertia A - x M is positive definite if and only if x is below all of them.
/// @param shift with which A could be factored
bool IsSmallest(const SparseMatrix& energy, const SparseMatrix& mass, const Eigenpair& pair,
  const EigenpairSettings& settings, double shift, const Progress& progress)
{
  // Where a larger shift than wanted was necessary, rounding hides eigenvalues of that size.
  const double hidden = shift - settings.NextToNothing() +
    Rounding * (energy.diagonal().real().array() * pair.Vector.array().abs2()).sum();
  const double below =
    pair.Value - settings.Tolerance * (pair.Value + settings.NextToNothing()) - hidden;
  // A has no eigenvalue below zero.
  return below <= 0.0 || ComplexCholesky().Compute(energy - below * mass, progress);
}

/// Expands a Krylov space until its best pair has converged.
Eigenpair Iterate(const SparseMatrix& energy, const SparseMatrix& mass, const ComplexVector& start,
  const EigenpairSettings& settings, const Progress& progress)
{
  ComplexCholesky factor;
  const double shift = FactorShifted(energy, mass, settings, progress, factor);
  KrylovSpace space(factor, mass, start);
  Eigenpair best;
  best.Residual = std::numeric_limits<double>::infinity();
  Eigenpair candidate;
  double required = settings.Tolerance;
  // A space of all dimensions does not grow.
  const int mostSolves = energy.rows() > KrylovDimension
    ? settings.MaximumIterations
    : std::min(settings.MaximumIterations, static_cast<int>(energy.rows()));
  for (int solves = 1; solves <= mostSolves; ++solves)
  {
    progress.Report(FractionDone(solves));
    space.Expand();
    // The start can hide the smallest pair behind the next one for some steps, and where lambda = 0
    // on very thin triangles a small residual comes before a good vector.
    const bool mayEnd =
      solves >= FewestSolves && space.Rise() <= MostRise * std::min(required, LoosestTolerance);
    if (!mayEnd && solves < mostSolves)
    {
      continue;
    }
    candidate.Vector = space.Best();
    candidate.Iterations = solves;
    Measure(energy, mass, candidate);
    if (candidate.Residual < best.Residual)
    {
      best = candidate;
    }
    if (best.Residual <= required)
    {
      const bool tells = required <= TellingResidual && required == settings.Tolerance &&
        best.Value >= settings.NextToNothing();
      if (tells || IsSmallest(energy, mass, best, settings, shift, progress))
      {
        break;
      }
      required = Tightening * std::min(required, best.Residual);
      if (solves < mostSolves)
      {
        best.Residual = std::numeric_limits<double>::infinity();
      }
    }
  }
  best.RequiredResidual = required;
  best.Iterations = candidate.Iterations;
  return best;
}
}

Eigenpair SolveByLanczos(const SparseMatrix& energy, const SparseMatrix& mass,
  const ComplexVector& start, const EigenpairSettings& settings, const Progress& progress)
{
  progress.Report(FractionDone(0));
  if (energy.rows() <= DenseRows)
  {
    Eigenpair pair = DenseEigenpair(energy, mass, start);
    Measure(energy, mass, pair);
    pair.RequiredResidual = settings.Tolerance;
    if (pair.Residual <= settings.Tolerance || energy.rows() < 3)
    {
      return pair;
    }
    // The dense solver is accurate to the largest eigenvalue, which may be too far from the
    // smallest.
  }
  return Iterate(energy, mass, start, settings, progress);
}
}
