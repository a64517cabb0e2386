// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_DenseAlgebra_h
#define DirectionFields_DenseAlgebra_h

#include <Eigen/Core>

/// Eigen's dense decompositions, to compare sparse solvers with. Each takes the compiler ten seconds,
/// so that they are compiled once for all tests.
namespace Meshes
{
/// Eigenpairs of a matrix pencil, from the smallest eigenvalue on.
struct DensePairs
{
  Eigen::VectorXd Values;
  /// One eigenvector a column, orthonormal in the second matrix.
  Eigen::MatrixXcd Vectors;
};

/// The eigenpairs of A u = x M u for a Hermitian A and a positive definite M.
DensePairs DenseEigenpairs(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& m);

/// The eigenvalues of a Hermitian matrix, from the smallest on.
Eigen::VectorXd DenseEigenvalues(const Eigen::MatrixXcd& a);

/// The vectors x for which |A x - b| is smallest, one for each column of b.
Eigen::MatrixXcd DenseLeastSquares(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b);
Eigen::MatrixXd RealLeastSquares(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// The solutions of A x = b for a Hermitian A.
Eigen::MatrixXcd DenseSolution(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b);
Eigen::MatrixXd RealSolution(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Whether a Hermitian matrix is positive definite.
bool IsPositiveDefinite(const Eigen::MatrixXcd& a);
}

#endif
