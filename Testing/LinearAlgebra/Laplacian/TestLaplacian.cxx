// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Geometry/SurfaceGeometry.h"
#include "Laplacian/LaplacianCycle.h"
#include "Meshes/Surfaces.h"
#include "Support/Threads.h"
#include "TrivialConnection/PoissonSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
/// The Laplacian of the first component of a surface.
struct Problem
{
  explicit Problem(const Surface& surface)
    : Geometry(surface)
    , Forms(this->Geometry, this->Geometry.Mesh.GetComponents().front())
  {
  }
  GraphLaplacian Laplacian() const
  {
    const TriangleMesh& mesh = this->Geometry.Mesh;
    return { this->Forms.GetComponent().Vertices(), this->Forms.GetComponent().Edges(),
      [&](Index e)
      {
        const Index h = mesh.HalfEdge(e);
        return GraphLaplacian::Edge{ mesh.Tail(h), mesh.Head(h), this->Forms.Weight(e) };
      } };
  }

  SurfaceGeometry Geometry;
  DiscreteForms Forms;
};

Eigen::VectorXd RandomNumbers(Eigen::Index size, unsigned seed)
{
  std::mt19937 engine(seed);
  Eigen::VectorXd numbers(size);
  for (double& number : numbers)
  {
    number = engine() / 4294967296.0 - 0.5;
  }
  numbers.array() -= numbers.mean();
  return numbers;
}

LargeArray<float> Compact(const Eigen::VectorXd& x)
{
  LargeArray<float> result(static_cast<std::size_t>(x.size()));
  std::transform(
    x.begin(), x.end(), result.begin(), [](double v) { return static_cast<float>(v); });
  return result;
}

double Dot(const LargeArray<float>& a, const LargeArray<float>& b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}
}

TEST(Laplacian, ProductIsTheSumOverTheEdges)
{
  const Problem problem(Meshes::Torus(83, 71));
  const SweptLaplacian laplacian(problem.Laplacian());
  const Eigen::VectorXd x = RandomNumbers(laplacian.Rows(), 1);
  Eigen::VectorXd y;
  const double product = laplacian.Multiply(x, y);
  EdgeForm rise(problem.Forms.GetComponent().Edges(), 0.0);
  problem.Forms.SubtractRise(x, rise);
  EXPECT_NEAR(product, problem.Forms.Product(rise, rise), 1e-6 * product);
  EXPECT_LT((y + problem.Forms.Inflow(rise)).norm(), 1e-6 * y.norm());
  // Constants give zero exactly.
  laplacian.Multiply(Eigen::VectorXd::Constant(laplacian.Rows(), 0.1), y);
  EXPECT_EQ(y.cwiseAbs().maxCoeff(), 0.0);
}

TEST(Laplacian, CyclesAreSymmetricAndPositive)
{
  const Problem problem(Meshes::Potato(4));
  const Eigen::VectorXd areas = problem.Forms.VertexAreas();
  const LaplacianHierarchy hierarchy(problem.Laplacian(), areas);
  for (const double shift : { 0.0, 10.0 })
  {
    LaplacianCycle cycle(hierarchy, shift);
    ASSERT_TRUE(cycle.IsUsable());
    const LargeArray<float> a = Compact(RandomNumbers(areas.size(), 2));
    const LargeArray<float> b = Compact(RandomNumbers(areas.size(), 3));
    LargeArray<float> ofA;
    LargeArray<float> ofB;
    cycle.Apply(a, ofA);
    cycle.Apply(b, ofB);
    EXPECT_NEAR(Dot(a, ofB), Dot(b, ofA), 1e-4 * std::sqrt(Dot(a, ofA) * Dot(b, ofB)));
    EXPECT_GT(Dot(a, ofA), 0.0);
  }
}

// Cycles by themselves take most of the error away, however many triangles there are.
TEST(Laplacian, CyclesReduceResidualsOnMeshesOfAnySize)
{
  for (const int levels : { 2, 4, 6 })
  {
    const Problem problem(Meshes::Potato(levels));
    const LaplacianHierarchy hierarchy(problem.Laplacian(), problem.Forms.VertexAreas());
    const SweptLaplacian& laplacian = hierarchy.GetLevels().front().Matrix;
    LaplacianCycle cycle(hierarchy, 0.0);
    Eigen::VectorXd residual = RandomNumbers(laplacian.Rows(), 4);
    const double before = residual.norm();
    LargeArray<float> corrected;
    Eigen::VectorXd image;
    constexpr int cycles = 8;
    for (int k = 0; k < cycles; ++k)
    {
      cycle.Apply(Compact(residual), corrected);
      laplacian.Multiply(
        Eigen::Map<const Eigen::VectorXf>(corrected.data(), residual.size()).cast<double>(), image);
      residual -= image;
    }
    EXPECT_LT(std::pow(residual.norm() / before, 1.0 / cycles), 0.6) << levels;
  }
}

TEST(Laplacian, SolutionsHaveTheSameBytesForAnyNumberOfThreads)
{
  const Problem problem(Meshes::Potato(5));
  const ConstrainedSets groups(problem.Geometry.Mesh, problem.Forms.GetComponent(), {});
  const Eigen::VectorXd right = RandomNumbers(groups.NumberOfUnknowns, 5);
  Eigen::VectorXd first;
  for (const int number : { 1, 2, 5 })
  {
    Threads threads(number);
    const Threads::Scope scope(threads);
    const PoissonSolver solver(problem.Forms, groups);
    Eigen::VectorXd values = Eigen::VectorXd::Zero(groups.NumberOfUnknowns);
    EXPECT_LT(solver.Solve(PoissonSolver::Problem{ right }, values), 1e-8);
    if (first.size() == 0)
    {
      first = values;
    }
    EXPECT_EQ(values, first) << number;
  }
}

TEST(Laplacian, GroupsAreOneUnknown)
{
  const Problem problem(Meshes::Disk(20));
  const TriangleMesh& mesh = problem.Geometry.Mesh;
  std::vector<char> isGiven(mesh.GetNumberOfVertices(), 0);
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    isGiven[v] = mesh.IsBoundary(v) ? 1 : 0;
  }
  const ConstrainedSets groups(mesh, problem.Forms.GetComponent(), isGiven);
  ASSERT_EQ(groups.GivenUnknowns.size(), 1U);
  const PoissonSolver solver(problem.Forms, groups);
  Eigen::VectorXd values = Eigen::VectorXd::Zero(groups.NumberOfUnknowns);
  const Eigen::VectorXd right = RandomNumbers(groups.NumberOfUnknowns, 6);
  PoissonSolver::Problem equations{ right };
  equations.Tolerance = 1e-10;
  solver.Solve(equations, values);
  EdgeForm rise(problem.Forms.GetComponent().Edges(), 0.0);
  problem.Forms.SubtractRise(solver.Spread(values), rise);
  const Eigen::VectorXd image = -solver.Gathered(problem.Forms.Inflow(rise));
  EXPECT_LT((image - right).norm(), 1e-6 * right.norm());
}
