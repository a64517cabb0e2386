// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/Stages.h"
#include "DirectionField.h"
#include "Meshes/DenseAlgebra.h"
#include "Meshes/Surfaces.h"
#include "OptionTable.h"
#include "Systems/DirectSystem.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
Options Constrained(ConstraintSolver solver)
{
  Options options;
  options.ConstraintSolver = solver;
  return options;
}

constexpr ConstraintSolver Solvers[] = { ConstraintSolver::LeastSquares, ConstraintSolver::Energy };

int Sum(const Result& result)
{
  return std::accumulate(result.SingularityIndex.begin(), result.SingularityIndex.end(), 0);
}

/// n chi minus the turns of the boundary at each vertex, rounded to multiples of 2 pi / n: the sum of
/// the indices that a field along the boundary has.
int DemandedSum(const Surface& surface, int degree)
{
  const Stages stages(surface);
  const TriangleMesh& mesh = stages.GetMesh();
  int sum =
    degree * (mesh.GetNumberOfVertices() - mesh.GetNumberOfEdges() + mesh.GetNumberOfTriangles());
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (mesh.IsBoundary(v))
    {
      sum -= static_cast<int>(
        std::lround((Pi - stages.GetGeometry().Transport.AngleSum[v]) * degree / (2.0 * Pi)));
    }
  }
  return sum;
}

}

TEST(Constraints, DiskIsTangentAtTheBoundaryWithFourSymmetricSingularities)
{
  const Surface disk = FourfoldDisk(12);
  for (const ConstraintSolver solver : Solvers)
  {
    Options options = Constrained(solver);
    options.ConstrainBoundary = true;
    const Result result = DirectionField(disk).Compute(options);
    Index boundary = 0;
    for (Index i = 0; i < static_cast<Index>(disk.Points.size()); ++i)
    {
      const Vector3& p = disk.Points[i];
      if (p.norm() > 1.0 - 1e-9)
      {
        EXPECT_LT(Deviation(result, i, { -p.y(), p.x(), 0.0 }), 0.1);
        EXPECT_LT((result.ConstraintDirection[i].cross(Vector3(-p.y(), p.x(), 0))).norm(), 1.7e-3);
        ++boundary;
      }
    }
    EXPECT_EQ(Count(result, ConstraintKind::Boundary), boundary);
    EXPECT_EQ(result.Components[0].Constraints, boundary);
    std::vector<Vector3> singular;
    for (std::size_t t = 0; t < disk.Triangles.size(); ++t)
    {
      if (result.SingularityIndex[t] != 0)
      {
        EXPECT_EQ(result.SingularityIndex[t], 1);
        const Triangle& c = disk.Triangles[t];
        singular.push_back((disk.Points[c[0]] + disk.Points[c[1]] + disk.Points[c[2]]) / 3.0);
      }
    }
    ASSERT_EQ(singular.size(), 4u);
    const Eigen::Matrix3d quarter =
      Eigen::AngleAxisd(0.5 * Pi, Vector3::UnitZ()).toRotationMatrix();
    for (const Vector3& p : singular)
    {
      const double nearest = (*std::min_element(singular.begin(), singular.end(),
                                [&](const Vector3& a, const Vector3& b)
                                { return (quarter * p - a).norm() < (quarter * p - b).norm(); }) -
        quarter * p)
                               .norm();
      // Up to the triangle that the center of symmetry chooses.
      EXPECT_LT(nearest, 0.06);
    }
  }
}

TEST(Constraints, IndexSumIsWhatTheBoundaryDemands)
{
  const std::vector<std::pair<Surface, int>> surfaces = { { Square(10), 0 }, { LShape(8), 0 },
    { Disk(9), 4 }, { PlateWithHole(64, 16, 0.5, false), -4 }, { Cylinder(24, 9, 2.0), 0 } };
  for (const auto& [surface, expected] : surfaces)
  {
    EXPECT_EQ(DemandedSum(surface, 4), expected);
    for (const ConstraintSolver solver : Solvers)
    {
      Options options = Constrained(solver);
      options.ConstrainBoundary = true;
      EXPECT_EQ(Sum(DirectionField(surface).Compute(options)), expected);
    }
  }
  // The corners of a square leave a cross field straight; no singularity, and not only in the sum.
  Options options;
  options.ConstrainBoundary = true;
  const Result square = DirectionField(Square(10)).Compute(options);
  for (Index i = 0; i < 121; ++i)
  {
    EXPECT_LT(Deviation(square, i, Vector3::UnitX()), 1e-6);
  }
  for (const int index : square.SingularityIndex)
  {
    EXPECT_EQ(index, 0);
  }
  // Corners of a hexagon, 60 degrees each, keep a hex field.
  Surface hexagon = Disk(4);
  for (Vector3& p : hexagon.Points)
  {
    const double angle = std::remainder(std::atan2(p.y(), p.x()), Pi / 3.0);
    const double toMiddle = Pi / 6.0 - std::abs(angle);
    p *= std::cos(Pi / 6.0) / std::cos(toMiddle);
  }
  options.Degree = 6;
  EXPECT_EQ(DemandedSum(hexagon, 6), 0);
  const Result hex = DirectionField(hexagon).Compute(options);
  EXPECT_EQ(Sum(hex), 0);
  for (Index i = 0; i < static_cast<Index>(hexagon.Points.size()); ++i)
  {
    EXPECT_LT(Deviation(hex, i, Vector3::UnitX()), 1e-6);
  }
}

TEST(Constraints, CurvedBoundariesAreFollowed)
{
  for (const Surface& surface :
    { Cylinder(32, 10, 2.0), Transformed(Disk(9), Vector3(1.3, 1, 1).asDiagonal(), { 0, 0, 1 }) })
  {
    for (const int degree : { 1, 2, 4, 6 })
    {
      Options options;
      options.Degree = degree;
      options.ConstrainBoundary = true;
      const Result result = DirectionField(surface).Compute(options);
      EXPECT_TRUE(result.Components[0].Converged);
      for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
      {
        const Vector3& p = surface.Points[i];
        if (result.Constraint[i] == ConstraintKind::Boundary)
        {
          const bool flat = p.z() == 1.0;
          const Vector3 tangent(-p.y() * (flat ? 1.69 : 1.0), p.x(), 0.0);
          EXPECT_LT(
            Deviation(result, i, degree == 1 && p.z() == 2.0 ? Vector3(-tangent) : tangent), 0.7);
        }
      }
    }
  }
}

TEST(Constraints, SharpEdgesAreFollowedExactly)
{
  for (const Surface& surface :
    { FlatlySubdivided(Icosahedron(), 3), ChamferedCube(6), FlatlySubdivided(Cube(), 3) })
  {
    for (const ConstraintSolver solver : Solvers)
    {
      Options options = Constrained(solver);
      options.ConstrainSharpEdges = true;
      const Result result = DirectionField(surface).Compute(options);
      EXPECT_GT(Count(result, ConstraintKind::SharpEdge), 20);
      EXPECT_EQ(Sum(result), 8);
      // Sharp edges by their triangles' normals, found without the mesh structure.
      std::map<std::pair<Index, Index>, std::vector<Vector3>> normals;
      for (const Triangle& t : surface.Triangles)
      {
        const Vector3 n = (surface.Points[t[1]] - surface.Points[t[0]])
                            .cross(surface.Points[t[2]] - surface.Points[t[0]])
                            .normalized();
        for (int c = 0; c < 3; ++c)
        {
          normals[std::minmax({ t[c], t[(c + 1) % 3] })].push_back(n);
        }
      }
      std::map<Index, double> best;
      for (const auto& [edge, sides] : normals)
      {
        if (sides[0].dot(sides[1]) < std::cos(options.FeatureAngle * Pi / 180.0))
        {
          for (const auto& [from, to] :
            { std::pair(edge.first, edge.second), std::pair(edge.second, edge.first) })
          {
            const Vector3& n = result.Normal[from];
            const Vector3 along = surface.Points[to] - surface.Points[from];
            const double deviation = Deviation(result, from, along - along.dot(n) * n);
            const auto [it, inserted] = best.emplace(from, deviation);
            it->second = std::min(it->second, deviation);
          }
        }
      }
      EXPECT_EQ(static_cast<Index>(best.size()), Count(result, ConstraintKind::SharpEdge));
      for (const auto& [point, deviation] : best)
      {
        EXPECT_EQ(result.Constraint[point], ConstraintKind::SharpEdge);
        EXPECT_LT(deviation, 1e-5);
      }
    }
  }
}

TEST(Constraints, CurvatureKeepsFlatPartsStraight)
{
  // The plate of the thesis' figure 4.5: a large round hole, sides bent down over bevels.
  const Surface plate = PlateWithHole(96, 30, 0.6, true);
  for (const ConstraintSolver solver : Solvers)
  {
    Options options = Constrained(solver);
    options.ConstrainBoundary = true;
    const auto meanDeviation = [&](const Result& result)
    {
      double sum = 0.0;
      int count = 0;
      for (Index i = 0; i < static_cast<Index>(plate.Points.size()); ++i)
      {
        const Vector3& p = plate.Points[i];
        if (p.z() == 0.0 && p.norm() > 0.72)
        {
          sum += Deviation(result, i, Vector3::UnitX());
          ++count;
        }
      }
      return sum / count;
    };
    const Result warped = DirectionField(plate).Compute(options);
    options.ConstrainCurvature = true;
    const Result straight = DirectionField(plate).Compute(options);
    EXPECT_GT(Count(straight, ConstraintKind::Curvature), 300);
    EXPECT_LT(meanDeviation(straight), 0.6 * meanDeviation(warped));
    EXPECT_EQ(Sum(straight), Sum(warped));
    // On the bevels the curvature runs across: the constraints are the axes.
    for (Index i = 0; i < static_cast<Index>(plate.Points.size()); ++i)
    {
      const Vector3& p = plate.Points[i];
      if (straight.Constraint[i] == ConstraintKind::Curvature && std::abs(p.x()) > 0.9 &&
        std::abs(p.y()) < 0.7)
      {
        EXPECT_LT(Deviation(straight, i, Vector3::UnitY()), 6.0);
      }
    }
  }
}

TEST(Constraints, OneVertexOfManyTrianglesIsNoTrouble)
{
  // K_f^* K_f of a bipyramid is dense, and is not formed; a dense solver has the answer all the same.
  for (const int sides : { 300, 4000 })
  {
    Surface bipyramid;
    bipyramid.Points = { { 0, 0, 1 }, { 0, 0, -1 } };
    for (Index k = 0; k < sides; ++k)
    {
      const double a = 2.0 * Pi * k / sides;
      bipyramid.Points.emplace_back(std::cos(a), std::sin(a), 0.1 * std::sin(3.0 * a));
      const Index here = 2 + k;
      const Index next = 2 + (k + 1) % sides;
      bipyramid.Triangles.push_back({ 0, here, next });
      bipyramid.Triangles.push_back({ 1, next, here });
    }
    Options options;
    options.ConstrainGuidance = true;
    const Result result = DirectionField(bipyramid).Compute(
      options, GuidanceAt(bipyramid, { { 2, Vector3::UnitY() }, { sides / 2, Vector3::UnitZ() } }));
    EXPECT_LE(result.Components[0].SystemResidual, 1e-6);
    EXPECT_EQ(Sum(result), 8);
    if (sides > 300)
    {
      continue;
    }
    Stages stages(bipyramid);
    const SparseMatrix& k = stages.GetEnergy(options, {}).Components[0].GetMatrices().Energy;
    GivenValues given{ { 2, 150 }, ComplexVector(2) };
    given.Values << Complex(1.0, 0.0), Complex(0.0, 1.0);
    std::vector<Index> free;
    for (Index v = 0; v < k.rows(); ++v)
    {
      if (v != 2 && v != 150)
      {
        free.push_back(v);
      }
    }
    const Eigen::MatrixXcd dense(k);
    const ComplexVector right = -dense(Eigen::indexing::all, given.Vertices) * given.Values;
    const ComplexVector exact = DenseLeastSquares(dense(Eigen::indexing::all, free), right);
    const SystemSolution solution =
      MinimizeResidualDirectly(k, ComplexVector::Zero(k.rows()), given);
    EXPECT_LT((solution.Vector(free) - exact).norm(), 1e-7 * exact.norm());
  }
}

TEST(Constraints, AlignmentVanishesAtConstraintsAndTheirNeighbours)
{
  // alpha: guidance at a constrained vertex and around it has no influence.
  const Surface surface = Potato(2);
  DirectionField field(surface);
  Options options;
  options.Alignment = Alignment::PrincipalCurvature;
  options.ConstrainGuidance = true;
  const Guidance guidance = GuidanceAt(surface, { { 7, { 1, 0.2, 0.3 } } });
  for (const ConstraintSolver solver : Solvers)
  {
    options.ConstraintSolver = solver;
    const Result result = field.Compute(options, guidance);
    EXPECT_EQ(Count(result, ConstraintKind::Given), 1);
    EXPECT_TRUE(result.Components[0].Converged);
    const Vector3 projected =
      guidance.Vectors[7] - guidance.Vectors[7].dot(result.Normal[7]) * result.Normal[7];
    EXPECT_LT(Deviation(result, 7, projected), 1e-6);
    EXPECT_EQ(Sum(result), 8);
  }
}

TEST(Constraints, ContradictionsAndExtremesAreWellDefined)
{
  const Surface surface = Potato(2);
  DirectionField field(surface);
  std::mt19937 engine(3);
  Guidance everywhere;
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    everywhere.Vectors.emplace_back(engine() % 100 - 50.0, engine() % 100 - 50.0, 1.0);
  }
  Guidance butOne = everywhere;
  butOne.Vectors[11].setZero();
  for (const ConstraintSolver solver : Solvers)
  {
    Options options = Constrained(solver);
    options.ConstrainGuidance = true;
    for (const Guidance& guidance : { everywhere, butOne })
    {
      const Result result = field.Compute(options, guidance);
      EXPECT_TRUE(result.Components[0].Converged);
      EXPECT_EQ(Sum(result), 8);
      for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
      {
        EXPECT_NEAR(result.Direction(i, 0).norm(), 1.0, 1e-12);
        if (result.Constraint[i] == ConstraintKind::Given)
        {
          const Vector3& v = guidance.Vectors[i];
          EXPECT_LT(Deviation(result, i, v - v.dot(result.Normal[i]) * result.Normal[i]), 1e-5);
        }
      }
    }
  }
}

TEST(Constraints, AnyCombinationGivesAFiniteUnitField)
{
  std::mt19937 engine(11);
  const auto pick = [&](unsigned n) { return engine() % n; };
  const auto fraction = [&] { return engine() / 4294967296.0; };
  const std::vector<Surface> surfaces = { Tetrahedron(), Cube(), Potato(2), Torus(12, 8),
    DoubleTorus(), Hemisphere(2), Disk(4), ChamferedCube(3), PlateWithHole(24, 8, 0.5, true),
    Joined(Potato(1), Transformed(Disk(2), ObliqueRotation(1), { 5, 0, 0 })),
    Jittered(Icosphere(2), 0.15, 3) };
  for (int run = 0; run < 400; ++run)
  {
    const Surface& surface = surfaces[pick(static_cast<unsigned>(surfaces.size()))];
    Options options;
#define PICK_FLAG(name, ...) options.name = pick(2);
#define PICK_CHOICE(name, stage, last)                                                             \
  options.name = static_cast<decltype(options.name)>(pick(last + 1));
#define PICK_NUMBER(name, stage, least, most, unit)                                                \
  options.name = static_cast<decltype(options.name)>(                                              \
    least + fraction() * (std::min<double>(most, 10.0) - least));
    DIRECTIONFIELDS_OPTIONS(PICK_FLAG, PICK_CHOICE, PICK_NUMBER)
#undef PICK_FLAG
#undef PICK_CHOICE
#undef PICK_NUMBER
    // These have to be sensible for the field to be checked.
    options.Tolerance = Options().Tolerance;
    options.MaximumIterations = Options().MaximumIterations;
    options.NumberOfThreads = 0;
    options.Solver = Solver::Automatic;
    options.Degree = 1 + static_cast<int>(pick(8));
    options.EnergyBias = pick(4) == 0 ? (pick(2) ? 1.0 : -1.0) : 2.0 * fraction() - 1.0;
    const bool curvature = options.Degree == 2 || options.Degree == 4;
    options.Alignment = pick(3) == 0 ? Alignment::PointVectors
      : curvature && pick(2)         ? Alignment::PrincipalCurvature
                                     : Alignment::None;
    options.CurvatureScale = pick(2) ? 0.0 : 4.0 * fraction();
    options.AlignmentStrength = pick(4) == 0 ? static_cast<double>(pick(2)) : fraction();
    options.UseShift = pick(4) == 0;
    options.Shift = std::pow(10.0, 8.0 * fraction() - 4.0);
    options.FeatureAngle = 90.0 * fraction();
    options.MinimumFeatureLength = pick(3) ? fraction() : 0.0;
    options.ConstrainCurvature = curvature && pick(2);
    options.CurvatureTolerance = 3.0 * fraction();
    options.ConsistencyAngle = 60.0 * fraction();
    options.ConstrainGuidance = pick(3) == 0;
    options.SingularityCost = pick(2) ? 2.0 * fraction() : 0.0;
    Guidance guidance;
    for (std::size_t i = 0; i < surface.Points.size(); ++i)
    {
      guidance.Vectors.push_back(
        pick(3) ? Vector3(fraction() - 0.5, fraction() - 0.5, fraction() - 0.5) : Vector3::Zero());
      guidance.Weights.push_back(pick(4) ? fraction() : 0.0);
    }
    const Result result = DirectionField(surface).Compute(options, guidance);
    for (const ComponentReport& component : result.Components)
    {
      EXPECT_TRUE(std::isfinite(component.SmoothnessEnergy) && std::isfinite(component.Lambda));
      EXPECT_LE(
        component.Lambda, component.Eigenvalue + 1e-9 * std::abs(component.Eigenvalue) + 1e-9);
      EXPECT_LE(component.SystemResidual, 1e-6) << "run " << run;
      if (options.UnitLength && options.SingularityCost == 0.0)
      {
        EXPECT_LE(component.UnitEnergyAfter, component.UnitEnergyBefore + 1e-9) << "run " << run;
      }
      if (component.Closed)
      {
        EXPECT_EQ(component.IndexSum, options.Degree * component.EulerCharacteristic);
      }
    }
    for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
    {
      for (int k = 0; k < options.Degree; ++k)
      {
        const Vector3 d = result.Direction(i, k);
        ASSERT_NEAR(d.norm(), 1.0, 1e-9) << "run " << run;
        ASSERT_NEAR(d.dot(result.Normal[i]), 0.0, 1e-9) << "run " << run;
      }
    }
  }
}
