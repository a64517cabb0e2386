// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curvature/Curvature.h"
#include "Curvature/ShapeFit.h"
#include "Curvature/ShapeIntegral.h"
#include "Curvature/ShapeSmoothing.h"
#include "Features/Creases.h"
#include "Geometry/DihedralAngles.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

using namespace DirectionFields;
using namespace DirectionFields::Internal;
using namespace Meshes;

namespace
{
/// Where this function of the second order is constant.
struct Quadric
{
  Vector3 Gradient(const Vector3& p) const { return this->Second.cwiseProduct(p) + this->First; }

  Vector3 Second;
  Vector3 First;
};

const Vector3 Axes(1.0, 0.7, 0.45);
const Quadric Ellipsoid = { Axes.cwiseAbs2().cwiseInverse(), Vector3::Zero() };
const Quadric Sphere = { Vector3::Ones(), Vector3::Zero() };
const Quadric Saddle = { Vector3(-1.0, 1.0, 0.0), Vector3::UnitZ() };

/// An icosphere of uneven triangles, stretched.
Surface UnevenEllipsoid(int levels, unsigned seed)
{
  Surface surface = BadSphere(levels, 0.5 / (1 << levels), seed);
  for (Vector3& p : surface.Points)
  {
    p = p.cwiseProduct(Axes);
  }
  return surface;
}

/// The points of a surface put on the saddle.
Surface OnSaddle(Surface surface)
{
  for (Vector3& p : surface.Points)
  {
    p.z() = 0.5 * (p.x() * p.x() - p.y() * p.y());
  }
  return surface;
}

/// Errors along the normal, of a part of the mean edge length.
Surface Noisy(Surface surface, const Quadric& quadric, double noise, unsigned seed)
{
  const SurfaceGeometry geometry(surface);
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  for (Vector3& p : surface.Points)
  {
    p += noise * geometry.Lengths.Unit[0] * normal(engine) * quadric.Gradient(p).normalized();
  }
  return surface;
}

/// Whether noise is found in a surface of one component, whose shapes stay as they are then.
bool IsNoisy(const Surface& surface)
{
  const SurfaceGeometry geometry(surface);
  std::vector<Shape> shapes = FitShapes(geometry, Creases(geometry, DihedralAngles(geometry)));
  const std::vector<Shape> fits = shapes;
  const bool isNoisy = SmoothShapes(geometry, fits, 0.0, shapes).front() != 0;
  for (std::size_t v = 0; v < fits.size(); ++v)
  {
    EXPECT_TRUE(!isNoisy || shapes[v].Hopf == fits[v].Hopf);
  }
  return isNoisy;
}

struct Errors
{
  /// The mean angle between the principal directions and the exact ones, weighted by the difference
  /// of the exact curvatures, in degrees.
  double Angle = 0.0;
  /// The median error of H, relative to the norm of the shape operator.
  double Mean = 0.0;
};

/// Those with noise.
Errors NoisyErrors(const Surface& surface, const Quadric& quadric, double noise)
{
  const SurfaceGeometry geometry(Noisy(surface, quadric, noise, 3));
  const Curvature curvature(geometry, DihedralAngles(geometry));
  std::vector<double> means;
  double angles = 0.0;
  double weights = 0.0;
  for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
  {
    const Vector3 second =
      quadric.Second / quadric.Gradient(surface.Points[geometry.Mesh.Point(v)]).norm();
    const Vector3& x = geometry.Frames.X[v];
    const Vector3 y = geometry.Frames.Y(v);
    const double xx = x.dot(second.cwiseProduct(x));
    const double yy = y.dot(second.cwiseProduct(y));
    const Complex hopf(0.5 * (xx - yy), x.dot(second.cwiseProduct(y)));
    const double mean = 0.5 * (xx + yy);
    means.push_back(std::abs(curvature.Mean[v] / geometry.Lengths.Unit[0] - mean) /
      std::sqrt(std::norm(hopf) + mean * mean));
    const double angle = 90.0 / Pi * std::abs(std::arg(curvature.Hopf[v] * std::conj(hopf)));
    angles += std::abs(hopf) * angle;
    weights += std::abs(hopf);
  }
  const auto middle = means.begin() + static_cast<std::ptrdiff_t>(means.size() / 2);
  std::nth_element(means.begin(), middle, means.end());
  return { angles / weights, *middle };
}
}

TEST(CurvatureOfNoise, IsAveragedOverAsMuchAsItAsksFor)
{
  const Surface ellipsoid = UnevenEllipsoid(5, 1);
  const Errors clean = NoisyErrors(ellipsoid, Ellipsoid, 0.0);
  EXPECT_LT(clean.Angle, 0.1);
  EXPECT_LT(clean.Mean, 0.003);
  const Errors one = NoisyErrors(ellipsoid, Ellipsoid, 0.01);
  EXPECT_LT(one.Angle, 0.36);
  EXPECT_LT(one.Mean, 0.008);
  const Errors three = NoisyErrors(ellipsoid, Ellipsoid, 0.03);
  EXPECT_LT(three.Angle, 0.72);
  EXPECT_LT(three.Mean, 0.015);
}

TEST(CurvatureOfNoise, IsAveragedUpToBoundaries)
{
  const Errors errors = NoisyErrors(OnSaddle(Jittered(Square(50), 0.3 / 50, 2)), Saddle, 0.03);
  EXPECT_LT(errors.Angle, 0.6);
  EXPECT_LT(errors.Mean, 0.015);
}

TEST(CurvatureOfNoise, IsAveragedAcrossEdgesThatAreBentAtSlivers)
{
  const Errors errors = NoisyErrors(OnSaddle(BadSquare(60, 3)), Saddle, 0.02);
  EXPECT_LT(errors.Angle, 2.7);
  EXPECT_LT(errors.Mean, 0.072);
}

TEST(CurvatureOfNoise, CancelsInIntegrals)
{
  // With all steps that are taken at most, those of the fits in the same surroundings.
  const double rings = std::sqrt(1.5 * 128.0);
  const Surface sphere = BadSphere(5, 0.5 / 32.0, 4);
  const SurfaceGeometry geometry(Noisy(sphere, Sphere, 0.05, 5));
  const std::vector<double> angles = DihedralAngles(geometry);
  const auto error = [&](double scale)
  {
    double sum = 0.0;
    for (const Complex& q : Curvature(geometry, angles, scale).Hopf)
    {
      sum += std::norm(q);
    }
    return std::sqrt(sum);
  };
  EXPECT_LT(error(0.0), 0.25 * error(rings));
}

TEST(CurvatureOfNoise, IsTakenAsSuchWhereMostOfAComponentHasIt)
{
  const Surface ellipsoid = UnevenEllipsoid(4, 2);
  EXPECT_FALSE(IsNoisy(ellipsoid));
  for (const double noise : { 0.01, 0.03, 0.05 })
  {
    EXPECT_TRUE(IsNoisy(Noisy(ellipsoid, Ellipsoid, noise, 3))) << noise;
  }
  // Rounded coordinates of what is flat.
  EXPECT_FALSE(IsNoisy(Noisy(Square(20), { Vector3::Zero(), Vector3::UnitZ() }, 1e-5, 3)));
  // Shape that the triangles are too large for, as of coarse meshes of animals.
  EXPECT_FALSE(IsNoisy(Noisy(ellipsoid, Ellipsoid, 0.3, 3)));
  EXPECT_FALSE(IsNoisy(Potato(2)));
  const Surface noisy = Noisy(ellipsoid, Ellipsoid, 0.03, 3);
  for (const bool isMost : { false, true })
  {
    Surface partly = ellipsoid;
    for (std::size_t p = 0; p < partly.Points.size(); ++p)
    {
      if (partly.Points[p].x() > (isMost ? -0.5 : 0.5))
      {
        partly.Points[p] = noisy.Points[p];
      }
    }
    EXPECT_EQ(IsNoisy(partly), isMost);
  }
}

TEST(CurvatureOfNoise, DoesNotChangeThatOfOtherComponents)
{
  const Surface clean = UnevenEllipsoid(4, 2);
  const Surface noisy = Transformed(
    Noisy(clean, Ellipsoid, 0.03, 3), Eigen::Matrix3d::Identity(), Vector3(3.0, 0.0, 0.0));
  const SurfaceGeometry alone(clean);
  const SurfaceGeometry both(Joined(clean, noisy));
  const Curvature wanted(alone, DihedralAngles(alone));
  const Curvature found(both, DihedralAngles(both));
  for (std::size_t v = 0; v < wanted.Hopf.size(); ++v)
  {
    EXPECT_EQ(found.Hopf[v], wanted.Hopf[v]);
    EXPECT_EQ(found.Mean[v], wanted.Mean[v]);
  }
}

TEST(ShapeIntegral, IsExactOnTriangulatedQuadrics)
{
  constexpr double slight = 1e-4;
  const double xx = 1.0;
  const double xy = 0.4;
  const double yy = -0.3;
  Surface surface = Jittered(Square(12), 0.25 / 12, 6);
  for (Vector3& p : surface.Points)
  {
    p.z() = -slight * (0.5 * xx * p.x() * p.x() + xy * p.x() * p.y() + 0.5 * yy * p.y() * p.y());
  }
  const SurfaceGeometry geometry(surface);
  const TriangleMesh& mesh = geometry.Mesh;
  const std::vector<double> angles = DihedralAngles(geometry);
  std::vector<Index> fan;
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (mesh.IsBoundary(v))
    {
      continue;
    }
    Shape edges;
    mesh.GetFan(v, fan);
    double area = 0.0;
    for (const Index h : fan)
    {
      const double bend =
        0.25 * angles[mesh.Edge(h)] * std::sqrt(geometry.Lengths.SquaredLength[mesh.Edge(h)]);
      edges.Hopf -= std::polar(bend, 2.0 * geometry.Transport.EdgeAngle[h]);
      edges.Mean += bend;
      area += geometry.Lengths.Area[h / 3] / 3.0;
    }
    edges.Hopf /= area;
    edges.Mean /= area;
    const Complex x = geometry.Frames.Tangential(v, Vector3::UnitX());
    const double size = slight * geometry.Lengths.Unit[0];
    const Shape exact{ size * Complex(0.5 * (xx - yy), xy) * x * x, 0.5 * size * (xx + yy), 0.0 };
    const WeightedShape found = ShapeIntegral(geometry, v, edges, exact);
    EXPECT_NEAR(found.Weight, area, 1e-12);
    EXPECT_LT(std::abs(found.GetHopf() - exact.Hopf), 1e-3 * size);
    EXPECT_NEAR(found.GetMean(), exact.Mean, 1e-3 * size);
    // The edges on their own are off by much more on such a mesh.
    EXPECT_GT(std::abs(edges.Hopf - exact.Hopf) + std::abs(edges.Mean - exact.Mean), 1e-2 * size);
  }
}

TEST(ShapeIntegral, IsThatOfTheEstimateWhereTrianglesAreFolded)
{
  Surface surface = Square(6);
  const auto middle = std::find_if(surface.Points.begin(), surface.Points.end(),
    [](const Vector3& p) { return (p - Vector3(0.5, 0.5, 0.0)).norm() < 1e-9; });
  ASSERT_NE(middle, surface.Points.end());
  middle->x() += 1.6 / 6.0;
  const SurfaceGeometry geometry(surface);
  const Shape estimate{ Complex(0.1, 0.2), 0.3, 0.0 };
  const Shape edges{ Complex(5.0, -4.0), 7.0, 0.0 };
  for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
  {
    if (geometry.Mesh.Point(v) == middle - surface.Points.begin())
    {
      const WeightedShape found = ShapeIntegral(geometry, v, edges, estimate);
      EXPECT_NEAR(std::abs(found.GetHopf() - estimate.Hopf), 0.0, 1e-12);
      EXPECT_NEAR(found.GetMean(), estimate.Mean, 1e-12);
    }
  }
}
