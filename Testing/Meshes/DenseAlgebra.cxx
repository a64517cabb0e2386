// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/DenseAlgebra.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace Meshes
{
DensePairs DenseEigenpairs(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& m)
{
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXcd> solver(a, m);
  return { solver.eigenvalues(), solver.eigenvectors() };
}

Eigen::VectorXd DenseEigenvalues(const Eigen::MatrixXcd& a)
{
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd>(a, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::MatrixXcd DenseLeastSquares(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b)
{
  return a.colPivHouseholderQr().solve(b);
}

Eigen::MatrixXd RealLeastSquares(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  return a.colPivHouseholderQr().solve(b);
}

Eigen::MatrixXcd DenseSolution(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b)
{
  return a.ldlt().solve(b);
}

Eigen::MatrixXd RealSolution(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  return a.ldlt().solve(b);
}

bool IsPositiveDefinite(const Eigen::MatrixXcd& a)
{
  return a.llt().info() == Eigen::Success;
}
}
