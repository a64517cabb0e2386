// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cases that other programs for direction fields were seen to get wrong, one test each.

#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

using namespace DirectionFields;
using namespace Fields;
using namespace Meshes;

namespace
{
int Sum(const Result& result)
{
  return std::accumulate(result.SingularityIndex.begin(), result.SingularityIndex.end(), 0);
}

std::ptrdiff_t Singularities(const Result& result)
{
  return std::count_if(result.SingularityIndex.begin(), result.SingularityIndex.end(),
    [](int index) { return index != 0; });
}

/// Unit directions at all points of triangles, converged, with indices that sum up where they must.
void ExpectSound(const Surface& surface, const Result& result)
{
  for (const Triangle& t :
    result.SplitTriangles.empty() ? surface.Triangles : result.SplitTriangles)
  {
    for (const Index i : t)
    {
      EXPECT_NEAR(result.Direction(i, 0).norm(), 1.0, 1e-9);
    }
  }
  for (const ComponentReport& component : result.Components)
  {
    EXPECT_TRUE(component.Converged);
    EXPECT_TRUE(std::isfinite(component.Eigenvalue));
    if (component.Closed)
    {
      EXPECT_EQ(component.IndexSum, result.Degree * component.EulerCharacteristic);
    }
  }
}
}

TEST(Peers, HolonomyIsNotWrappedInTheIndex)
{
  for (int degree = 1; degree <= 16; ++degree)
  {
    EXPECT_EQ(Sum(Compute(Cube(), degree)), 2 * degree);
    EXPECT_EQ(Sum(Compute(Octahedron(), degree)), 2 * degree);
    EXPECT_EQ(Sum(Compute(DoubleTorus(), degree)), -2 * degree);
  }
}

TEST(Peers, IndicesAreRightWithTheBoundaryConstrained)
{
  // Along a circle a cross turns once: the index is the characteristic's, less nothing at straight
  // boundaries and at right-angled corners. An annulus has 0, a disk 4, a square 0.
  Surface dome = Disk(8);
  for (Vector3& p : dome.Points)
  {
    p.z() = 1.0 - p.squaredNorm();
  }
  Options options;
  options.ConstrainBoundary = true;
  for (const ConstraintSolver solver : { ConstraintSolver::LeastSquares, ConstraintSolver::Energy })
  {
    options.ConstraintSolver = solver;
    EXPECT_EQ(Sum(DirectionField(Disk(8)).Compute(options)), 4);
    EXPECT_EQ(Sum(DirectionField(Square(6)).Compute(options)), 0);
    EXPECT_EQ(Sum(DirectionField(Cylinder(24, 6, 2.0)).Compute(options)), 0);
    EXPECT_EQ(Sum(DirectionField(dome).Compute(options)), 4);
  }
}

TEST(Peers, AnIsolatedVertexDoesNotCrash)
{
  Surface surface = Potato(1);
  surface.Points.insert(surface.Points.begin(), Vector3(9.0, 9.0, 9.0));
  for (Triangle& t : surface.Triangles)
  {
    t = { t[0] + 1, t[1] + 1, t[2] + 1 };
  }
  const Result result = Compute(surface, 4);
  ExpectSound(surface, result);
  EXPECT_EQ(result.Direction(0, 0), Vector3::Zero());
}

TEST(Peers, ANonManifoldFinDoesNotCrash)
{
  Surface surface = Potato(1);
  const Triangle t = surface.Triangles[0];
  surface.Triangles.push_back({ t[0], t[1], static_cast<Index>(surface.Points.size()) });
  surface.Points.push_back(2.0 * surface.Points[t[0]]);
  const Result result = Compute(surface, 4);
  ExpectSound(surface, result);
  EXPECT_EQ(result.Repaired.NonManifoldEdges, 1);
}

TEST(Peers, AMoebiusStripDoesNotCrash)
{
  const Surface surface = MoebiusStrip(20, 3);
  ExpectSound(surface, Compute(surface, 4));
}

TEST(Peers, AFlippedFaceDoesNotLoop)
{
  const Surface clean = Potato(1);
  Surface surface = clean;
  std::swap(surface.Triangles[7][0], surface.Triangles[7][1]);
  const Result result = Compute(surface, 4);
  ExpectSound(surface, result);
  EXPECT_EQ(result.Repaired.ReversedTriangles, 1);
  const Result expected = Compute(clean, 4);
  for (Index i = 0; i < static_cast<Index>(clean.Points.size()); ++i)
  {
    EXPECT_LT((result.Direction(i, 0) - expected.Direction(i, 0)).norm(), 1e-3);
  }
}

TEST(Peers, ABowTieDoesNotLoop)
{
  const Surface surface{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { -1, 0, 0 }, { -1, -1, 0 } },
    { { 1, 2, 0 }, { 0, 3, 4 } } };
  const Result result = Compute(surface, 4);
  ExpectSound(surface, result);
  EXPECT_EQ(result.Repaired.NonManifoldPoints, 1);
}

TEST(Peers, AnEdgeWithoutLengthGivesNoNaN)
{
  Surface surface = Potato(1);
  surface.Points[surface.Triangles[3][0]] = surface.Points[surface.Triangles[3][1]];
  const Result result = Compute(surface, 4);
  ExpectSound(surface, result);
  EXPECT_GT(result.Repaired.DegenerateTriangles, 0);
}

TEST(Peers, AnyStrengthOfAlignmentGivesNoNaN)
{
  const Surface surface = Potato(2);
  Options options;
  options.Alignment = Alignment::PrincipalCurvature;
  DirectionField field(surface);
  for (const double strength : { 0.0, 1e-9, 0.5, 1.0 - 1e-12, 1.0 })
  {
    options.AlignmentStrength = strength;
    ExpectSound(surface, field.Compute(options));
  }
  options.UseShift = true;
  for (const double shift : { 0.0, 1e-12, 1.0, 1e12, 1e300 })
  {
    options.Shift = shift;
    ExpectSound(surface, field.Compute(options));
  }
}

TEST(Peers, AlignmentToTheBoundaryOfAClosedMeshIsSaidToDoNothing)
{
  Options options;
  options.ConstrainBoundary = true;
  const Result result = DirectionField(Potato(2)).Compute(options);
  ASSERT_EQ(result.Notes.size(), 1u);
  EXPECT_NE(result.Notes[0].find("no boundary"), std::string::npos);
  EXPECT_EQ(result.Representation, DirectionField(Potato(2)).Compute({}).Representation);
}

TEST(Peers, TheSingularitiesAreThoseOfTheConvergedField)
{
  Options options;
  for (const Surface& surface : { Potato(4), Torus(80, 40), DoubleTorus() })
  {
    options.Tolerance = 1e-6;
    const Result usual = DirectionField(surface).Compute(options);
    options.Tolerance = 1e-11;
    const Result exact = DirectionField(surface).Compute(options);
    ExpectSound(surface, usual);
    ExpectSound(surface, exact);
    EXPECT_EQ(Singularities(usual), Singularities(exact));
    // Not the same solve twice.
    EXPECT_LE(exact.Components[0].Residual, 1e-11);
  }
}

TEST(Peers, TiesOfTheRotationDoNotBreakTheSum)
{
  // Symmetric fields turn by exactly half a turn along some edges.
  EXPECT_EQ(Sum(Compute(Tetrahedron(), 1)), 2);
  EXPECT_EQ(Sum(Compute(Cube(), 3)), 6);
  for (int degree = 1; degree <= 16; ++degree)
  {
    EXPECT_EQ(Sum(Compute(Tetrahedron(), degree)), 2 * degree);
    EXPECT_EQ(Sum(Compute(Icosahedron(), degree)), 2 * degree);
  }
}

TEST(Peers, ASmallComponentBesideALargeOneHasNoFalseSingularities)
{
  const Surface large = Potato(3);
  const Surface both =
    Joined(large, Transformed(large, 0.01 * Eigen::Matrix3d::Identity(), { 5, 0, 0 }));
  const Result result = Compute(both, 4);
  ExpectSound(both, result);
  EXPECT_EQ(Singularities(result), 2 * Singularities(Compute(large, 4)));
}

TEST(Peers, MillimetresAreAsGoodAsMetres)
{
  const Surface surface = Potato(3);
  const Result metres = Compute(surface, 4);
  const Surface scaled = Transformed(surface, 1e-3 * Eigen::Matrix3d::Identity(), Vector3::Zero());
  const Result millimetres = Compute(scaled, 4);
  EXPECT_EQ(millimetres.SingularityIndex, metres.SingularityIndex);
  for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
  {
    EXPECT_LT((millimetres.Direction(i, 0) - metres.Direction(i, 0)).norm(), 1e-4);
  }
}

TEST(Peers, TwoComponentsGiveNoNaN)
{
  const Surface surface =
    Joined(Potato(2), Transformed(Torus(20, 10), Eigen::Matrix3d::Identity(), { 5, 0, 0 }));
  const Result result = Compute(surface, 4);
  ExpectSound(surface, result);
  EXPECT_EQ(result.Components.size(), 2u);
}
