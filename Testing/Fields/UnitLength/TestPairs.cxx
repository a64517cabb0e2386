// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Matrices/OperatorProducts.h"
#include "Meshes/Surfaces.h"
#include "Meshes/System.h"
#include "Sections/Singularities.h"
#include "UnitLength/PairCancellation.h"
#include "UnitLength/PairPatch.h"
#include "UnitLength/PhaseDescent.h"
#include "UnitLength/SingularityMoves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
/// A surface with the problem of its first component.
struct Case : Meshes::System
{
  Case(const Surface& surface, int degree, double bias = 0.0)
    : Meshes::System(surface, degree, bias)
    , Degree(degree)
    , Energy(
        UnitEnergyMatrix(*this, this->Mesh.GetComponents()[0], degree, bias, this->Matrices.Energy))
  {
  }
  UnitLengthProblem Problem() const
  {
    return { *this, *this, this->Mesh.GetComponents()[0], this->Degree, this->Energy,
      this->Matrices.Mass, {}, {} };
  }
  /// The section of a field on a flat surface whose directions have an angle in the plane.
  template <typename Phase>
  ComplexVector Planar(const Phase& phase) const
  {
    ComplexVector u(this->Mesh.GetNumberOfVertices());
    for (Index v = 0; v < u.size(); ++v)
    {
      const Complex axis = this->Frames.Tangential(v, Vector3::UnitX());
      u[v] = std::polar(1.0, phase(this->Positions[v]) + this->Degree * std::arg(axis));
    }
    return u;
  }
  std::vector<int> Indices(const ComplexVector& u) const
  {
    return SingularityIndices(*this, this->Mesh.GetComponents()[0], this->Degree, u.data());
  }
  int Count(const ComplexVector& u) const
  {
    const std::vector<int> indices = this->Indices(u);
    return std::accumulate(
      indices.begin(), indices.end(), 0, [](int sum, int index) { return sum + std::abs(index); });
  }

  int Degree;
  SparseMatrix Energy;
};

/// The phase of a field with a positive singularity here and a negative one there, off the lattice.
double Dipole(const Vector3& p, double distance)
{
  const double y = p.y() - 0.503;
  return std::atan2(y, p.x() - 0.507 + 0.5 * distance) -
    std::atan2(y, p.x() - 0.507 - 0.5 * distance);
}
}

TEST(UnitLengthProblem, OnFlatDelaunayMeshesBothEnergiesAreTheSame)
{
  for (const double bias : { 0.0, -0.7 })
  {
    const Case flat(Square(6), 4, bias);
    EXPECT_LT((flat.Energy - flat.Matrices.Energy).norm(), 1e-12 * flat.Energy.norm());
  }
}

TEST(UnitLengthProblem, TheMatrixIsHermitianWithTheEnergyOfUnitSections)
{
  for (const double bias : { 0.0, 0.6 })
  {
    const Case system(Jittered(Hemisphere(2), 0.05, 3), 4, bias);
    const SparseMatrix adjoint = system.Energy.adjoint();
    EXPECT_LT((adjoint - system.Energy).norm(), 1e-12 * system.Energy.norm());
    const ComplexVector u = RandomVector(system.Energy.rows(), 5);
    // Half of the smoothness energy, and half of the differences along the edges, computed one by one.
    double differences = 0.0;
    for (Index e = 0; e < system.Mesh.GetNumberOfEdges(); ++e)
    {
      const Index h = system.Mesh.HalfEdge(e);
      double weight = 0.0;
      for (const Index side : { h, system.Mesh.Twin(h) })
      {
        weight += side == None
          ? 0.0
          : 0.5 / std::tan(system.Lengths.CornerAngle(system.Mesh, TriangleMesh::Previous(side)));
      }
      const double angle = std::arg(u[system.Mesh.Head(h)]) - std::arg(u[system.Mesh.Tail(h)]) -
        4.0 * system.Transport.Rotation[e];
      differences += std::max(0.0, weight) * (2.0 - 2.0 * std::cos(angle));
      differences -= system.Mesh.Twin(h) == None ? bias * std::sin(angle) : 0.0;
    }
    const double expected = 0.5 * (u.dot(system.Matrices.Energy * u).real() + differences);
    EXPECT_NEAR(system.Problem().Energy(u), expected, 1e-10 * std::abs(expected));
  }
}

TEST(SingularityPairs, PathsLeadFromThePositiveTriangleToTheNegativeOne)
{
  const Case flat(Square(24), 2);
  const ComplexVector u = flat.Planar([](const Vector3& p) { return Dipole(p, 0.4); });
  const std::vector<int> indices = flat.Indices(u);
  ASSERT_EQ(flat.Count(u), 2);
  const UnitLengthProblem problem = flat.Problem();
  const std::vector<SingularityPair> pairs = FindPairs(problem, indices);
  int inside = 0;
  for (const SingularityPair& pair : pairs)
  {
    Index t = pair.From;
    EXPECT_EQ(indices[t], -pair.Change);
    for (const Index h : pair.Crossed)
    {
      ASSERT_EQ(h / 3, t);
      t = flat.Mesh.Twin(h) == None ? None : flat.Mesh.Twin(h) / 3;
    }
    EXPECT_EQ(t, pair.To);
    if (pair.To != None)
    {
      ++inside;
      EXPECT_EQ(indices[pair.To], -1);
      // 0.4 in units of the mean edge length; paths through triangles are some longer.
      const double distance = 0.4 / flat.Lengths.Unit[0];
      EXPECT_GT(pair.Distance, 0.9 * distance);
      EXPECT_LT(pair.Distance, 1.4 * distance);
    }
  }
  EXPECT_EQ(inside, 1);
  EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end(),
    [](const SingularityPair& a, const SingularityPair& b) { return a.Distance < b.Distance; }));
}

TEST(SingularityPairs, AreFoundAcrossNoEdgeWithTwoGivenEnds)
{
  const Case flat(Square(24), 2);
  const ComplexVector u = flat.Planar([](const Vector3& p) { return Dipole(p, 0.4); });
  UnitLengthProblem problem = flat.Problem();
  problem.IsGiven.assign(u.size(), 0);
  for (Index v = 0; v < u.size(); ++v)
  {
    problem.IsGiven[v] = std::abs(flat.Positions[v].x() - 0.5) < 1e-9 ? 1 : 0;
  }
  for (const SingularityPair& pair : FindPairs(problem, flat.Indices(u)))
  {
    EXPECT_EQ(pair.To, None);
  }
}

TEST(PairPatch, TellsHowTheEnergyAndTheIndicesChange)
{
  const Case flat(Square(24), 2);
  ComplexVector u = flat.Planar([](const Vector3& p) { return Dipole(p, 0.25); });
  const UnitLengthProblem problem = flat.Problem();
  PatchNumbers numbers(problem.Rows());
  const std::vector<SingularityPair> pairs = FindPairs(problem, flat.Indices(u));
  const auto pair =
    std::find_if(pairs.begin(), pairs.end(), [](const SingularityPair& p) { return p.To != None; });
  ASSERT_NE(pair, pairs.end());
  double last = std::numeric_limits<double>::infinity();
  for (const Index rings : { 1, 2, 4, 8 })
  {
    PairPatch patch(problem, *pair, rings, numbers);
    patch.Try(u);
    ComplexVector changed = u;
    for (std::size_t k = 0; k < patch.GetVertices().size(); ++k)
    {
      changed[patch.GetVertices()[k]] = patch.GetValues()[k];
      EXPECT_NEAR(std::abs(patch.GetValues()[k]), 1.0, 1e-12);
    }
    EXPECT_NEAR(patch.GetEnergyChange(), problem.Energy(changed) - problem.Energy(u), 1e-9);
    EXPECT_EQ(patch.CountIndexChange(u), flat.Count(changed) - flat.Count(u));
    EXPECT_EQ(patch.CountIndexChange(u), -2);
    // More room, less energy.
    EXPECT_LT(patch.GetEnergyChange(), last);
    last = patch.GetEnergyChange();
  }
  EXPECT_LT(last, 0.0);
}

TEST(PairCancellation, ADipoleOnTheFlatSquareGoes)
{
  for (const int degree : { 1, 2, 5 })
  {
    for (const double distance : { 0.1, 0.3 })
    {
      const Case flat(Square(32), degree);
      ComplexVector u = flat.Planar([&](const Vector3& p) { return Dipole(p, distance); });
      ASSERT_EQ(flat.Count(u), 2);
      const UnitLengthProblem problem = flat.Problem();
      PairCancellation cancellation(problem, 0.0);
      const double before = problem.Energy(u);
      EXPECT_EQ(cancellation.Round(u, {}), 1);
      EXPECT_EQ(flat.Count(u), 0);
      EXPECT_LT(problem.Energy(u), 0.5 * before);
      // The remaining field is nearly parallel.
      const Hierarchy hierarchy(flat.Matrices, flat.Scale);
      PhaseDescent(problem, hierarchy, nullptr).Polish(0.0, 1e-12, 100, {}, u);
      EXPECT_LT(problem.Energy(u), 1e-6);
    }
  }
}

TEST(PairCancellation, FarPairsAreCancelledOnApproval)
{
  // The path is so long that only narrow patches around it are made: descent takes the rest away.
  const Surface torus = Torus(100, 40);
  const Case system(torus, 4);
  const UnitLengthProblem problem = system.Problem();
  const Hierarchy hierarchy(system.Matrices, system.Scale);
  const PhaseDescent descent(problem, hierarchy, nullptr);
  Options options;
  const Result smoothest = DirectionField(torus).Compute(options);
  ComplexVector u(problem.Rows());
  for (Index v = 0; v < u.size(); ++v)
  {
    u[v] = smoothest.Representation[system.Mesh.Point(v)];
  }
  MakeUnit(u);
  descent.Polish(0.0, 1e-4, 20, {}, u);
  PairCancellation cancellation(problem, 2.0 * Pi * std::log(2.0));
  cancellation.Round(u, {});
  const int before = system.Count(u);
  const double energy = problem.Energy(u);
  ComplexVector tried = u;
  const int cancelled = cancellation.CancelOnApproval(tried);
  ASSERT_GT(cancelled, 0);
  EXPECT_GT(problem.Energy(tried), energy);
  EXPECT_EQ(system.Count(tried), before - 2 * cancelled);
  descent.Polish(0.0, 1e-4, 20, {}, tried);
  EXPECT_LT(problem.Energy(tried), energy + 2.0 * cancelled * 2.0 * Pi * std::log(2.0));
}

TEST(PhaseDescent, NeverRaisesTheEnergyAndReachesTheHarmonicPhase)
{
  // With given values on the boundary the phase that descent reaches is harmonic: here a linear function.
  const Case flat(Square(24), 2);
  const ComplexVector exact =
    flat.Planar([](const Vector3& p) { return 1.5 * p.x() - 0.8 * p.y(); });
  std::vector<Index> given;
  ComplexVector u = exact;
  UnitLengthProblem problem = flat.Problem();
  problem.IsGiven.assign(u.size(), 0);
  for (Index v = 0; v < u.size(); ++v)
  {
    if (flat.Mesh.IsBoundary(v))
    {
      problem.IsGiven[v] = 1;
      given.push_back(v);
    }
    else
    {
      u[v] *= std::polar(1.0, std::sin(7.0 * v));
    }
  }
  const FreeVertices free(given, static_cast<Index>(u.size()));
  Operators inner;
  inner.Energy = free.Principal(flat.Matrices.Energy);
  inner.Mass = free.Principal(flat.Matrices.Mass);
  const Hierarchy hierarchy(inner, flat.Scale, LeftOver::Drop);
  const PhaseDescent descent(problem, hierarchy, &free);
  double energy = problem.Energy(u);
  for (int step = 0; step < 60; ++step)
  {
    descent.Polish(0.0, 0.0, 1, {}, u);
    const double next = problem.Energy(u);
    EXPECT_LE(next, energy);
    energy = next;
  }
  EXPECT_LT((u - exact).lpNorm<Eigen::Infinity>(), 1e-2);
  for (const Index v : given)
  {
    EXPECT_EQ(u[v], exact[v]);
  }
}

/// In a disk with given values a singularity belongs in the middle.
TEST(SingularityMoves, ASingularityGoesToTheMiddleOfTheDisk)
{
  const Case disk(Disk(16), 1);
  ComplexVector u = disk.Planar(
    [](const Vector3& p)
    {
      const double edge = std::atan2(p.y(), p.x());
      return p.norm() > 1.0 - 1e-9 ? edge : std::atan2(p.y() - 0.031, p.x() - 0.613);
    });
  UnitLengthProblem problem = disk.Problem();
  problem.IsGiven.assign(u.size(), 0);
  std::vector<Index> given;
  for (Index v = 0; v < u.size(); ++v)
  {
    if (disk.Mesh.IsBoundary(v))
    {
      problem.IsGiven[v] = 1;
      given.push_back(v);
    }
  }
  const FreeVertices free(given, static_cast<Index>(u.size()));
  Operators inner;
  inner.Energy = free.Principal(disk.Matrices.Energy);
  inner.Mass = free.Principal(disk.Matrices.Mass);
  const Hierarchy hierarchy(inner, disk.Scale, LeftOver::Drop);
  const PhaseDescent descent(problem, hierarchy, &free);
  descent.Polish(0.0, 1e-4, 30, {}, u);
  const auto radius = [&]
  {
    const std::vector<int> indices = disk.Indices(u);
    double farthest = 0.0;
    for (std::size_t t = 0; t < indices.size(); ++t)
    {
      if (indices[t] != 0)
      {
        const auto h = static_cast<Index>(3 * t);
        const Vector3 sum = disk.Positions[disk.Mesh.Tail(h)] +
          disk.Positions[disk.Mesh.Tail(h + 1)] + disk.Positions[disk.Mesh.Tail(h + 2)];
        farthest = std::max(farthest, sum.norm() / 3.0);
      }
    }
    return farthest;
  };
  ASSERT_GT(radius(), 0.55);
  SingularityMoves moves(problem);
  double energy = problem.Energy(u);
  for (int sweep = 0; sweep < 30 && !moves.IsDone(); ++sweep)
  {
    moves.Sweep(u);
    descent.Polish(0.0, 1e-3, 3, {}, u);
    const double next = problem.Energy(u);
    EXPECT_LE(next, energy + 1e-9);
    energy = next;
  }
  EXPECT_TRUE(moves.IsDone());
  EXPECT_LT(radius(), 0.2);
}
