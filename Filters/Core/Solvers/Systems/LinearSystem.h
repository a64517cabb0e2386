// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LinearSystem_h
#define DirectionFields_LinearSystem_h

#include "Solvers/Matrices/Factorization.h"
#include "Types.h"

#include <functional>
#include <stdexcept>
#include <vector>

namespace DirectionFields
{
/// A field that satisfies a linear system, and how well.
struct SystemSolution
{
  ComplexVector Vector;
  /// ‖K u - b‖ / ‖b‖ of what was solved (for least squares: the normal equations), or over
  /// 1e-6 ‖|K| |u|‖ where rounding allows no better; 0 where nothing was left to solve.
  double Residual = 0.0;
  /// A u and M u where they came along; or empty.
  ComplexVector Energy;
  ComplexVector Mass;
};

/// Vertices with given representation vectors.
struct GivenValues
{
  std::vector<Index> Vertices;
  /// One for each of Vertices.
  ComplexVector Values;
};

/// K cannot be factored: it is not positive definite, or rounding makes it so.
class NotPositiveDefinite : public std::runtime_error
{
public:
  NotPositiveDefinite()
    : std::runtime_error("The linear system could not be factored: the mesh has triangles of too "
                         "different sizes or shapes. Remesh it more evenly.")
  {
  }
};

/// Solves K u = b for a Hermitian positive definite K. This and the others throw Stopped and
/// NotPositiveDefinite.
SystemSolution SolveAligned(const SparseMatrix& matrix, const ComplexVector& rightHandSide,
  const GoOnFunction& goOn = {});

/// K_ff u_f = b_f - K_fc u_c: u minimizes u^* K u - 2 Re b^* u among the fields with the given
/// values.
SystemSolution SolveConstrainedEnergy(const SparseMatrix& matrix,
  const ComplexVector& rightHandSide, const GivenValues& given, const GoOnFunction& goOn = {});

/// K_f^* K_f u_f = K_f^* (b - K_c u_c), K_f and K_c the columns of the free and of the given
/// vertices: u minimizes ‖K u - b‖ among the fields with the given values (POC14).
SystemSolution SolveConstrainedLeastSquares(const SparseMatrix& matrix,
  const ComplexVector& rightHandSide, const GivenValues& given, const GoOnFunction& goOn = {});
}

#endif
