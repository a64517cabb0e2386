// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SparseCholesky/Factorization.h"

#include "Support/Watch.h"

#include <Eigen/SparseCholesky>
#ifdef DIRECTIONFIELDS_HAVE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

namespace DirectionFields::Internal
{
namespace
{
/// Matrices with fewer rows are factored before anybody would ask.
constexpr Eigen::Index WatchedRows = 5000;
}

class Factorization::Backend
{
public:
  virtual ~Backend() = default;
  virtual bool Compute(const SparseMatrix& matrix) = 0;
  virtual ComplexVector Solve(const ComplexVector& rightHandSide) const = 0;
};

class Factorization::EigenBackend : public Factorization::Backend
{
public:
  bool Compute(const SparseMatrix& matrix) override
  {
    this->Solver.compute(matrix);
    return this->Solver.info() == Eigen::Success &&
      (this->Solver.vectorD().real().array() > 0.0).all();
  }
  ComplexVector Solve(const ComplexVector& rightHandSide) const override
  {
    return this->Solver.solve(rightHandSide);
  }

private:
  Eigen::SimplicialLDLT<SparseMatrix> Solver;
};

#ifdef DIRECTIONFIELDS_HAVE_CHOLMOD
namespace
{
/// Rows from which the supernodal factorization is the faster one.
constexpr Eigen::Index CholmodRows = 50000;
}

class Factorization::CholmodBackend : public Factorization::Backend
{
public:
  CholmodBackend()
  {
    // A failure is reported by Compute; nothing is printed.
    this->Solver.cholmod().print = 0;
  }
  bool Compute(const SparseMatrix& matrix) override
  {
    this->Solver.compute(matrix);
    return this->Solver.info() == Eigen::Success;
  }
  ComplexVector Solve(const ComplexVector& rightHandSide) const override
  {
    return this->Solver.solve(rightHandSide);
  }

private:
  mutable Eigen::CholmodSupernodalLLT<SparseMatrix> Solver;
};
#endif

Factorization::Factorization() = default;
Factorization::~Factorization() = default;

bool Factorization::Compute(const SparseMatrix& matrix, const Progress& progress)
{
#ifdef DIRECTIONFIELDS_HAVE_CHOLMOD
  if (IsSupernodal(matrix.rows()))
  {
    this->Factor = std::make_shared<CholmodBackend>();
    if (Watched(this->Factor, matrix, progress))
    {
      return true;
    }
  }
#endif
  this->Factor = std::make_shared<EigenBackend>();
  return Watched(this->Factor, matrix, progress);
}

bool Factorization::IsSupernodal([[maybe_unused]] Eigen::Index rows)
{
#ifdef DIRECTIONFIELDS_HAVE_CHOLMOD
  return rows >= CholmodRows;
#else
  return false;
#endif
}

/// Does backend->Compute(matrix) and asks meanwhile whether to go on.
bool Factorization::Watched(
  const std::shared_ptr<Backend>& backend, const SparseMatrix& matrix, const Progress& progress)
{
  progress.RequireToGoOn();
  if (!progress.Listens() || matrix.rows() < WatchedRows)
  {
    return backend->Compute(matrix);
  }
  // The thread has its own copy of everything: nobody waits for it if it is given up.
  Watch watch(
    [backend, copy = std::make_shared<SparseMatrix>(matrix)] { return backend->Compute(*copy); });
  while (!watch.IsDone())
  {
    progress.RequireToGoOn();
  }
  return watch.Take();
}

ComplexVector Factorization::Solve(const ComplexVector& rightHandSide) const
{
  return this->Factor->Solve(rightHandSide);
}
}
