// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Meshes/Surfaces.h"
#include "Meshes/System.h"
#include "UnitLength/UnitLengthProblem.h"

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
/// An icosphere with bumps, which has no symmetries.
Surface Bumpy(int levels)
{
  Surface surface = Icosphere(levels);
  for (Vector3& p : surface.Points)
  {
    p *= 1.0 + 0.35 * std::sin(3.0 * p.x() + 1.0) * std::sin(2.0 * p.y()) * std::cos(2.5 * p.z());
  }
  return surface;
}

Result Compute(const Surface& surface, int degree, int starts, double cost = 0.0, int threads = 0)
{
  Options options;
  options.Degree = degree;
  options.UnitLength = true;
  options.NumberOfStarts = starts;
  options.SingularityCost = cost;
  options.NumberOfThreads = threads;
  return DirectionField(surface).Compute(options);
}

/// Energy and cost of a field of one component.
double Price(const Result& result, double cost)
{
  double count = 0.0;
  for (const int index : result.SingularityIndex)
  {
    count += std::abs(index);
  }
  return result.Components[0].UnitEnergyAfter + cost * 2.0 * Pi * std::log(2.0) * count;
}
}

TEST(Starts, SmallSurfacesHaveTheLeastEnergyOfHundredsOfStarts)
{
  for (const Surface& surface : { Tetrahedron(), Cube(), Icosphere(0), Icosphere(1), Bumpy(1) })
  {
    for (const int degree : { 1, 2, 3, 4 })
    {
      const double least = Price(Compute(surface, degree, 300), 0.0);
      EXPECT_LE(Price(Compute(surface, degree, 0), 0.0), 1.01 * least)
        << surface.Points.size() << " points, degree " << degree;
    }
  }
  // One start, that of the smoothest field, ends a tenth above.
  EXPECT_GE(
    Price(Compute(Icosphere(1), 2, 1), 0.0), 1.05 * Price(Compute(Icosphere(1), 2, 0), 0.0));
}

TEST(Starts, OfATetrahedronNoOtherUnitFieldHasLessEnergy)
{
  // With y_i = Re conj(u_i) (K u)_i, each v with |v_i| = 1 has v^* K v = sum y + v^* (K - diag y) v,
  // and the sum is u^* K u. So u is a global minimum where K - diag y has no negative eigenvalue.
  for (const int degree : { 1, 2, 4 })
  {
    const System system(Tetrahedron(), degree, 0.0);
    const SparseMatrix energy = Internal::UnitEnergyMatrix(
      system, system.Mesh.GetComponents()[0], degree, 0.0, system.Matrices.Energy);
    const Result result = Compute(Tetrahedron(), degree, 0);
    ComplexVector u(system.Mesh.GetNumberOfVertices());
    for (Index v = 0; v < u.size(); ++v)
    {
      u[v] = result.Representation[system.Mesh.Point(v)];
    }
    const ComplexVector gradient = energy * u;
    Eigen::MatrixXcd certificate = energy;
    double sum = 0.0;
    for (Eigen::Index v = 0; v < u.size(); ++v)
    {
      const double y = (std::conj(u[v]) * gradient[v]).real();
      certificate(v, v) -= y;
      sum += y;
    }
    const double lowest =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd>(certificate).eigenvalues()[0];
    EXPECT_NEAR(sum, result.Components[0].UnitEnergyAfter, 1e-9 * sum);
    EXPECT_GE(lowest, -1e-3 * sum / static_cast<double>(u.size())) << degree;
  }
}

TEST(Starts, MoreNeverMakeItWorse)
{
  double logarithm = 0.0;
  for (const double cost : { 0.0, 1.0 })
  {
    for (const int degree : { 1, 2, 4, 6 })
    {
      double before = Price(Compute(Bumpy(3), degree, 1, cost), cost);
      const double one = before;
      for (const int starts : { 2, 4, 12 })
      {
        const double price = Price(Compute(Bumpy(3), degree, starts, cost), cost);
        EXPECT_LE(price, before + 1e-9) << degree << " " << starts;
        before = price;
      }
      logarithm += std::log(before / one);
    }
  }
  EXPECT_LT(logarithm / 8.0, -0.002);
}

TEST(Starts, GiveAValidFieldOnOneSidedSurfacesAndWithGivenValues)
{
  for (const Surface& surface : { KleinBottle(16, 10), ProjectivePlane(2) })
  {
    const Result one = Compute(surface, 4, 1);
    const Result several = Compute(surface, 4, 6);
    EXPECT_LE(several.Components[0].UnitEnergyAfter, one.Components[0].UnitEnergyAfter + 1e-9);
    EXPECT_EQ(several.Components[0].IndexSum, one.Components[0].IndexSum);
  }
  Options options;
  options.UnitLength = true;
  options.ConstrainBoundary = true;
  options.NumberOfStarts = 1;
  const Result one = DirectionField(Disk(10)).Compute(options);
  options.NumberOfStarts = 8;
  const Result several = DirectionField(Disk(10)).Compute(options);
  EXPECT_LE(several.Components[0].UnitEnergyAfter, one.Components[0].UnitEnergyAfter + 1e-9);
  int constrained = 0;
  for (std::size_t v = 0; v < one.Representation.size(); ++v)
  {
    if (one.Constraint[v] != ConstraintKind::None)
    {
      EXPECT_EQ(several.Representation[v], one.Representation[v]);
      ++constrained;
    }
  }
  EXPECT_GT(constrained, 0);
}

TEST(Starts, AreTheSameForAnyNumberOfThreads)
{
  EXPECT_EQ(
    Compute(Bumpy(2), 4, 8, 0.0, 1).Representation, Compute(Bumpy(2), 4, 8, 0.0, 3).Representation);
}
