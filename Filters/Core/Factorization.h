// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Factorization_h
#define DirectionFields_Factorization_h

#include "Types.h"

#include <memory>

namespace DirectionFields
{
/// Sparse Cholesky factorization of a Hermitian positive definite matrix, by Eigen, or by CHOLMOD
/// where it was built in and the matrix is large.
class Factorization
{
public:
  Factorization();
  ~Factorization();

  /// False where the matrix is not positive definite up to rounding.
  bool Compute(const SparseMatrix& matrix);
  /// Needs a successful Compute.
  ComplexVector Solve(const ComplexVector& rightHandSide) const;

private:
  class Backend;
  class EigenBackend;
  class CholmodBackend;
  std::unique_ptr<Backend> Factor;
};
}

#endif
