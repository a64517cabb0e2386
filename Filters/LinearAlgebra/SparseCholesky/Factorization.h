// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Factorization_h
#define DirectionFields_Factorization_h

#include "Progress.h"
#include "Types.h"

#include <memory>

namespace DirectionFields::Internal
{
/// Sparse Cholesky factorization of a Hermitian positive definite matrix, by Eigen, or by CHOLMOD
/// where it was built in and the matrix is large.
class Factorization
{
public:
  Factorization();
  ~Factorization();

  /// False where the matrix is not positive definite up to rounding. If somebody could stop it, a
  /// large matrix is factored on a thread of its own, and progress is asked several times a second
  /// whether to go on. Throws Stopped: the factor is given up then, and its thread ends some time
  /// later, at the latest when the program or the library is unloaded.
  bool Compute(const SparseMatrix& matrix, const Progress& progress = {});
  /// Needs a successful Compute.
  ComplexVector Solve(const ComplexVector& rightHandSide) const;

  /// Whether a matrix of so many rows is factored by CHOLMOD's supernodal method.
  static bool IsSupernodal(Eigen::Index rows);

private:
  class Backend;
  class EigenBackend;
  class CholmodBackend;
  static bool Watched(
    const std::shared_ptr<Backend>& backend, const SparseMatrix& matrix, const Progress& progress);
  std::shared_ptr<Backend> Factor;
};
}

#endif
