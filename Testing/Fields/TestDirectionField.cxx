// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
/// The smoothest field, which must have converged and consist of unit tangent vectors.
Result ComputeSound(const Surface& surface, int degree, double bias = 0.0, double tolerance = 1e-6)
{
  const Result result = Fields::Compute(surface, degree, bias, tolerance);
  for (const ComponentReport& component : result.Components)
  {
    EXPECT_TRUE(component.Converged);
    EXPECT_LE(component.Residual, tolerance);
    if (component.Closed)
    {
      EXPECT_EQ(component.IndexSum, degree * component.EulerCharacteristic);
    }
  }
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    for (int k = 0; k < degree; ++k)
    {
      const Vector3 d = result.Direction(static_cast<Index>(i), k);
      const bool used = !result.Normal[i].isZero();
      EXPECT_NEAR(d.norm(), used ? 1.0 : 0.0, 1e-12);
      EXPECT_NEAR(d.dot(result.Normal[i]), 0.0, 1e-12);
    }
  }
  return result;
}

int IndexSum(const Result& result)
{
  return std::accumulate(result.SingularityIndex.begin(), result.SingularityIndex.end(), 0);
}

/// Angle from direction 0 of a to the nearest direction of b, about the normal: in units of their
/// period, -0.5 to 0.5 of 2 pi / n, times 2 pi.
double PhaseBetween(
  const Result& a, const Result& b, Index pointA, Index pointB, const Eigen::Matrix3d& rotation)
{
  const Vector3 x = rotation * a.Direction(pointA, 0);
  const Vector3 y = (rotation * a.Normal[pointA]).cross(x);
  const Vector3 d = b.Direction(pointB, 0);
  return std::remainder(a.Degree * std::atan2(d.dot(y), d.dot(x)), 2.0 * Pi);
}
}

TEST(DirectionField, SphereEigenvaluesConvergeToDegreeTimesOneMinusBias)
{
  for (const auto& [degree, bias] : std::vector<std::pair<int, double>>{ { 1, 0.0 }, { 2, 0.0 },
         { 4, 0.0 }, { 6, 0.0 }, { 4, -1.0 }, { 4, 0.5 }, { 4, 1.0 }, { 1, 1.0 } })
  {
    std::array<double, 3> error;
    for (int level = 2; level <= 4; ++level)
    {
      const Result result = ComputeSound(Icosphere(level), degree, bias);
      ASSERT_EQ(result.Components.size(), 1u);
      EXPECT_EQ(IndexSum(result), 2 * degree);
      error[level - 2] = result.Components[0].Eigenvalue - degree * (1.0 - bias);
    }
    // Second order.
    EXPECT_LT(std::abs(error[2]), 0.08) << degree << " " << bias;
    EXPECT_NEAR(error[0] / error[1], 4.0, 0.35) << degree << " " << bias;
    EXPECT_NEAR(error[1] / error[2], 4.0, 0.15) << degree << " " << bias;
  }
}

TEST(DirectionField, SphereOfTenThousandVerticesHasTheReferenceEigenvalues)
{
  DirectionField field(Icosphere(5));
  const auto eigenvalue = [&](int degree, double bias)
  {
    Options options;
    options.Degree = degree;
    options.EnergyBias = bias;
    return field.Compute(options).Components[0].Eigenvalue;
  };
  EXPECT_NEAR(eigenvalue(1, 0.0), 1.00045, 5e-6);
  EXPECT_NEAR(eigenvalue(4, 0.0), 4.0050, 5e-5);
  EXPECT_NEAR(eigenvalue(4, -1.0), 8.0061, 5e-5);
  EXPECT_NEAR(eigenvalue(4, 1.0), 0.0039, 5e-5);
}

TEST(DirectionField, FlatSurfacesHaveAParallelField)
{
  for (const Surface& surface : { Disk(8), Square(7), Cylinder(24, 9, 2.0),
         Transformed(Disk(5), 1e3 * ObliqueRotation(0.7), { 1e4, 0, 0 }) })
  {
    for (const int degree : { 1, 2, 4, 6 })
    {
      const Result result = ComputeSound(surface, degree);
      const double size = (surface.Points.front() - surface.Points.back()).norm();
      EXPECT_NEAR(result.Components[0].Eigenvalue * size * size, 0.0, 1e-9);
      for (const int index : result.SingularityIndex)
      {
        EXPECT_EQ(index, 0);
      }
    }
  }
  // The tightest tolerance is met by a residual that is nothing but rounding.
  for (const Surface& surface : { Square(20), FourfoldDisk(7), Disk(8) })
  {
    ComputeSound(surface, 4, 0.0, 1e-12);
  }
  const Result disk = ComputeSound(Disk(8), 4);
  for (Index i = 0; i < static_cast<Index>(disk.Normal.size()); ++i)
  {
    // The open phase is fixed by the x axis.
    EXPECT_LT((disk.Direction(i, 0) - Vector3::UnitX()).norm(), 1e-6);
    EXPECT_LT((disk.Direction(i, 1) - Vector3::UnitY()).norm(), 1e-6);
  }
}

TEST(DirectionField, CylinderFieldIsParallel)
{
  // Each direction keeps its angle to the rulings.
  const Surface surface = Cylinder(30, 8, 2.0);
  const Result result = ComputeSound(surface, 4);
  const auto angle = [&](Index i)
  {
    const Vector3 d = result.Direction(i, 0);
    return std::remainder(
      4.0 * std::atan2(d.dot(Vector3::UnitZ()), d.dot(Vector3::UnitZ().cross(surface.Points[i]))),
      2.0 * Pi);
  };
  for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
  {
    // Within the error of the linear projection of the tangent cone at the boundary.
    EXPECT_NEAR(std::remainder(angle(i) - angle(0), 2.0 * Pi), 0.0, 0.05);
  }
}

TEST(DirectionField, IndexSumIsExactOnCoarseMeshes)
{
  for (int degree = 1; degree <= 16; ++degree)
  {
    for (const double bias : { -1.0, 0.0, 1.0 })
    {
      EXPECT_EQ(IndexSum(ComputeSound(Tetrahedron(), degree, bias)), 2 * degree);
      EXPECT_EQ(IndexSum(ComputeSound(Octahedron(), degree, bias)), 2 * degree);
      EXPECT_EQ(IndexSum(ComputeSound(Cube(), degree, bias)), 2 * degree);
      EXPECT_EQ(IndexSum(ComputeSound(Icosahedron(), degree, bias)), 2 * degree);
      EXPECT_EQ(IndexSum(ComputeSound(Torus(5, 4), degree, bias)), 0);
      EXPECT_EQ(IndexSum(ComputeSound(DoubleTorus(), degree, bias)), -2 * degree);
    }
  }
}

TEST(DirectionField, DirectionsRunCounterClockwise)
{
  for (const int degree : { 2, 3, 4, 6 })
  {
    const Result result = ComputeSound(Potato(2), degree);
    for (Index i = 0; i < static_cast<Index>(result.Normal.size()); ++i)
    {
      for (int k = 0; k < degree; ++k)
      {
        const Vector3 a = result.Direction(i, k);
        const Vector3 b = result.Direction(i, (k + 1) % degree);
        const double angle = std::atan2(a.cross(b).dot(result.Normal[i]), a.dot(b));
        EXPECT_NEAR(std::remainder(angle - 2.0 * Pi / degree, 2.0 * Pi), 0.0, 1e-12);
      }
    }
  }
}

TEST(DirectionField, RigidMotionTurnsTheFieldWithTheSurface)
{
  const Surface surface = Potato(3);
  const Eigen::Matrix3d rotation = ObliqueRotation(1.9);
  for (const int degree : { 1, 2, 4, 6 })
  {
    for (const double bias : { 0.0, 0.8 })
    {
      const Result a = ComputeSound(surface, degree, bias, 1e-11);
      const Result b =
        ComputeSound(Transformed(surface, rotation, { 5, -3, 8 }), degree, bias, 1e-11);
      EXPECT_NEAR(a.Components[0].Eigenvalue / b.Components[0].Eigenvalue, 1.0, 1e-10);
      EXPECT_EQ(a.SingularityIndex, b.SingularityIndex);
      const double phase = PhaseBetween(a, b, 0, 0, rotation);
      for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
      {
        // One phase everywhere; less certain where the section nearly vanishes.
        const double magnitude = std::abs(a.Representation[i]) / std::abs(a.Representation[0]);
        EXPECT_NEAR(std::remainder(PhaseBetween(a, b, i, i, rotation) - phase, 2.0 * Pi), 0.0,
          1e-6 / std::min(1.0, magnitude));
      }
    }
  }
}

TEST(DirectionField, ScaleAndPositionChangeNothing)
{
  const Surface surface = Potato(3);
  const Result a = ComputeSound(surface, 4, 0.0, 1e-10);
  for (const double scale : { 1e-6, 1e-3, 1e3, 1e6 })
  {
    for (const Vector3& shift : { Vector3(0, 0, 0), Vector3(scale * 100, -scale * 30, 0) })
    {
      const Surface other = Transformed(surface, scale * Eigen::Matrix3d::Identity(), shift);
      const Result b = ComputeSound(other, 4, 0.0, 1e-10);
      EXPECT_EQ(a.SingularityIndex, b.SingularityIndex);
      EXPECT_NEAR(
        a.Components[0].Eigenvalue / b.Components[0].Eigenvalue / scale / scale, 1.0, 1e-9);
      for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
      {
        EXPECT_NEAR(PhaseBetween(a, b, i, i, Eigen::Matrix3d::Identity()), 0.0, 1e-5);
      }
    }
  }
}

TEST(DirectionField, NumberingDecidesNothingWhereAFieldVanishesAtAPoint)
{
  // In the middle of a disk whose boundary the field follows.
  const Surface disk = Disk(6);
  for (const int degree : { 1, 2, 3 })
  {
    Options options;
    options.Degree = degree;
    options.ConstrainBoundary = true;
    const Result a = DirectionField(disk).Compute(options);
    EXPECT_LT(std::abs(a.Representation[0]), 1e-12);
    for (const unsigned seed : { 1u, 2u, 3u, 4u, 5u, 6u })
    {
      std::vector<Index> newPoint;
      std::vector<Index> newTriangle;
      const Result b = DirectionField(Shuffled(disk, seed, newPoint, newTriangle)).Compute(options);
      for (std::size_t t = 0; t < disk.Triangles.size(); ++t)
      {
        EXPECT_EQ(a.SingularityIndex[t], b.SingularityIndex[newTriangle[t]]);
      }
    }
  }
}

TEST(DirectionField, NumberingChangesNothing)
{
  // Also where symmetry leaves a whole eigenspace: on the cube and the icosphere.
  for (const Surface& surface : { Potato(3), Hemisphere(3), Icosphere(2), Cube() })
  {
    const Result a = ComputeSound(surface, 4, 0.0, 1e-11);
    for (const unsigned seed : { 1u, 2u })
    {
      std::vector<Index> newPoint;
      std::vector<Index> newTriangle;
      const Result b = ComputeSound(Shuffled(surface, seed, newPoint, newTriangle), 4, 0.0, 1e-11);
      for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
      {
        EXPECT_EQ(a.SingularityIndex[t], b.SingularityIndex[newTriangle[t]]);
      }
      for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
      {
        const double magnitude = std::abs(a.Representation[i]) / std::abs(a.Representation[0]);
        EXPECT_NEAR(PhaseBetween(a, b, i, newPoint[i], Eigen::Matrix3d::Identity()), 0.0,
          1e-5 / std::min(1.0, magnitude));
      }
    }
  }
}

TEST(DirectionField, EachComponentIsSolvedByItself)
{
  const Surface large = Jittered(Icosphere(3), 0.01, 4);
  const Surface small = Transformed(Icosphere(3), 0.01 * ObliqueRotation(0.4), { 1.5, 0.0, 0.0 });
  const Surface single{ { { 3, 0, 0 }, { 4, 0, 0 }, { 3, 1, 0 } }, { { 0, 1, 2 } } };
  const std::vector<Surface> parts = { large, small, single };
  const Result joined = ComputeSound(Joined(Joined(large, small), single), 4);
  ASSERT_EQ(joined.Components.size(), 3u);
  Index point = 0;
  Index triangle = 0;
  for (std::size_t c = 0; c < parts.size(); ++c)
  {
    const Result alone = ComputeSound(parts[c], 4);
    EXPECT_EQ(joined.Components[c].Eigenvalue, alone.Components[0].Eigenvalue);
    EXPECT_EQ(joined.Components[c].IndexSum, alone.Components[0].IndexSum);
    for (const Complex& u : alone.Representation)
    {
      EXPECT_EQ(joined.Representation[point++], u);
    }
    for (const int index : alone.SingularityIndex)
    {
      EXPECT_EQ(joined.Component[triangle], static_cast<Index>(c));
      EXPECT_EQ(joined.SingularityIndex[triangle++], index);
    }
  }
  EXPECT_EQ(joined.Components[2].EulerCharacteristic, 1);
}

TEST(DirectionField, AllDirectionsAtOnceAreTheSame)
{
  for (const int degree : { 1, 2, 4, 7, 16 })
  {
    const Result field = ComputeSound(Potato(1), degree);
    const auto points = static_cast<Index>(field.Normal.size());
    std::vector<Vector3> all(static_cast<std::size_t>(degree) * points);
    field.Directions(0, points, all.data());
    for (Index i = 0; i < points; ++i)
    {
      for (int k = 0; k < degree; ++k)
      {
        EXPECT_LT((all[degree * i + k] - field.Direction(i, k)).norm(), 1e-14);
      }
    }
  }
}

TEST(DirectionField, ASharedSurfaceGivesTheSameField)
{
  const auto surface = std::make_shared<const Surface>(Potato(2));
  const Result copied = DirectionField(*surface).Compute({});
  const Result shared = DirectionField(surface).Compute({});
  EXPECT_EQ(copied.Representation, shared.Representation);
  EXPECT_EQ(surface.use_count(), 1);
}

TEST(DirectionField, RepeatedRunsAgreeToTheByte)
{
  const Surface surface = Potato(4);
  const Result a = ComputeSound(surface, 4);
  const Result b = ComputeSound(surface, 4);
  EXPECT_EQ(0,
    std::memcmp(
      a.Representation.data(), b.Representation.data(), a.Representation.size() * sizeof(Complex)));
  EXPECT_EQ(a.SingularityIndex, b.SingularityIndex);
  DirectionField field(surface);
  Options other;
  other.Degree = 2;
  field.Compute(other);
  const Result c = field.Compute({});
  EXPECT_EQ(a.Representation, c.Representation);
}

TEST(DirectionField, ThinTrianglesOfAFlatSurfaceKeepItParallel)
{
  Surface surface = Square(40);
  for (Vector3& p : surface.Points)
  {
    p.y() *= 1e-5;
  }
  const Result result = ComputeSound(surface, 4);
  for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
  {
    EXPECT_LT((result.Direction(i, 0) - Vector3::UnitX()).norm(), 1e-3);
  }
  EXPECT_GE(result.Components[0].Eigenvalue, 0.0);
}

TEST(DirectionField, UnusedPointsGetZero)
{
  Surface surface = Octahedron();
  surface.Points.insert(surface.Points.begin(), Vector3(9, 9, 9));
  for (Triangle& t : surface.Triangles)
  {
    for (Index& corner : t)
    {
      ++corner;
    }
  }
  const Result result = ComputeSound(surface, 4);
  EXPECT_EQ(result.Representation[0], Complex(0.0));
  EXPECT_TRUE(result.Direction(0, 3).isZero(0.0));
  EXPECT_EQ(IndexSum(result), 8);
}

TEST(DirectionField, EmptySurface)
{
  const Result result = DirectionField(Surface{}).Compute({});
  EXPECT_TRUE(result.Components.empty());
  EXPECT_FALSE(result.Aborted);
  const Result points = DirectionField(Surface{ { { 1, 2, 3 } }, {} }).Compute({});
  EXPECT_EQ(points.Representation.size(), 1u);
}

TEST(DirectionField, DegenerateTrianglesGiveAFiniteField)
{
  Surface surface = Potato(2);
  // One edge collapsed in space, one triangle's corner laid on its opposite side.
  surface.Points[surface.Triangles[10][0]] = surface.Points[surface.Triangles[10][1]];
  surface.Points[surface.Triangles[200][0]] = 0.3 * surface.Points[surface.Triangles[200][1]] +
    0.7 * surface.Points[surface.Triangles[200][2]];
  for (const int degree : { 1, 4 })
  {
    const Result result = ComputeSound(surface, degree);
    EXPECT_GE(result.Repaired.DegenerateTriangles, 3);
    EXPECT_EQ(IndexSum(result), 2 * degree);
  }
}

TEST(DirectionField, ReportsRepairs)
{
  Surface surface = Potato(2);
  std::swap(surface.Triangles[5][0], surface.Triangles[5][1]);
  surface.Triangles.push_back(surface.Triangles[0]);
  surface.Triangles.push_back({ 1, 1, 2 });
  const Result result = ComputeSound(surface, 4);
  EXPECT_EQ(result.Repaired.ReversedTriangles, 1);
  EXPECT_EQ(result.Repaired.DuplicateTriangles, 1);
  EXPECT_EQ(result.Repaired.CollapsedTriangles, 1);
  EXPECT_EQ(result.Component[surface.Triangles.size() - 1], None);
  // The same field as without the dirt.
  const Result clean = ComputeSound(Potato(2), 4);
  for (std::size_t i = 0; i < clean.Representation.size(); ++i)
  {
    EXPECT_NEAR(std::abs(clean.Representation[i] - result.Representation[i]), 0.0, 1e-6);
  }
  EXPECT_EQ(IndexSum(result), 8);
}

TEST(DirectionField, ProgressRisesAndStops)
{
  Options smoothest;
  Options aligned;
  aligned.Alignment = Alignment::PrincipalCurvature;
  Options constrained;
  constrained.ConstrainBoundary = true;
  constrained.ConstraintSolver = ConstraintSolver::LeastSquares;
  std::vector<Options> all;
  for (const Solver solver : { Solver::Direct, Solver::Multigrid })
  {
    for (Options options : { smoothest, aligned, constrained })
    {
      options.Solver = solver;
      all.push_back(options);
    }
    constrained.ConstraintSolver = ConstraintSolver::Energy;
  }
  const Surface surface =
    Joined(Hemisphere(4), Transformed(Potato(2), ObliqueRotation(1), { 9, 0, 0 }));
  for (const Options& options : all)
  {
    DirectionField field(surface);
    std::vector<double> seen;
    const Result result = field.Compute(options, {},
      [&](double fraction)
      {
        seen.push_back(fraction);
        return true;
      });
    EXPECT_FALSE(result.Aborted);
    ASSERT_GT(seen.size(), 4u);
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    EXPECT_GE(seen.front(), 0.0);
    EXPECT_LE(seen.back(), 1.0);
    for (std::size_t stop = 0; stop < seen.size(); stop += 1 + seen.size() / 12)
    {
      std::size_t calls = 0;
      DirectionField again(surface);
      const Result aborted = again.Compute(options, {}, [&](double) { return calls++ < stop; });
      EXPECT_TRUE(aborted.Aborted);
      EXPECT_EQ(calls, stop + 1);
      EXPECT_TRUE(aborted.Representation.empty());
    }
  }
}

TEST(DirectionField, RefusesOptionsOutOfRange)
{
  DirectionField field(Tetrahedron());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Options> wrong = { { 0 }, { 17 }, { 4, -1.1 }, { 4, 1.1 }, { 4, nan },
    { 4, 0.0, 0.0 }, { 4, 0.0, 0.2 }, { 4, 0.0, nan }, { 4, 0.0, 1e-6, 0 },
    { 4, 0.0, 1e-6, 10001 } };
  for (const Options& options : wrong)
  {
    EXPECT_THROW(field.Compute(options), std::invalid_argument);
  }
}

TEST(DirectionField, SaysWhenItHasNotConverged)
{
  Options options;
  options.Tolerance = 1e-11;
  options.MaximumIterations = 3;
  const Result result = DirectionField(Potato(3)).Compute(options);
  EXPECT_FALSE(result.Components[0].Converged);
  EXPECT_GT(result.Components[0].Residual, 1e-11);
  EXPECT_EQ(result.Components[0].Iterations, 3);
}
