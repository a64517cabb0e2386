// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/SmoothestField.h"
#include "Drawing/Stripes/Patterns.h"
#include "Meshes/DenseAlgebra.h"
#include "Stripes/PhaseDiffusion.h"
#include "Stripes/PhaseSmoothing.h"
#include "Stripes/StripeLevels.h"
#include "Stripes/StripeMatrices.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

using namespace DirectionFields;
using namespace DirectionFields::Internal;
using namespace Patterns;

namespace
{
/// A field and the steps that stripes of a spacing want on it.
struct Wanted
{
  Wanted(const Surface& surface, const PointDirections& directions, double spacing,
    StripeDirection direction = StripeDirection::Along)
    : Field(surface, directions)
    , Phases(Field, direction, [spacing](Index) { return 1.0 / spacing; })
  {
  }
  GivenField Field;
  WantedPhases Phases;
};

/// Phases over all nodes from a section for each component.
template <typename Section>
std::vector<double> PhasesOf(const WantedPhases& wanted, const Section& section)
{
  std::vector<double> phases;
  for (const WantedPhases::Component& component : wanted.GetComponents())
  {
    const PhaseDiffusion relaxation(wanted, component);
    const std::vector<double> own = relaxation.Phases(section(relaxation));
    phases.insert(phases.end(), own.begin(), own.end());
  }
  return phases;
}

std::vector<double> Relaxed(const WantedPhases& wanted)
{
  return PhasesOf(wanted,
    [](const PhaseDiffusion& relaxation)
    {
      ComplexVector psi = relaxation.Start();
      relaxation.Relax({}, psi);
      return psi;
    });
}

/// The phases of the smallest eigenvector, on two sheets as symmetric as can be.
std::vector<double> OfTheEigenvector(const WantedPhases& wanted)
{
  return PhasesOf(wanted,
    [&](const PhaseDiffusion& relaxation)
    {
      EigenpairSettings settings;
      settings.Scale = relaxation.GetDensity();
      SmallestPairs pairs = FindSmallestPairs(
        relaxation.GetMatrices(), [&] { return relaxation.Start(); }, Solver::Direct, settings, {});
      ComplexVector psi = std::move(pairs.First.Vector);
      if (wanted.GetComponents()[0].HasTwoSheets)
      {
        ComplexVector mirrored(psi.size());
        for (Index v = 0; v < psi.size(); ++v)
        {
          mirrored[v] = std::conj(psi[v ^ 1]);
        }
        psi *= std::polar(1.0, 0.5 * std::arg(psi.dot(mirrored)));
      }
      return psi;
    });
}
}

TEST(WantedPhases, AreTheDifferencesOfALinearFunctionOnThePlane)
{
  const Surface square = Meshes::Square(9, 2.0);
  for (const StripeDirection direction : { StripeDirection::Along, StripeDirection::Across })
  {
    const double angle = 0.7;
    const Wanted wanted(square,
      Fields::PlanarField(square, 1, [=](const Vector3&) { return angle; }), 0.3, direction);
    const double turned = angle + (direction == StripeDirection::Along ? 0.5 * Pi : 0.0);
    const Vector3 gradient = Vector3(std::cos(turned), std::sin(turned), 0.0) / 0.3;
    const TriangleMesh& mesh = wanted.Phases.GetMesh();
    for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      const Vector3 edge =
        square.Points[mesh.Point(mesh.Head(h))] - square.Points[mesh.Point(mesh.Tail(h))];
      EXPECT_NEAR(wanted.Phases.Along(h).Increment, gradient.dot(edge), 1e-12);
    }
  }
}

TEST(WantedPhases, AreTheSameFromBothSidesOfAnEdgeAndFlipAroundOddSingularities)
{
  const Surface surface = Meshes::Potato(4);
  const Result result = Fields::Compute(surface, 2);
  const Wanted wanted(surface, Fields::Of(result), 0.2);
  const TriangleMesh& mesh = wanted.Phases.GetMesh();
  for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const WantedPhases::Step there = wanted.Phases.Along(h);
    const WantedPhases::Step back = wanted.Phases.Along(mesh.Twin(h));
    EXPECT_EQ(there.Flips, back.Flips);
    EXPECT_EQ(there.Increment, there.Flips ? back.Increment : -back.Increment);
  }
  const std::vector<int> indices = wanted.Field.Indices();
  int odd = 0;
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    EXPECT_EQ(wanted.Phases.Around(t).Flips, indices[t] % 2 != 0);
    odd += indices[t] % 2 != 0 ? 1 : 0;
  }
  EXPECT_EQ(odd, 4);
  EXPECT_TRUE(wanted.Phases.GetComponents()[0].HasTwoSheets);
}

TEST(WantedPhases, OfVectorFieldsHaveNoFluxInAll)
{
  for (const Surface& surface : { Meshes::Icosphere(3), Meshes::Torus(32, 16) })
  {
    const Result result = Fields::Compute(surface, 1);
    const Wanted wanted(surface, Fields::Of(result), 0.2);
    double sum = 0.0;
    double most = 0.0;
    for (Index t = 0; t < wanted.Phases.GetMesh().GetNumberOfTriangles(); ++t)
    {
      sum += wanted.Phases.Around(t).Sum;
      most = std::max(most, std::abs(wanted.Phases.Around(t).Sum));
    }
    EXPECT_GT(most, 1e-3);
    EXPECT_NEAR(sum, 0.0, 1e-10);
    EXPECT_FALSE(wanted.Phases.GetComponents()[0].HasTwoSheets);
  }
}

TEST(WantedPhases, OfALineFieldThatCanBeOrientedFlipNowhere)
{
  const Surface torus = Meshes::Torus(32, 16);
  const Wanted vectors(torus, East(torus), 0.2);
  const Wanted lines(torus, AsLineField(East(torus)), 0.2);
  EXPECT_FALSE(lines.Phases.GetComponents()[0].HasTwoSheets);
  const TriangleMesh& mesh = lines.Phases.GetMesh();
  const double sign = lines.Phases.Gradient(0).dot(vectors.Phases.Gradient(0)) > 0.0 ? 1.0 : -1.0;
  for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    EXPECT_FALSE(lines.Phases.Along(h).Flips);
    EXPECT_NEAR(lines.Phases.Along(h).Increment, sign * vectors.Phases.Along(h).Increment, 1e-12);
  }
}

TEST(StripeMatrices, AreHermitianAndCommuteWithTheChangeOfSheets)
{
  const Surface surface = Meshes::Potato(2);
  const Result result = Fields::Compute(surface, 2);
  const Wanted wanted(surface, Fields::Of(result), 0.3);
  const Operators matrices =
    AssembleStripeMatrices(wanted.Phases, wanted.Phases.GetComponents()[0]);
  const auto rows = static_cast<Index>(matrices.Energy.rows());
  ASSERT_EQ(rows, 2 * wanted.Phases.GetNumberOfNodes());
  for (const SparseMatrix& matrix : { matrices.Energy, matrices.Mass })
  {
    const Eigen::MatrixXcd dense(matrix);
    EXPECT_LT((dense - dense.adjoint()).norm(), 1e-12 * dense.norm());
    Eigen::MatrixXcd swapped(rows, rows);
    for (Index i = 0; i < rows; ++i)
    {
      for (Index j = 0; j < rows; ++j)
      {
        swapped(i, j) = std::conj(dense(i ^ 1, j ^ 1));
      }
    }
    EXPECT_EQ((dense - swapped).norm(), 0.0);
  }
  const Eigen::VectorXd energies = Meshes::DenseEigenvalues(Eigen::MatrixXcd(matrices.Energy));
  const Eigen::VectorXd masses = Meshes::DenseEigenvalues(Eigen::MatrixXcd(matrices.Mass));
  EXPECT_GT(energies.minCoeff(), -1e-12);
  EXPECT_GT(masses.minCoeff(), 1e-3 * masses.maxCoeff());
}

TEST(StripeMatrices, HaveNoEnergyForThePhasesThatAreWanted)
{
  const Surface square = Meshes::Square(8);
  const Wanted wanted(
    square, Fields::PlanarField(square, 1, [](const Vector3&) { return 0.0; }), 0.07);
  const Operators matrices =
    AssembleStripeMatrices(wanted.Phases, wanted.Phases.GetComponents()[0]);
  ComplexVector psi(wanted.Phases.GetNumberOfNodes());
  for (Index v = 0; v < psi.size(); ++v)
  {
    const Index point = wanted.Phases.GetMesh().Point(wanted.Phases.Vertex(v));
    psi[v] = std::polar(1.0, 2.0 * Pi * square.Points[point].y() / 0.07);
  }
  EXPECT_LT((matrices.Energy * psi).norm(), 1e-11);
  // Sections of modulus 1 have the area for their mass, in the unit of the mean edge.
  const SurfaceGeometry& geometry = wanted.Field.GetGeometry();
  EXPECT_NEAR(psi.dot(matrices.Mass * psi).real(), geometry.Lengths.ComponentArea[0], 1e-9 * 64.0);
}

TEST(PhaseDiffusion, MissesLessThanTheSmallestEigenvector)
{
  const auto check = [](const Wanted& wanted, double atMost)
  {
    const double relaxed = Misfit(wanted.Phases, Relaxed(wanted.Phases));
    const double eigenvector = Misfit(wanted.Phases, OfTheEigenvector(wanted.Phases));
    EXPECT_LT(relaxed, eigenvector);
    EXPECT_LT(relaxed, atMost);
  };
  const Surface sphere = Meshes::Icosphere(4);
  check({ sphere, East(sphere), 1.0 / 3.0, StripeDirection::Across }, 0.42);
  check({ sphere, East(sphere), 1.0 / 6.0, StripeDirection::Across }, 0.29);
  const Surface torus = Meshes::Torus(64, 32);
  check({ torus, East(torus), 0.5, StripeDirection::Across }, 0.36);
  const Surface potato = Meshes::Potato(4);
  for (const int degree : { 1, 2 })
  {
    const Result result = Fields::Compute(potato, degree);
    check({ potato, Fields::Of(result), 1.0 / 3.0 }, 0.44);
    check({ potato, Fields::Of(result), 1.0 / 6.0 }, 0.30);
  }
}

TEST(PhaseDiffusion, MissesLittleOfWhatIntegrates)
{
  const Surface torus = Meshes::Torus(96, 48);
  const Wanted wanted(torus, East(torus), 0.25);
  EXPECT_LT(Misfit(wanted.Phases, Relaxed(wanted.Phases)), 0.02);
  // Phases at random miss all.
  const std::vector<double> random =
    PhasesOf(wanted.Phases, [](const PhaseDiffusion& relaxation) { return relaxation.Start(); });
  EXPECT_GT(Misfit(wanted.Phases, random), 1.0);
}

TEST(PhaseSmoothing, LowersTheMisfitAndKeepsTheBranchPoints)
{
  const Surface potato = Meshes::Potato(5);
  for (const int degree : { 1, 2 })
  {
    const Result result = Fields::Compute(potato, degree);
    const Wanted wanted(potato, Fields::Of(result), 0.2);
    const std::vector<double> relaxed = Relaxed(wanted.Phases);
    std::vector<double> smooth = relaxed;
    SmoothPhases(wanted.Phases, wanted.Phases.GetComponents()[0], {}, smooth);
    EXPECT_LT(Misfit(wanted.Phases, smooth), 0.98 * Misfit(wanted.Phases, relaxed));
    const auto branchPoints = [&](const std::vector<double>& phases)
    {
      const StripePhases steps(wanted.Phases, phases, 0.0);
      const StripeLevels levels(steps, LevelKind::Lines);
      int count = 0;
      for (Index t = 0; t < wanted.Phases.GetMesh().GetNumberOfTriangles(); ++t)
      {
        const StripeLevels::Corners corners = levels.At(t);
        count += !corners.Flips && corners.Gain() != 0 ? 1 : 0;
      }
      return count;
    };
    EXPECT_NEAR(branchPoints(smooth), branchPoints(relaxed), 2);
    // Phases that are as smooth as can be stay.
    std::vector<double> twice = smooth;
    SmoothPhases(wanted.Phases, wanted.Phases.GetComponents()[0], {}, twice);
    EXPECT_NEAR(Misfit(wanted.Phases, twice), Misfit(wanted.Phases, smooth), 0.01);
  }
}

TEST(PhaseSmoothing, FindsThePhasesOfWhatIntegrates)
{
  const Surface square = Meshes::Square(12);
  const Wanted wanted(
    square, Fields::PlanarField(square, 2, [](const Vector3&) { return 0.4; }), 0.3);
  std::vector<double> phases = Relaxed(wanted.Phases);
  const double relaxed = Misfit(wanted.Phases, phases);
  SmoothPhases(wanted.Phases, wanted.Phases.GetComponents()[0], {}, phases);
  EXPECT_LT(Misfit(wanted.Phases, phases), 0.1 * relaxed);
}
