// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
Result UnitField(const Surface& surface, int degree, double bias = 0.0)
{
  Options options;
  options.Degree = degree;
  options.UnitLength = true;
  options.EnergyBias = bias;
  return DirectionField(surface).Compute(options);
}

/// The same surface, seen from the other side.
Surface TurnedRound(Surface surface)
{
  for (Triangle& triangle : surface.Triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
  return surface;
}
}

/// Without singularities all phases have one energy: the directions run around the hole, in which the torus is bent
/// least, from whichever side it is seen, and not the way that is closest to the x axis, near which that of the
/// torus lies.
TEST(FreePhase, LinesRunAroundATorusInTheDirectionInWhichItIsBentLeast)
{
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.25, Vector3::UnitY()).toRotationMatrix();
  const Surface torus = Transformed(Torus(60, 24, 1.0, 0.3), turn, Vector3(1.0, 2.0, 3.0));
  for (const Surface& surface : { torus, TurnedRound(torus) })
  {
    const Result field = UnitField(surface, 2);
    ASSERT_TRUE(std::all_of(field.SingularityIndex.begin(), field.SingularityIndex.end(),
      [](int index) { return index == 0; }));
    double sum = 0.0;
    for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
    {
      const Vector3 axis = turn.col(2);
      sum += Deviation(field, i, axis.cross(surface.Points[i] - Vector3(1.0, 2.0, 3.0)));
    }
    EXPECT_LT(sum / static_cast<double>(surface.Points.size()), 1.0);
  }
}

/// On spheres and planes no phase is better than another one: it is that of the smoothest field.
TEST(FreePhase, StaysWhereTheShapeDoesNotTell)
{
  for (const Surface& surface : { Transformed(Square(12), ObliqueRotation(0.6), Vector3::Zero()),
         Transformed(Jittered(Square(12), 1e-6, 1), ObliqueRotation(0.6), Vector3::Zero()) })
  {
    Options options;
    options.Degree = 4;
    const Result smoothest = DirectionField(surface).Compute(options);
    const Result unit = UnitField(surface, 4);
    for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
    {
      EXPECT_LT(Deviation(unit, i, smoothest.Direction(i, 0)), 1e-3);
    }
  }
}

/// On a boundary without constraints, too, whatever the energy there.
TEST(FreePhase, OneDirectionOfEachKindRunsAlongACylinder)
{
  const Eigen::Matrix3d turn = ObliqueRotation(0.6);
  const Surface surface = Transformed(Cylinder(40, 20, 2.0), turn, Vector3::Zero());
  for (const int degree : { 2, 4, 6, 8 })
  {
    for (const double bias : { 0.0, 0.5 })
    {
      const Result field = UnitField(surface, degree, bias);
      double sum = 0.0;
      for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
      {
        sum += Deviation(field, i, turn.col(2));
      }
      EXPECT_LT(sum / static_cast<double>(surface.Points.size()), 0.1) << degree << ' ' << bias;
      EXPECT_LE(field.Components[0].UnitEnergyAfter, field.Components[0].UnitEnergyBefore + 1e-9);
    }
  }
}
