// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/Surfaces.h"
#include "Meshes/System.h"
#include "Solvers/Systems/MassSystem.h"

#include <gtest/gtest.h>

using namespace DirectionFields;
using namespace Meshes;

TEST(MassSystem, IsSolvedToAllDigitsOnAnyTriangles)
{
  const Eigen::Vector3d squeezed(0.002, 1.0, 1.0);
  for (const Surface& surface :
    { Potato(5), Transformed(Hemisphere(4), squeezed.asDiagonal(), Vector3::Zero()) })
  {
    const System system(surface, 2, 0.0);
    const ComplexVector expected = RandomVector(system.Matrices.Mass.cols(), 1);
    const ComplexVector b = system.Matrices.Mass * expected;
    const ComplexVector x = SolveMass(system.Matrices, b);
    EXPECT_LE((system.Matrices.Mass * x - b).norm(), 3e-14 * b.norm());
  }
}

TEST(MassSystem, ZeroGivesZero)
{
  const System system(Icosahedron(), 2, 0.0);
  const ComplexVector zero = ComplexVector::Zero(system.Matrices.Mass.cols());
  EXPECT_EQ(SolveMass(system.Matrices, zero), zero);
}
