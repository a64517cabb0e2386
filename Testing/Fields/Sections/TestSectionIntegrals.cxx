// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/DenseAlgebra.h"
#include "Meshes/LocalMatrices.h"
#include "Sections/SectionIntegrals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
using Vector2 = Eigen::Vector2d;

double Cross(const Vector2& a, const Vector2& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// Gauss-Legendre nodes and weights on [0, 1], from the eigenvalues of the Jacobi matrix.
struct GaussRule
{
  Eigen::VectorXd Nodes;
  Eigen::VectorXd Weights;
  explicit GaussRule(int points)
  {
    Eigen::MatrixXcd jacobi = Eigen::MatrixXcd::Zero(points, points);
    for (int k = 1; k < points; ++k)
    {
      jacobi(k, k - 1) = jacobi(k - 1, k) = k / std::sqrt(4.0 * k * k - 1.0);
    }
    const DensePairs pairs = DenseEigenpairs(jacobi, Eigen::MatrixXcd::Identity(points, points));
    this->Nodes = 0.5 * (pairs.Values.array() + 1.0);
    this->Weights = pairs.Vectors.row(0).cwiseAbs2();
  }
};

/// Hat sections over a flat triangle with a connection d - i a of constant curvature, a being
/// B/2 (x dy - y dx) about the origin. The value 1 at corner j is transported along straight lines.
class HatSections
{
public:
  HatSections(const std::array<Vector2, 3>& corners, double omega)
    : P(corners)
    , Area(0.5 * Cross(corners[1] - corners[0], corners[2] - corners[0]))
    , B(omega / this->Area)
  {
  }

  Complex Transport(int j, int k) const
  {
    return std::polar(1.0, 0.5 * this->B * Cross(this->P[j], this->P[k]));
  }

  double Hat(int j, const Vector2& x) const
  {
    const Vector2& k = this->P[(j + 1) % 3];
    const Vector2& i = this->P[(j + 2) % 3];
    return 0.5 * Cross(k - x, i - x) / this->Area;
  }

  Complex Value(int j, const Vector2& x) const
  {
    return this->Hat(j, x) * std::polar(1.0, 0.5 * this->B * Cross(this->P[j], x));
  }

  /// Covariant derivatives along x and y.
  Eigen::Vector2cd Derivative(int j, const Vector2& x) const
  {
    const Complex i(0.0, 1.0);
    const Vector2 opposite = this->P[(j + 2) % 3] - this->P[(j + 1) % 3];
    const Vector2 hatGradient = 0.5 * Vector2(-opposite.y(), opposite.x()) / this->Area;
    const Vector2 phaseGradient = 0.5 * this->B * Vector2(-this->P[j].y(), this->P[j].x());
    const Vector2 a = 0.5 * this->B * Vector2(-x.y(), x.x());
    return (hatGradient.cast<Complex>() +
             i * this->Hat(j, x) * (phaseGradient - a).cast<Complex>()) *
      std::polar(1.0, 0.5 * this->B * Cross(this->P[j], x));
  }

  Complex Integrate(const std::function<Complex(const Vector2&)>& f) const
  {
    static const GaussRule rule(30);
    Complex sum = 0.0;
    for (int s = 0; s < rule.Nodes.size(); ++s)
    {
      for (int t = 0; t < rule.Nodes.size(); ++t)
      {
        const double u = rule.Nodes[s];
        const double v = rule.Nodes[t];
        const Vector2 x = (1.0 - u) * this->P[0] + u * ((1.0 - v) * this->P[1] + v * this->P[2]);
        sum += rule.Weights[s] * rule.Weights[t] * 2.0 * this->Area * u * f(x);
      }
    }
    return sum;
  }

  Complex Mass(int j, int k) const
  {
    return this->Integrate(
      [&](const Vector2& x) { return std::conj(this->Value(j, x)) * this->Value(k, x); });
  }

  /// (1 + s) times the part of d psi that is holomorphic plus (1 - s) times the other, each half the
  /// squared modulus of the derivative along x plus or minus i times that along y.
  Complex Energy(int j, int k, double s) const
  {
    const Complex i(0.0, 1.0);
    return this->Integrate(
      [&](const Vector2& x)
      {
        const Eigen::Vector2cd a = this->Derivative(j, x);
        const Eigen::Vector2cd b = this->Derivative(k, x);
        const Complex plus = std::conj(a[0] + i * a[1]) * (b[0] + i * b[1]);
        const Complex minus = std::conj(a[0] - i * a[1]) * (b[0] - i * b[1]);
        return 0.5 * ((1.0 + s) * plus + (1.0 - s) * minus);
      });
  }

  LocalMatrices Closed(double s) const
  {
    return LocalMatrices(
      { (this->P[1] - this->P[0]).squaredNorm(), (this->P[2] - this->P[1]).squaredNorm(),
        (this->P[0] - this->P[2]).squaredNorm() },
      this->Area, this->B * this->Area,
      { this->Transport(0, 1), this->Transport(1, 2), this->Transport(2, 0) }, s);
  }

private:
  std::array<Vector2, 3> P;
  double Area;
  double B;
};

const std::array<std::array<Vector2, 3>, 3> Triangles = { {
  { Vector2(0.0, 0.0), Vector2(1.0, 0.0), Vector2(0.4, 0.9) },
  { Vector2(0.3, -0.2), Vector2(1.6, 0.1), Vector2(0.6, 0.25) },
  { Vector2(-2.0, 1.0), Vector2(3.0, 0.5), Vector2(0.0, 4.0) },
} };
}

TEST(SectionIntegrals, LocalMatricesEqualQuadratureOfTransportedHatSections)
{
  for (const auto& corners : Triangles)
  {
    for (const double omega :
      { 0.0, 1e-9, 1e-4, 0.01, 0.3, 1.0, 1.999, 2.001, 3.2, 5.0, 7.5, 10.0, 12.0 })
    {
      for (const double sign : { -1.0, 1.0 })
      {
        const HatSections sections(corners, sign * omega);
        for (const double s : { -1.0, 0.0, 0.7 })
        {
          const LocalMatrices local = sections.Closed(s);
          const double scale =
            std::abs(sections.Energy(0, 0, 0.0)) + std::abs(sections.Energy(1, 1, 0.0));
          for (int j = 0; j < 3; ++j)
          {
            const int k = (j + 1) % 3;
            EXPECT_NEAR(local.MassDiagonal / sections.Mass(j, j).real(), 1.0, 1e-12);
            EXPECT_LT(std::abs(local.Mass[j] - sections.Mass(j, k)), 1e-12 * local.MassDiagonal)
              << "omega " << sign * omega;
            EXPECT_LT(std::abs(local.EnergyDiagonal[j] - sections.Energy(j, j, s)), 1e-12 * scale)
              << "omega " << sign * omega << " s " << s;
            EXPECT_LT(std::abs(local.Energy[j] - sections.Energy(j, k, s)), 1e-12 * scale)
              << "omega " << sign * omega << " s " << s;
          }
        }
      }
    }
  }
}

TEST(SectionIntegrals, SeriesMeetsClosedFormAtTheSwitch)
{
  for (const double omega : { -SectionIntegrals::SwitchHolonomy, SectionIntegrals::SwitchHolonomy })
  {
    const SectionIntegrals series = SectionIntegrals::Series(omega);
    const SectionIntegrals closed = SectionIntegrals::ClosedForm(omega);
    EXPECT_LT(std::abs(series.E4 - closed.E4), 1e-15);
    EXPECT_LT(std::abs(series.F1 - closed.F1), 2e-15);
    EXPECT_LT(std::abs(series.F2 - closed.F2), 2e-15);
  }
}

TEST(SectionIntegrals, AsManyTermsAsMatterAreSummed)
{
  // Also right below and above where the number of terms changes.
  for (double omega = 1e-12; omega < SectionIntegrals::SwitchHolonomy; omega *= 1.003)
  {
    for (const double sign : { -1.0, 1.0 })
    {
      const SectionIntegrals some = SectionIntegrals::At(sign * omega);
      const SectionIntegrals all = SectionIntegrals::Series(sign * omega);
      EXPECT_LT(std::abs(some.E4 - all.E4), 1e-17) << omega;
      EXPECT_LT(std::abs(some.F1 - all.F1), 1e-16) << omega;
      EXPECT_LT(std::abs(some.F2 - all.F2), 1e-16) << omega;
    }
  }
}

TEST(SectionIntegrals, FlatTriangleHasCotangentWeights)
{
  const SectionIntegrals flat = SectionIntegrals::At(0.0);
  EXPECT_EQ(flat.E4, Complex(1.0 / 24.0));
  EXPECT_EQ(flat.F1, Complex(0.0));
  EXPECT_EQ(flat.F2, Complex(-0.25));
}

TEST(SectionIntegrals, OppositeHolonomyConjugates)
{
  for (const double omega : { 0.1, 1.5, 4.0, 11.0 })
  {
    const SectionIntegrals plus = SectionIntegrals::At(omega);
    const SectionIntegrals minus = SectionIntegrals::At(-omega);
    EXPECT_EQ(plus.E4, std::conj(minus.E4));
    EXPECT_EQ(plus.F1, std::conj(minus.F1));
    EXPECT_EQ(plus.F2, std::conj(minus.F2));
  }
}
