// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Factorization.h"

#include <Eigen/SparseCholesky>
#ifdef DIRECTIONFIELDS_HAVE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

namespace DirectionFields
{
class Factorization::Backend
{
public:
  virtual ~Backend() = default;
  virtual bool Compute(const SparseMatrix& matrix, const GoOnFunction& goOn) = 0;
  virtual ComplexVector Solve(const ComplexVector& rightHandSide) const = 0;
};

class Factorization::EigenBackend : public Factorization::Backend
{
public:
  bool Compute(const SparseMatrix& matrix, const GoOnFunction& goOn) override
  {
    RequireToGoOn(goOn);
    this->Solver.analyzePattern(matrix);
    RequireToGoOn(goOn);
    this->Solver.factorize(matrix);
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
  bool Compute(const SparseMatrix& matrix, const GoOnFunction& goOn) override
  {
    RequireToGoOn(goOn);
    this->Solver.analyzePattern(matrix);
    RequireToGoOn(goOn);
    this->Solver.factorize(matrix);
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

bool Factorization::Compute(const SparseMatrix& matrix, const GoOnFunction& goOn)
{
#ifdef DIRECTIONFIELDS_HAVE_CHOLMOD
  if (matrix.rows() >= CholmodRows)
  {
    this->Factor = std::make_unique<CholmodBackend>();
    if (this->Factor->Compute(matrix, goOn))
    {
      return true;
    }
  }
#endif
  this->Factor = std::make_unique<EigenBackend>();
  return this->Factor->Compute(matrix, goOn);
}

ComplexVector Factorization::Solve(const ComplexVector& rightHandSide) const
{
  return this->Factor->Solve(rightHandSide);
}
}
