// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Factorization_h
#define DirectionFields_Factorization_h

#include "Progress.h"
#include "Types.h"

#include <functional>
#include <memory>

namespace DirectionFields
{
/// Asked before each longer part of a computation; false stops it. Empty never does.
using GoOnFunction = std::function<bool()>;

/// Throws Stopped.
inline void RequireToGoOn(const GoOnFunction& goOn)
{
  if (goOn && !goOn())
  {
    throw Stopped();
  }
}

/// Sparse Cholesky factorization of a Hermitian positive definite matrix, by Eigen, or by CHOLMOD
/// where it was built in and the matrix is large.
class Factorization
{
public:
  Factorization();
  ~Factorization();

  /// False where the matrix is not positive definite up to rounding. A large matrix is factored on a
  /// thread of its own, and goOn asked several times a second; a factor that it stops is given up, and
  /// its thread ends some time later, at the latest when the program or the library is unloaded.
  bool Compute(const SparseMatrix& matrix, const GoOnFunction& goOn = {});
  /// Needs a successful Compute.
  ComplexVector Solve(const ComplexVector& rightHandSide) const;

private:
  class Backend;
  class EigenBackend;
  class CholmodBackend;
  static bool Watched(const std::shared_ptr<Backend>& backend, const SparseMatrix& matrix,
    const GoOnFunction& goOn);
  std::shared_ptr<Backend> Factor;
};
}

#endif
