// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Unfolding/TriangleDistortion.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// How much a wrong area counts as against a wrong shape: little, since the integers decide on
/// the area.
constexpr double AreaWeight = 0.2;

double RootOf(double determinant, double epsilon)
{
  return std::sqrt(determinant * determinant + epsilon * epsilon);
}

/// (d + root) / 2 without cancellation where d is negative.
double ChiOf(double determinant, double root, double epsilon)
{
  return determinant > 0.0 ? 0.5 * (determinant + root)
                           : 0.5 * epsilon * epsilon / (root - determinant);
}

double SumOf(const TriangleDistortion::Derivative& j, double determinant)
{
  return j.squaredNorm() + AreaWeight * (determinant * determinant + 1.0);
}
}

double TriangleDistortion::ValueOf(const Derivative& j, double epsilon)
{
  const double d = Determinant(j);
  return SumOf(j, d) / ChiOf(d, RootOf(d, epsilon), epsilon);
}

TriangleDistortion::TriangleDistortion(const Derivative& j, double epsilon)
{
  const double d = Determinant(j);
  const double root = RootOf(d, epsilon);
  const double chi = ChiOf(d, root, epsilon);
  const double sum = SumOf(j, d);
  this->Value = sum / chi;
  // The derivatives of 1 / chi by d are -first and second.
  const double first = 1.0 / (root * chi);
  const double second = 2.0 / (root * root * root);
  const double byDeterminant = AreaWeight * 2.0 * d / chi - sum * first;
  const Derivative cofactors(j[3], -j[2], -j[1], j[0]);
  this->Gradient = 2.0 / chi * j + byDeterminant * cofactors;
  Eigen::Matrix4d ofDeterminant = Eigen::Matrix4d::Zero();
  ofDeterminant(0, 3) = ofDeterminant(3, 0) = 1.0;
  ofDeterminant(1, 2) = ofDeterminant(2, 1) = -1.0;
  this->Hessian = 2.0 / chi * Eigen::Matrix4d::Identity() -
    2.0 * first * (j * cofactors.transpose() + cofactors * j.transpose()) +
    (AreaWeight * (2.0 / chi - 4.0 * d * first) + sum * second) * cofactors *
      cofactors.transpose() +
    byDeterminant * ofDeterminant;
}

void TriangleDistortion::Convexify()
{
  // Most triangles are near their shape, where all are positive.
  if (Eigen::LLT<Eigen::Matrix4d>(this->Hessian).info() == Eigen::Success)
  {
    return;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(this->Hessian);
  this->Hessian = solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).asDiagonal() *
    solver.eigenvectors().transpose();
}
}
