// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Systems/ConjugateGradientLoop.h"
#include "Types.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <vector>

using namespace DirectionFields;

namespace
{
/// As the definition has it, with a diagonal matrix as preconditioner.
struct DenseIteration
{
  bool GoesOn() const { return this->R.norm() > 1e-13 && this->Steps < 50; }
  double Precondition()
  {
    this->Z = this->Inverse.cwiseProduct(this->R);
    return this->R.dot(this->Z);
  }
  void SetDirection(double keep)
  {
    this->P = this->Z + keep * this->P;
    this->Keeps.push_back(keep);
  }
  double FindCurvature()
  {
    this->Q = this->K * this->P;
    return this->P.dot(this->Q);
  }
  void Advance(double step)
  {
    this->U += step * this->P;
    this->R -= step * this->Q;
    ++this->Steps;
  }

  Eigen::MatrixXd K;
  Eigen::VectorXd R;
  Eigen::VectorXd Inverse = Eigen::VectorXd::Ones(R.size());
  Eigen::VectorXd U = Eigen::VectorXd::Zero(R.size());
  Eigen::VectorXd P = Eigen::VectorXd::Zero(R.size());
  Eigen::VectorXd Z = {};
  Eigen::VectorXd Q = {};
  std::vector<double> Keeps = {};
  int Steps = 0;
};

/// Definite for a positive shift. Its scales differ by a factor of 10^4.
Eigen::MatrixXd Laplacian(int n, double shift)
{
  Eigen::MatrixXd k = shift * Eigen::MatrixXd::Identity(n, n);
  for (int i = 0; i + 1 < n; ++i)
  {
    k.block<2, 2>(i, i) += Eigen::Matrix2d{ { 1.0, -1.0 }, { -1.0, 1.0 } };
  }
  const Eigen::VectorXd scale = Eigen::VectorXd::LinSpaced(n, 0.0, 2.0).array().exp();
  return scale.asDiagonal() * k * scale.asDiagonal();
}
}

TEST(ConjugateGradientLoop, EndsAfterAsManyStepsAsThereAreUnknowns)
{
  constexpr int n = 8;
  const Eigen::MatrixXd k = Laplacian(n, 0.1);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1.0, 2.0);
  for (const bool preconditioned : { false, true })
  {
    DenseIteration iteration{ k, b };
    if (preconditioned)
    {
      iteration.Inverse = k.diagonal().cwiseInverse();
    }
    TakeConjugateGradientSteps(iteration);
    EXPECT_LE(iteration.Steps, n + 2);
    EXPECT_LT((k * iteration.U - b).norm(), 1e-12 * b.norm());
    EXPECT_EQ(iteration.Keeps.front(), 0.0);
    EXPECT_GT(iteration.Keeps.at(1), 0.0);
  }
}

TEST(ConjugateGradientLoop, EndsWhereTheMatrixIsNotPositive)
{
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(2);
  for (const Eigen::MatrixXd& k :
    { Eigen::MatrixXd(-Eigen::Matrix2d::Identity()), Eigen::MatrixXd(Eigen::Matrix2d::Zero()) })
  {
    DenseIteration iteration{ k, b };
    TakeConjugateGradientSteps(iteration);
    EXPECT_EQ(iteration.Steps, 0);
    EXPECT_EQ(iteration.U.norm(), 0.0);
  }
}
