// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/ComponentStage.h"
#include "Computation/Stages.h"
#include "DirectionField.h"
#include "Guidance/Guidance.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <functional>
#include <limits>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
Options CurvatureAligned(int degree, double strength)
{
  Options options;
  options.Degree = degree;
  options.Tolerance = 1e-9;
  options.Alignment = Alignment::PrincipalCurvature;
  options.AlignmentStrength = strength;
  return options;
}

/// Guidance of a smooth vector field without symmetry.
Guidance SpatialVectors(const Surface& surface)
{
  Guidance guidance;
  for (const Vector3& p : surface.Points)
  {
    guidance.Vectors.emplace_back(1.0 + 0.3 * p.y(), 0.5 - p.z(), p.x() * p.y());
  }
  return guidance;
}

double PhaseDifference(const Result& a, const Result& b, Index point)
{
  return std::arg(b.Representation[point] * std::conj(a.Representation[point]));
}
}

TEST(Alignment, TorusAndCylinderFollowThePrincipalDirections)
{
  for (const int degree : { 2, 4 })
  {
    const Surface torus = Torus(96, 48);
    const Result onTorus = DirectionField(torus).Compute(CurvatureAligned(degree, 0.9));
    const Surface cylinder = Cylinder(48, 30, 3.0);
    const Result onCylinder = DirectionField(cylinder).Compute(CurvatureAligned(degree, 0.9));
    for (Index i = 0; i < static_cast<Index>(torus.Points.size()); ++i)
    {
      const Vector3& p = torus.Points[i];
      const Vector3 radial = Vector3(p.x(), p.y(), 0.0).normalized();
      const Vector3 around = Vector3::UnitZ().cross(radial);
      const Vector3 meridian = (p - radial).cross(around).normalized();
      EXPECT_LT(Deviation(onTorus, i, meridian), 2.0);
      EXPECT_EQ(onTorus.SingularityIndex.size(), torus.Triangles.size());
    }
    for (Index i = 0; i < static_cast<Index>(cylinder.Points.size()); ++i)
    {
      const Vector3& p = cylinder.Points[i];
      if (p.z() > 0.4 && p.z() < 2.6)
      {
        EXPECT_LT(Deviation(onCylinder, i, { -p.y(), p.x(), 0.0 }), 2.0);
      }
    }
    for (const int index : onTorus.SingularityIndex)
    {
      EXPECT_EQ(index, 0);
    }
  }
}

TEST(Alignment, MinimumIsOrthogonalToMaximum)
{
  const Surface surface = Torus(48, 24);
  Options options = CurvatureAligned(2, 0.9);
  const Result maximum = DirectionField(surface).Compute(options);
  options.CurvatureDirection = CurvatureDirection::Minimum;
  const Result minimum = DirectionField(surface).Compute(options);
  for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
  {
    EXPECT_NEAR(std::abs(PhaseDifference(maximum, minimum, i)), Pi, 1e-6);
  }
}

TEST(Alignment, EllipsoidConverges)
{
  // Away from the four umbilics, where the directions are not defined.
  std::vector<double> mean;
  for (int level = 3; level <= 5; ++level)
  {
    Surface s = Icosphere(level);
    for (Vector3& p : s.Points)
    {
      p = p.cwiseProduct(Vector3(1.4, 1.0, 0.7));
    }
    const Result result = DirectionField(s).Compute(CurvatureAligned(4, 0.9999));
    double sum = 0.0;
    int count = 0;
    for (Index i = 0; i < static_cast<Index>(s.Points.size()); ++i)
    {
      const Vector3& p = s.Points[i];
      const Vector3 gradient(p.x() / 1.96, p.y(), p.z() / 0.49);
      const Vector3 normal = gradient.normalized();
      const Eigen::Matrix3d tangential = Eigen::Matrix3d::Identity() - normal * normal.transpose();
      const Eigen::Matrix3d hessian = Vector3(1.0 / 1.96, 1.0, 1.0 / 0.49).asDiagonal();
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> shape(
        tangential * hessian * tangential / gradient.norm());
      if (shape.eigenvalues()[2] - shape.eigenvalues()[1] > 0.5)
      {
        sum += Deviation(result, i, shape.eigenvectors().col(2));
        ++count;
      }
    }
    ASSERT_GT(count, 100);
    mean.push_back(sum / count);
  }
  EXPECT_LT(mean[1], 0.6 * mean[0]);
  EXPECT_LT(mean[2], 0.6 * mean[1]);
  EXPECT_LT(mean[2], 0.5);
}

TEST(Alignment, StrengthZeroIsTheSmoothestAndOneTheGuidance)
{
  const Surface surface = Potato(3);
  Options options;
  options.Tolerance = 1e-11;
  DirectionField field(surface);
  const Result smoothest = field.Compute(options);
  options.Alignment = Alignment::PointVectors;
  const Guidance guidance = SpatialVectors(surface);
  options.AlignmentStrength = 0.0;
  const Result none = field.Compute(options, guidance);
  const double phase = PhaseDifference(smoothest, none, 0);
  for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
  {
    EXPECT_NEAR(std::remainder(PhaseDifference(smoothest, none, i) - phase, 2.0 * Pi), 0.0, 1e-7);
  }
  EXPECT_EQ(none.SingularityIndex, smoothest.SingularityIndex);
  EXPECT_DOUBLE_EQ(none.Components[0].Lambda, none.Components[0].Eigenvalue);

  // A hair above zero is next to it.
  options.AlignmentStrength = 1e-6;
  const Result hair = field.Compute(options, guidance);
  EXPECT_TRUE(hair.Components[0].Converged);
  for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
  {
    const double magnitude = std::abs(none.Representation[i]) / std::abs(none.Representation[0]);
    EXPECT_NEAR(PhaseDifference(hair, none, i), 0.0, 1e-3 / std::min(1.0, magnitude));
  }

  options.AlignmentStrength = 1.0;
  const Result all = field.Compute(options, guidance);
  for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
  {
    const Vector3 projected =
      guidance.Vectors[i] - guidance.Vectors[i].dot(all.Normal[i]) * all.Normal[i];
    EXPECT_LT(Deviation(all, i, projected), 1e-4);
  }
}

TEST(Alignment, EnergiesAreMonotoneInTheStrength)
{
  for (const int degree : { 1, 2, 4 })
  {
    const Surface surface = Potato(3);
    Stages stages(surface);
    const Guidance vectors = SpatialVectors(surface);
    const std::vector<Complex> q = GuidanceSection(stages.GetGeometry(), vectors, degree);
    const ComplexVector guidance =
      Eigen::Map<const ComplexVector>(q.data(), static_cast<Eigen::Index>(q.size()));
    Options options;
    options.Degree = degree;
    options.Alignment = Alignment::PointVectors;
    const Operators& operators = stages.GetEnergy(options, {}).Components[0].GetMatrices();
    DirectionField field(surface);
    double smoothness = 0.0;
    double overlap = 0.0;
    for (const double strength : { 0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 1.0 })
    {
      options.AlignmentStrength = strength;
      const Result result = field.Compute(options, vectors);
      ComplexVector u(guidance.size());
      for (Index v = 0; v < u.size(); ++v)
      {
        u[v] = result.Representation[stages.GetMesh().Point(v)];
      }
      const double size = u.dot(operators.Mass * u).real();
      const double energy = u.dot(operators.Energy * u).real() / size;
      const double along = u.dot(operators.Mass * guidance).real() / std::sqrt(size);
      if (strength > 0.0)
      {
        EXPECT_GT(energy, smoothness);
        EXPECT_GT(along, overlap);
      }
      smoothness = energy;
      overlap = along;
      const double unit = stages.GetGeometry().Lengths.Unit[0];
      EXPECT_NEAR(result.Components[0].SmoothnessEnergy * unit * unit / energy, 1.0, 1e-9);
      EXPECT_LE(result.Components[0].SystemResidual, 1e-6);
      EXPECT_TRUE(result.Components[0].Converged);
    }
  }
}

TEST(Alignment, LambdaFollowsTheDefinition)
{
  const Surface surface =
    Joined(Potato(2), Transformed(Potato(2), 0.1 * ObliqueRotation(1.0), { 5, 0, 0 }));
  DirectionField field(surface);
  Options options = CurvatureAligned(4, 0.25);
  const Result result = field.Compute(options);
  ASSERT_EQ(result.Components.size(), 2u);
  for (const ComponentReport& c : result.Components)
  {
    // Both are closed and curved enough for sigma to be lambda_1.
    EXPECT_NEAR(c.Lambda / c.Eigenvalue, 1.0 - 0.25 / 0.75, 1e-9);
  }
  options.AlignmentStrength = 0.5;
  for (const ComponentReport& c : field.Compute(options).Components)
  {
    EXPECT_NEAR(c.Lambda, 0.0, 1e-12 * c.Eigenvalue);
  }
  options.UseShift = true;
  options.Shift = 3.5;
  for (const ComponentReport& c : field.Compute(options).Components)
  {
    EXPECT_NEAR(c.Eigenvalue - c.Lambda, 3.5, 1e-9 * c.Eigenvalue);
  }
  options.Shift = 0.0;
  for (const ComponentReport& c : field.Compute(options).Components)
  {
    EXPECT_DOUBLE_EQ(c.Lambda, c.Eigenvalue);
  }
}

TEST(Alignment, EachComponentByItself)
{
  const Surface large = Potato(3);
  const Surface small = Transformed(Potato(2), 0.01 * ObliqueRotation(2), { 5, 0, 0 });
  const Result joined = DirectionField(Joined(large, small)).Compute(CurvatureAligned(4, 0.6));
  Index point = 0;
  for (const Surface& part : { large, small })
  {
    const Result alone = DirectionField(part).Compute(CurvatureAligned(4, 0.6));
    for (const Complex& u : alone.Representation)
    {
      EXPECT_EQ(joined.Representation[point++], u);
    }
  }
}

TEST(Alignment, SameFieldAtAnyScaleAndPosition)
{
  const Surface surface = Potato(3);
  for (const int degree : { 2, 4 })
  {
    Options options = CurvatureAligned(degree, 0.7);
    options.ConstrainCurvature = degree == 4;
    const Result a = DirectionField(surface).Compute(options);
    for (const double scale : { 1e-6, 1e6 })
    {
      const Result b = DirectionField(
        Transformed(surface, scale * Eigen::Matrix3d::Identity(), scale * Vector3(3, 2, 1)))
                         .Compute(options);
      EXPECT_EQ(a.SingularityIndex, b.SingularityIndex);
      EXPECT_EQ(a.Constraint, b.Constraint);
      for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
      {
        EXPECT_NEAR(PhaseDifference(a, b, i), 0.0, 1e-4);
      }
      EXPECT_NEAR(a.Curvature->Mean[7] / b.Curvature->Mean[7] / scale, 1.0, 1e-6);
      EXPECT_NEAR(a.Curvature->Gaussian[7] / b.Curvature->Gaussian[7] / scale / scale, 1.0, 1e-6);
    }
  }
}

TEST(Alignment, WeightsAndLengthsOfTheGuidance)
{
  const Surface surface = Potato(3);
  DirectionField field(surface);
  Options options;
  options.Alignment = Alignment::PointVectors;
  options.AlignmentStrength = 1.0;
  Guidance guidance = SpatialVectors(surface);
  const Result plain = field.Compute(options, guidance);
  // Weight and length are exchangeable, and only their ratios count.
  Guidance exchanged = guidance;
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    const double length = 1.0 + static_cast<double>(i % 5);
    guidance.Weights.push_back(7.0 * length);
    exchanged.Vectors[i] *= 1e-200 * length;
  }
  options.AlignmentStrength = 0.5;
  const Result weighted = field.Compute(options, guidance);
  const Result longer = field.Compute(options, exchanged);
  for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
  {
    EXPECT_NEAR(PhaseDifference(weighted, longer, i), 0.0, 1e-8);
  }
  // Bad entries count as none.
  Guidance bad = guidance;
  Guidance without = guidance;
  bad.Vectors[3].x() = std::numeric_limits<double>::quiet_NaN();
  bad.Weights[4] = -1.0;
  bad.Weights[5] = std::numeric_limits<double>::infinity();
  without.Weights[3] = without.Weights[4] = without.Weights[5] = 0.0;
  EXPECT_EQ(
    field.Compute(options, bad).Representation, field.Compute(options, without).Representation);
}

TEST(Alignment, ExtremeWeightsAndShiftsTendToTheirLimits)
{
  const Surface surface = Potato(2);
  DirectionField field(surface);
  Options options;
  options.Alignment = Alignment::PointVectors;
  options.AlignmentStrength = 0.9;
  Guidance guidance = SpatialVectors(surface);
  const Result plain = field.Compute(options, guidance);
  for (const double weight : { 1e-320, 1e-300, 1e-160, 1e160, 1e308 })
  {
    guidance.Weights.assign(surface.Points.size(), weight);
    const Result weighted = field.Compute(options, guidance);
    EXPECT_EQ(weighted.SingularityIndex, plain.SingularityIndex);
    for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
    {
      EXPECT_NEAR(PhaseDifference(plain, weighted, i), 0.0, 1e-6) << weight;
    }
  }
  for (const bool constrained : { false, true })
  {
    options.ConstrainSharpEdges = constrained;
    options.FeatureAngle = 20.0;
    options.UseShift = false;
    options.AlignmentStrength = 1.0;
    const Result limit = field.Compute(options, guidance);
    options.UseShift = true;
    for (const double shift : { 1e20, 1e80, 1e158, 1e300 })
    {
      options.Shift = shift;
      const Result result = field.Compute(options, guidance);
      EXPECT_TRUE(result.Components[0].Converged);
      for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
      {
        EXPECT_NEAR(PhaseDifference(limit, result, i), 0.0, 1e-6) << shift;
      }
    }
  }
}

TEST(Alignment, ZeroGuidanceChangesNothingAndSaysSo)
{
  const Surface surface = Potato(2);
  DirectionField field(surface);
  Options options;
  const Result plain = field.Compute(options);
  EXPECT_TRUE(plain.Notes.empty());
  options.Alignment = Alignment::PointVectors;
  Guidance guidance;
  guidance.Vectors.assign(surface.Points.size(), Vector3::Zero());
  const Result result = field.Compute(options, guidance);
  EXPECT_EQ(result.Representation, plain.Representation);
  ASSERT_EQ(result.Notes.size(), 1u);
  options.ConstrainGuidance = true;
  EXPECT_EQ(field.Compute(options, guidance).Notes.size(), 2u);
  EXPECT_EQ(field.Compute(options, guidance).Representation, plain.Representation);
  // A flat surface has no curvature to follow.
  const Result flat = DirectionField(Disk(5)).Compute(CurvatureAligned(4, 0.5));
  EXPECT_EQ(flat.Notes.size(), 1u);
}

TEST(Alignment, RefusesWhatMakesNoSense)
{
  const Surface surface = Tetrahedron();
  DirectionField field(surface);
  for (const int degree : { 1, 3, 6 })
  {
    EXPECT_THROW(field.Compute(CurvatureAligned(degree, 0.5)), std::invalid_argument);
    Options constrained;
    constrained.Degree = degree;
    constrained.ConstrainCurvature = true;
    EXPECT_THROW(field.Compute(constrained), std::invalid_argument);
  }
  Options options;
  options.Alignment = Alignment::PointVectors;
  EXPECT_THROW(field.Compute(options), std::invalid_argument);
  EXPECT_THROW(field.Compute(options, { { Vector3::UnitX() }, {} }), std::invalid_argument);
  const std::vector<Vector3> vectors(4, Vector3::UnitX());
  EXPECT_THROW(field.Compute(options, { vectors, { 1.0 } }), std::invalid_argument);
  EXPECT_NO_THROW(field.Compute(options, { vectors, {} }));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : { -0.1, 1.1, nan })
  {
    Options wrong;
    wrong.AlignmentStrength = bad;
    EXPECT_THROW(field.Compute(wrong), std::invalid_argument);
  }
  Options shift;
  shift.Shift = -1.0;
  EXPECT_THROW(field.Compute(shift), std::invalid_argument);
}

TEST(Alignment, ChangingTheStrengthKeepsTheEigenpair)
{
  DirectionField field(Potato(3));
  int calls = 0;
  const auto count = [&](double)
  {
    ++calls;
    return true;
  };
  field.Compute(CurvatureAligned(4, 0.5), {}, count);
  const int first = calls;
  calls = 0;
  field.Compute(CurvatureAligned(4, 0.6), {}, count);
  EXPECT_GT(first, calls + 5);
  // Changing an option that the energy depends on computes it anew, and back.
  const Result other = field.Compute(CurvatureAligned(2, 0.6));
  EXPECT_EQ(other.Degree, 2);
  const Result back = field.Compute(CurvatureAligned(4, 0.6));
  EXPECT_EQ(back.Representation,
    DirectionField(Potato(3)).Compute(CurvatureAligned(4, 0.6)).Representation);
}
