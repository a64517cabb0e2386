// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/Stages.h"
#include "Geometry/DihedralAngles.h"
#include "Meshes/Surfaces.h"
#include "Meshes/System.h"
#include "Sections/Singularities.h"
#include "SparseCholesky/SupernodalCholesky.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <utility>

using namespace DirectionFields;
using namespace DirectionFields::Internal;
using namespace Meshes;

namespace
{
using Gradient = std::function<Vector3(const Vector3&)>;

Vector3 EllipsoidGradient(const Vector3& p)
{
  return { p.x() / 1.96, p.y(), p.z() / 0.49 };
}

/// 1 : 0.7 : 0.5, of 2562 points that are moved along it by a part of the mean edge.
Surface IrregularEllipsoid(double jitter)
{
  Surface surface = Jittered(Icosphere(4), 0.07 * jitter * std::sqrt(3.0), 7);
  for (Vector3& p : surface.Points)
  {
    p = p.normalized().cwiseProduct(Vector3(1.4, 1.0, 0.7));
  }
  return surface;
}

/// Heights with errors of a part of the mean edge length.
Surface Noisy(Surface surface, double noise, unsigned seed)
{
  const SurfaceGeometry geometry(surface);
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
  {
    surface.Points[geometry.Mesh.Point(v)] +=
      noise * geometry.Lengths.Unit[0] * normal(engine) * geometry.Frames.Normal[v];
  }
  return surface;
}

/// The points in single precision.
Surface Single(Surface surface)
{
  for (Vector3& p : surface.Points)
  {
    for (double& x : p)
    {
      // GCC 12 leaves the rounding out where a number is turned back at once.
      const volatile auto rounded = static_cast<float>(x);
      x = rounded;
    }
  }
  return surface;
}

/// Of principal directions as a cross, the mean angle in degrees, weighted by area and anisotropy; of the mean
/// and the Gaussian curvature the medians of the relative errors.
struct Accuracy
{
  double Angle;
  double Mean;
  double Gaussian;
};

double Median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The shape operator of an implicit surface.
class TrueShape
{
public:
  explicit TrueShape(Gradient gradient)
    : OfPoint(std::move(gradient))
  {
  }

  Accuracy Compare(const Surface& surface) const
  {
    Stages stages(surface);
    const Curvature& curvature = stages.GetCurvature();
    const SurfaceGeometry& geometry = stages.GetGeometry();
    const double unit = geometry.Lengths.Unit[0];
    std::vector<double> area(curvature.Hopf.size(), 0.0);
    for (Index h = 0; h < geometry.Mesh.GetNumberOfHalfEdges(); ++h)
    {
      area[geometry.Mesh.Tail(h)] += geometry.Lengths.Area[h / 3];
    }
    double angle = 0.0;
    double weight = 0.0;
    std::vector<double> mean;
    std::vector<double> gaussian;
    for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
    {
      const Eigen::Matrix3d shape = this->At(geometry.Positions[v]);
      const Vector3& x = geometry.Frames.X[v];
      const Vector3 y = geometry.Frames.Y(v);
      const Complex exact(
        0.5 * (x.dot(shape * x) - y.dot(shape * y)), 0.5 * (x.dot(shape * y) + y.dot(shape * x)));
      const double h = 0.5 * (x.dot(shape * x) + y.dot(shape * y));
      const Complex turn = curvature.Hopf[v] / exact;
      angle += area[v] * std::abs(exact) * std::abs(std::arg(turn * turn)) / 4.0 * 180.0 / Pi;
      weight += area[v] * std::abs(exact);
      mean.push_back(std::abs(curvature.Mean[v] / unit / h - 1.0));
      gaussian.push_back(
        std::abs(curvature.Gaussian[v] / unit / unit / (h * h - std::norm(exact)) - 1.0));
    }
    return { angle / weight, Median(mean), Median(gaussian) };
  }

private:
  Eigen::Matrix3d At(const Vector3& p) const
  {
    constexpr double step = 1e-5;
    Eigen::Matrix3d shape;
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 d = step * Vector3::Unit(k);
      shape.col(k) =
        (this->OfPoint(p + d).normalized() - this->OfPoint(p - d).normalized()) / (2.0 * step);
    }
    return shape;
  }

  Gradient OfPoint;
};
}

TEST(CurvatureAccuracy, PrincipalDirectionsOfAnIrregularEllipsoidAreAsGoodAsThoseOfAQuadric)
{
  for (const double jitter : { 0.0, 0.2, 0.4 })
  {
    const Surface clean = IrregularEllipsoid(jitter);
    const TrueShape exact(EllipsoidGradient);
    const Accuracy found = exact.Compare(clean);
    EXPECT_LT(found.Angle, 0.5) << jitter;
    EXPECT_LT(found.Mean, 0.01) << jitter;
    EXPECT_LT(found.Gaussian, 0.02) << jitter;
    EXPECT_LT(exact.Compare(Noisy(clean, 0.01, 1)).Angle, 1.5) << jitter;
    EXPECT_LT(exact.Compare(Noisy(clean, 0.03, 2)).Angle, 3.0) << jitter;
  }
}

/// The guidance itself, and that of the edges in the weak form (KCPS13, section 6.1.4).
TEST(CurvatureAccuracy, NoiseLeavesATenthOfTheSingularities)
{
  for (const Surface& surface :
    { IrregularEllipsoid(0.3), Jittered(Potato(5), 0.005, 3), Jittered(Torus(120, 60), 0.01, 4) })
  {
    for (const double noise : { 0.02, 0.05 })
    {
      const Surface noisy = Noisy(surface, noise, 6);
      const System system(noisy, 2, 0.0);
      const std::vector<double> dihedral = DihedralAngles(system);
      const Index vertices = system.Mesh.GetNumberOfVertices();
      ComplexVector right = ComplexVector::Zero(vertices);
      for (Index h = 0; h < system.Mesh.GetNumberOfHalfEdges(); ++h)
      {
        const Index edge = system.Mesh.Edge(h);
        right[system.Mesh.Tail(h)] -= 0.25 * dihedral[edge] *
          std::sqrt(system.Lengths.SquaredLength[edge]) *
          std::polar(1.0, 2.0 * system.Transport.EdgeAngle[h]);
      }
      ComplexCholesky factor;
      ASSERT_TRUE(factor.Compute(system.Matrices.Mass));
      const ComplexVector weak = factor.Solve(right);
      const auto singular = [&](const std::vector<Complex>& hopf)
      {
        std::vector<Complex> crosses;
        for (const Complex& q : hopf)
        {
          crosses.push_back(q * q);
        }
        const std::vector<int> indices = SingularityIndices(system, 4, crosses);
        return indices.size() - std::count(indices.begin(), indices.end(), 0);
      };
      EXPECT_LT(
        10 * singular(Curvature(system, dihedral).Hopf), singular({ weak.begin(), weak.end() }))
        << noise;
    }
  }
}

TEST(CurvatureAccuracy, TotalGaussianCurvatureIsTwoPiChi)
{
  for (const auto& [surface, chi] :
    { std::pair(Potato(5), 2), std::pair(Torus(80, 40), 0), std::pair(IrregularEllipsoid(0.3), 2) })
  {
    Stages stages(surface);
    const Curvature& curvature = stages.GetCurvature();
    const SurfaceGeometry& geometry = stages.GetGeometry();
    double sum = 0.0;
    for (Index h = 0; h < geometry.Mesh.GetNumberOfHalfEdges(); ++h)
    {
      sum += geometry.Lengths.Area[h / 3] / 3.0 * curvature.Gaussian[geometry.Mesh.Tail(h)];
    }
    EXPECT_NEAR(sum, 2.0 * Pi * chi, 0.02 * 4.0 * Pi);
  }
}

TEST(CurvatureAccuracy, RoundingBendsNothing)
{
  Surface flat = Transformed(Square(60), ObliqueRotation(1.0), Vector3(0.3, 4.0, -2.0));
  const auto zero = [](const Surface& surface)
  {
    Stages stages(surface);
    const std::vector<Complex>& hopf = stages.GetCurvature().Hopf;
    return std::count(hopf.begin(), hopf.end(), 0.0) == static_cast<Index>(hopf.size());
  };
  EXPECT_TRUE(zero(flat));
  for (const double scale : { 1e-3, 1.0, 1e4 })
  {
    const Eigen::Matrix3d scaling = scale * Eigen::Matrix3d::Identity();
    EXPECT_TRUE(zero(Single(Transformed(flat, scaling, Vector3::Zero())))) << scale;
    // A bow of a hundredth of the length is more than rounding.
    Surface bent = flat;
    const Vector3 normal = ObliqueRotation(1.0).col(2);
    for (std::size_t i = 0; i < bent.Points.size(); ++i)
    {
      const double x = Square(60).Points[i].x() - 0.5;
      bent.Points[i] += 0.04 * x * x * normal;
    }
    EXPECT_FALSE(zero(Single(Transformed(bent, scaling, Vector3::Zero())))) << scale;
  }
}
