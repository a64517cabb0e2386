// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Geometry/SurfaceGeometry.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <utility>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
Options Unit(int degree, double cost = 0.0)
{
  Options options;
  options.Degree = degree;
  options.UnitLength = true;
  options.SingularityCost = cost;
  return options;
}

Result Compute(const Surface& surface, const Options& options)
{
  return DirectionField(surface).Compute(options);
}

Options Without(Options options)
{
  options.UnitLength = false;
  return options;
}

int CountSingularities(const Result& result)
{
  int count = 0;
  for (const int index : result.SingularityIndex)
  {
    count += std::abs(index);
  }
  return count;
}

/// The energy of differences along the edges, computed from angles and cotangents alone. The surface must be a
/// manifold that can be oriented.
double DifferenceEnergy(const Surface& surface, const Result& result)
{
  const SurfaceGeometry geometry(surface);
  const TriangleMesh& mesh = geometry.Mesh;
  double energy = 0.0;
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = mesh.HalfEdge(e);
    double weight = 0.0;
    for (const Index side : { h, mesh.Twin(h) })
    {
      weight += side == None
        ? 0.0
        : 0.5 / std::tan(geometry.Lengths.CornerAngle(mesh, TriangleMesh::Previous(side)));
    }
    const double angle = std::arg(result.Representation[mesh.Point(mesh.Head(h))]) -
      std::arg(result.Representation[mesh.Point(mesh.Tail(h))]) -
      result.Degree * geometry.Transport.Rotation[e];
    energy += std::max(0.0, weight) * (2.0 - 2.0 * std::cos(angle));
  }
  return energy;
}

Vector3 Centre(const Surface& surface, std::size_t triangle)
{
  const Triangle& t = surface.Triangles[triangle];
  return (surface.Points[t[0]] + surface.Points[t[1]] + surface.Points[t[2]]) / 3.0;
}

/// A closed surface with knobs all over it.
Surface Knobbly(int levels)
{
  Surface surface = Icosphere(levels);
  for (Vector3& p : surface.Points)
  {
    p *= 1.0 + 0.12 * std::sin(7.0 * p.x()) * std::sin(8.0 * p.y() + 1.0) +
      0.1 * std::sin(9.0 * p.z());
  }
  return surface;
}
}

TEST(UnitLengthField, AllValuesHaveTheLengthOneAndTheIndicesSumUp)
{
  for (const Surface& surface : { Knobbly(3), Torus(40, 20), DoubleTorus(), Hemisphere(2),
         KleinBottle(30, 16), ProjectivePlane(2),
         Joined(Potato(2), Transformed(Disk(4), 3.0 * Eigen::Matrix3d::Identity(), { 9, 0, 0 })) })
  {
    for (const int degree : { 1, 2, 3, 4, 6 })
    {
      const Result result = Compute(surface, Unit(degree));
      for (const Complex& u : result.Representation)
      {
        ASSERT_NEAR(std::abs(u), 1.0, 1e-12);
      }
      for (const ComponentReport& report : result.Components)
      {
        EXPECT_TRUE(report.Converged);
        if (report.Closed)
        {
          EXPECT_EQ(report.IndexSum, degree * report.EulerCharacteristic);
        }
      }
    }
  }
}

TEST(UnitLengthField, IsNeverWorseThanTheFieldThatItStartsFrom)
{
  for (const Surface& surface :
    { Knobbly(3), Torus(30, 16), Hemisphere(3), Disk(8), KleinBottle(24, 12), BadSphere(2, 0.1, 1),
      Jittered(Potato(3), 0.1, 2), Tetrahedron(), Cube() })
  {
    for (const double bias : { -1.0, -0.4, 0.0, 0.4, 1.0 })
    {
      Options options = Unit(4);
      options.EnergyBias = bias;
      for (const ComponentReport& report : Compute(surface, options).Components)
      {
        EXPECT_LE(report.UnitEnergyAfter, report.UnitEnergyBefore + 1e-9) << bias;
      }
    }
  }
}

TEST(UnitLengthField, HasMuchLessEnergyAndFewerSingularitiesThanTheEigenvectorsDirections)
{
  double logarithm = 0.0;
  int before = 0;
  int after = 0;
  int dear = 0;
  int count = 0;
  for (const Surface& surface :
    { Knobbly(4), Jittered(Knobbly(4), 0.02, 1), Jittered(Knobbly(4), 0.03, 5) })
  {
    for (const int degree : { 2, 4, 6 })
    {
      const Result start = Compute(surface, Without(Unit(degree)));
      const Result unit = Compute(surface, Unit(degree));
      const Result fewer = Compute(surface, Unit(degree, 1.0));
      const double ratio = DifferenceEnergy(surface, unit) / DifferenceEnergy(surface, start);
      EXPECT_LT(ratio, 0.85) << degree;
      EXPECT_LT(DifferenceEnergy(surface, fewer), DifferenceEnergy(surface, start));
      logarithm += std::log(ratio);
      ++count;
      before += CountSingularities(start);
      after += CountSingularities(unit);
      dear += CountSingularities(fewer);
    }
  }
  EXPECT_LT(std::exp(logarithm / count), 0.71);
  EXPECT_LT(after, 0.6 * before);
  EXPECT_LT(dear, 0.5 * before);
}

TEST(UnitLengthField, ATorusNeedsNoSingularitiesAndGetsNone)
{
  for (const Surface& surface :
    { Torus(60, 30), Torus(90, 30, 3.0, 1.0), Jittered(Torus(60, 30), 0.02, 3) })
  {
    for (const int degree : { 1, 2 })
    {
      EXPECT_EQ(CountSingularities(Compute(surface, Unit(degree))), 0);
    }
  }
}

TEST(UnitLengthField, WhatSingularitiesCostIsPaidOnlyWhereItPaysOff)
{
  const double unit = 2.0 * Pi * std::log(2.0);
  const Surface surface = Torus(60, 30);
  const Result dear = Compute(surface, Unit(4, 1.0));
  const Result cheap = Compute(surface, Unit(4));
  EXPECT_LE(2 * CountSingularities(dear), CountSingularities(cheap));
  EXPECT_LT(dear.Components[0].UnitEnergyAfter + unit * CountSingularities(dear),
    cheap.Components[0].UnitEnergyAfter + unit * CountSingularities(cheap));
}

TEST(UnitLengthField, ASphereKeepsTheSingularitiesThatItNeeds)
{
  for (const int degree : { 1, 2, 3, 4, 6 })
  {
    const Result result = Compute(Icosphere(3), Unit(degree));
    EXPECT_EQ(CountSingularities(result), 2 * degree);
  }
}

/// With the boundary given, the representation of degree 4 turns four times around the disk. The singularities of
/// Ginzburg-Landau theory are at the radius (3/11)^(1/8), in the corners of a square. On finer and on uneven
/// triangles they are not farther from there: linear systems have them in the middle, and descent leaves each in
/// its triangle.
TEST(UnitLengthField, ADiskAlongItsBoundaryHasFourSingularitiesWhereTheyBelong)
{
  const double radius = std::pow(3.0 / 11.0, 0.125);
  const auto uneven = [](const Surface& disk, double length)
  {
    Surface moved = Jittered(disk, length, 1);
    for (std::size_t i = 0; i < moved.Points.size(); ++i)
    {
      const bool isInside = disk.Points[i].norm() < 1.0 - 1e-9;
      moved.Points[i] =
        isInside ? Vector3(moved.Points[i].x(), moved.Points[i].y(), 0.0) : disk.Points[i];
    }
    return moved;
  };
  for (const Surface& surface :
    { Disk(20), Disk(40), Disk(80), uneven(Disk(40), 0.3 / 40.0), uneven(Disk(80), 0.3 / 80.0) })
  {
    Options options = Unit(4);
    options.ConstrainBoundary = true;
    const Result result = Compute(surface, options);
    std::vector<double> angles;
    double mean = 0.0;
    for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
    {
      if (result.SingularityIndex[t] != 0)
      {
        EXPECT_EQ(result.SingularityIndex[t], 1);
        const Vector3 place = Centre(surface, t);
        EXPECT_NEAR(place.norm(), radius, 0.1 * radius);
        mean += 0.25 * place.norm();
        angles.push_back(std::atan2(place.y(), place.x()));
      }
    }
    EXPECT_NEAR(mean, radius, 0.03 * radius);
    ASSERT_EQ(angles.size(), 4u);
    std::sort(angles.begin(), angles.end());
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(angles[k + 1] - angles[k], 0.5 * Pi, 0.3);
    }
  }
}

TEST(UnitLengthField, GivenValuesStayToTheLastBit)
{
  for (const int degree : { 1, 2, 4 })
  {
    Options options = Unit(degree);
    options.ConstrainBoundary = true;
    const Surface surface = PlateWithHole(48, 12, 0.5, true);
    const Result unit = Compute(surface, options);
    const Result linear = Compute(surface, Without(options));
    ASSERT_EQ(unit.Constraint, linear.Constraint);
    Index given = 0;
    for (std::size_t i = 0; i < surface.Points.size(); ++i)
    {
      if (unit.Constraint[i] != ConstraintKind::None)
      {
        ++given;
        for (int k = 0; k < degree; ++k)
        {
          // The linear solution is scaled as a whole, which may round its phase.
          EXPECT_LT(
            (unit.Direction(static_cast<Index>(i), k) - linear.Direction(static_cast<Index>(i), k))
              .norm(),
            1e-12);
        }
      }
    }
    EXPECT_EQ(given, 2 * 48);
  }
}

/// Up to one phase, which is free.
TEST(UnitLengthField, AParallelFieldStaysAsItIs)
{
  for (const Surface& surface : { Square(8), BadSquare(6, 1), Cylinder(24, 6, 1.0), LShape(4) })
  {
    const Result linear = Compute(surface, Without(Unit(4)));
    const Result unit = Compute(surface, Unit(4));
    const Complex phase = unit.Representation[0] / linear.Representation[0];
    for (std::size_t i = 0; i < surface.Points.size(); ++i)
    {
      EXPECT_LT(std::abs(unit.Representation[i] - phase * linear.Representation[i]), 1e-6);
    }
  }
}

/// The part of the energy that the bias changes is the curvature's and the boundary's: on a closed surface it is the
/// same for all sections of modulus 1.
TEST(UnitLengthField, OnClosedSurfacesTheBiasIsAConstant)
{
  const Surface surface = Potato(3);
  Options options = Unit(4);
  std::vector<double> differences;
  for (const double bias : { -0.5, 0.0, 0.5 })
  {
    options.EnergyBias = bias;
    const Result result = Compute(surface, options);
    differences.push_back(result.Components[0].UnitEnergyAfter - DifferenceEnergy(surface, result));
  }
  // 2 pi n chi s, half of which the smoothness energy has: the other half has no bias inside.
  const double expected = 0.5 * 0.5 * 2.0 * Pi * 4 * 2;
  EXPECT_NEAR(differences[0] - differences[1], expected, 0.15 * expected);
  EXPECT_NEAR(differences[1] - differences[2], expected, 0.15 * expected);
}

TEST(UnitLengthField, DoesNotDependOnTheNumberOfThreads)
{
  for (const Surface& surface : { Knobbly(4), KleinBottle(40, 20) })
  {
    Options options = Unit(4, 0.5);
    options.NumberOfThreads = 1;
    const Result one = Compute(surface, options);
    options.NumberOfThreads = 3;
    EXPECT_EQ(Compute(surface, options).Representation, one.Representation);
  }
}

TEST(UnitLengthField, IsTheSameForAnotherScaleAndPlaceOfTheSurface)
{
  const Surface surface = Knobbly(3);
  const Result here = Compute(surface, Unit(4));
  const Surface moved = Transformed(surface, 1024.0 * Eigen::Matrix3d::Identity(), Vector3::Zero());
  const Result there = Compute(moved, Unit(4));
  EXPECT_EQ(here.SingularityIndex, there.SingularityIndex);
  EXPECT_NEAR(there.Components[0].UnitEnergyAfter, here.Components[0].UnitEnergyAfter,
    1e-9 * here.Components[0].UnitEnergyAfter);
}

/// Of the singularities nine of ten stay where they are when the points move a little.
TEST(UnitLengthField, IsStable)
{
  const Surface surface = Knobbly(4);
  const Result result = Compute(surface, Unit(4));
  int matched = 0;
  int all = 0;
  for (const unsigned seed : { 1u, 2u, 3u })
  {
    const Surface jittered = Jittered(surface, 0.003, seed);
    const Result other = Compute(jittered, Unit(4));
    for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
    {
      if (result.SingularityIndex[t] == 0)
      {
        continue;
      }
      ++all;
      bool found = false;
      for (std::size_t o = 0; o < surface.Triangles.size() && !found; ++o)
      {
        // 4 % of the root of the area
        found = other.SingularityIndex[o] == result.SingularityIndex[t] &&
          (Centre(jittered, o) - Centre(surface, t)).norm() < 0.04 * std::sqrt(4.0 * Pi);
      }
      matched += found ? 1 : 0;
    }
  }
  EXPECT_GE(matched, 0.9 * all);
}

/// At the same angle to a guidance the field of unit length bends less.
TEST(UnitLengthField, FollowsAGuidanceWithLessEnergy)
{
  const Surface surface = Knobbly(4);
  for (const int degree : { 1, 2, 4, 6 })
  {
    Guidance guidance;
    std::mt19937 engine(5);
    for (const Vector3& p : surface.Points)
    {
      const auto noise = [&] { return 0.6 * (engine() / 4294967296.0 - 0.5); };
      guidance.Vectors.emplace_back(
        -p.y() + 0.5 * std::sin(3.0 * p.z()) + noise(), p.x() + noise(), 0.3 + noise());
    }
    const auto measure = [&](double strength, bool unit)
    {
      Options options = Unit(degree);
      options.UnitLength = unit;
      options.Alignment = Alignment::PointVectors;
      options.AlignmentStrength = strength;
      const Result result = DirectionField(surface).Compute(options, guidance);
      double angle = 0.0;
      double weight = 0.0;
      for (std::size_t i = 0; i < surface.Points.size(); ++i)
      {
        const Vector3& normal = result.Normal[i];
        const Vector3 tangent = guidance.Vectors[i] - normal.dot(guidance.Vectors[i]) * normal;
        double nearest = Pi;
        for (int k = 0; k < degree; ++k)
        {
          nearest = std::min(nearest,
            std::acos(std::clamp(
              result.Direction(static_cast<Index>(i), k).dot(tangent.normalized()), -1.0, 1.0)));
        }
        angle += tangent.norm() * nearest;
        weight += tangent.norm();
      }
      return std::pair(angle / weight, DifferenceEnergy(surface, result));
    };
    double ratio = 0.0;
    for (const double strength : { 0.3, 0.7 })
    {
      const auto [angle, energy] = measure(strength, false);
      // The strength of the field of unit length at the same angle, by bisection.
      double low = 0.0;
      double high = 1.0;
      for (int step = 0; step < 8; ++step)
      {
        const double middle = 0.5 * (low + high);
        (measure(middle, true).first > angle ? low : high) = middle;
      }
      const auto [reached, less] = measure(high, true);
      ratio += 0.5 * less / energy;
    }
    // A vector field has no needless singularities here that it could lose.
    EXPECT_LT(ratio, degree == 1 ? 1.0 : 0.8) << degree;
  }
}

TEST(UnitLengthField, MovesOfTheStrengthGiveWhatANewFieldGives)
{
  const Surface surface = Knobbly(4);
  Options options = Unit(4);
  options.Alignment = Alignment::PrincipalCurvature;
  DirectionField kept(surface);
  for (const double strength : { 0.3, 0.6, 0.9, 0.3 })
  {
    options.AlignmentStrength = strength;
    const Result moved = kept.Compute(options);
    const Result fresh = Compute(surface, options);
    EXPECT_EQ(moved.SingularityIndex, fresh.SingularityIndex);
    EXPECT_NEAR(moved.Components[0].UnitEnergyAfter, fresh.Components[0].UnitEnergyAfter,
      1e-3 * fresh.Components[0].UnitEnergyAfter);
  }
  options.UnitLength = false;
  options.Alignment = Alignment::None;
  EXPECT_EQ(kept.Compute(options).SingularityIndex, Compute(surface, options).SingularityIndex);
}

TEST(UnitLengthField, ProgressOnlyGrows)
{
  const Surface two =
    Joined(Knobbly(3), Transformed(Knobbly(3), Eigen::Matrix3d::Identity(), { 5, 0, 0 }));
  for (const Alignment alignment : { Alignment::None, Alignment::PrincipalCurvature })
  {
    Options options = Unit(4);
    options.Alignment = alignment;
    double last = 0.0;
    int below = 0;
    DirectionField(two).Compute(options, {},
      [&](double done)
      {
        EXPECT_GE(done, last);
        below += done > 0.66 && done < 1.0 ? 1 : 0;
        last = done;
        return true;
      });
    // The way from the first solution to the directions is part of it.
    EXPECT_GT(below, 4);
    EXPECT_LE(last, 1.0);
  }
}

TEST(UnitLengthField, StopsWhenItIsTold)
{
  const Surface surface = Knobbly(4);
  int calls = 0;
  DirectionField field(surface);
  field.Compute(Without(Unit(4)));
  const Result whole = field.Compute(Unit(4), {},
    [&](double)
    {
      ++calls;
      return true;
    });
  ASSERT_FALSE(whole.Aborted);
  ASSERT_GT(calls, 10);
  for (const int last : { calls / 4, calls / 2, calls - 2 })
  {
    int left = last;
    EXPECT_TRUE(field.Compute(Unit(4), {}, [&](double) { return --left > 0; }).Aborted);
  }
  EXPECT_EQ(field.Compute(Unit(4)).Representation, whole.Representation);
}
