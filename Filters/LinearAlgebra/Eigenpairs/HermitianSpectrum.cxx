// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Eigenpairs/HermitianSpectrum.h"

#include <Eigen/Eigenvalues>

namespace DirectionFields::Internal
{
HermitianSpectrum::HermitianSpectrum(const Eigen::MatrixXcd& a)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> solver(a);
  this->Values = solver.eigenvalues();
  this->Vectors = solver.eigenvectors();
  this->IsFound = solver.info() == Eigen::Success;
}

HermitianSpectrum::HermitianSpectrum(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& m)
{
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXcd> solver(a, m);
  this->Values = solver.eigenvalues();
  this->Vectors = solver.eigenvectors();
  this->IsFound = solver.info() == Eigen::Success;
}
}
