// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/Stages.h"
#include "Interpolation/FieldInterpolation.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "Sections/Assembly.h"
#include "Sections/DoubleCover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

using namespace DirectionFields;
using namespace Fields;
using namespace Meshes;

namespace
{
/// The largest angle, in degrees, from a direction at one end of an edge to the nearest direction at
/// the other, where it comes with the bend of the surface; but for edges near singularities.
double LargestTurn(const Surface& surface, const Result& result)
{
  double largest = 0.0;
  const auto isClear = [&](Index i) { return std::abs(result.Representation[i]) > 0.3; };
  for (const Triangle& t : surface.Triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      if (isClear(t[c]) && isClear(t[(c + 1) % 3]))
      {
        const Index from = t[c];
        const Index to = t[(c + 1) % 3];
        const Vector3& normal = result.Normal[to];
        // The shortest rotation of one normal to the other: by half of the angle about their cross
        // product. Eigen's FromTwoVectors takes the compiler ten seconds for its decomposition.
        const Vector3& first = result.Normal[from];
        const Vector3 last = normal.dot(first) < 0.0 ? Vector3(-normal) : normal;
        const Vector3 axis = first.cross(last);
        const auto bend =
          Eigen::Quaterniond(1.0 + first.dot(last), axis.x(), axis.y(), axis.z()).normalized();
        for (int k = 0; k < result.Degree; ++k)
        {
          largest = std::max(largest, Deviation(result, to, bend * result.Direction(from, k)));
        }
      }
    }
  }
  return largest;
}
}

TEST(NonOrientable, TheMirrorImageOfASectionHasTheConjugateOperators)
{
  for (const Surface& surface : { MoebiusStrip(9, 3), KleinBottle(12, 8), ProjectivePlane(1),
         Joined(Disk(2), MoebiusStrip(5)) })
  {
    const Stages stages(surface);
    const TriangleMesh& mesh = stages.GetMesh();
    const TriangleMesh::Component& component = mesh.GetComponents().back();
    ComplexVector u(component.Vertices());
    for (Index v = 0; v < u.size(); ++v)
    {
      u[v] = std::polar(1.0 + std::sin(3.0 * v), 2.4 * v);
    }
    for (const int degree : { 1, 2, 3, 4, 7 })
    {
      for (const double bias : { -1.0, 0.0, 0.4, 1.0 })
      {
        const DoubleCover cover(stages.GetGeometry(), component, degree);
        const auto mirrored = [&](const ComplexVector& section)
        {
          ComplexVector image(section.size());
          for (Index v = 0; v < section.size(); ++v)
          {
            const Index vertex = component.FirstVertex + v;
            image[mesh.MirrorVertex(vertex) - component.FirstVertex] =
              cover.Mirrored(vertex, section[v]);
          }
          return image;
        };
        EXPECT_LT((mirrored(mirrored(u)) - u).norm(), 1e-11 * u.norm());
        const Operators operators =
          AssembleOperators(stages.GetGeometry(), component, degree, bias);
        for (const SparseMatrix& matrix : { operators.Energy, operators.Mass })
        {
          const ComplexVector image = matrix * u;
          EXPECT_LT((matrix * mirrored(u) - mirrored(image)).norm(), 1e-10 * image.norm());
        }
      }
    }
  }
}

TEST(NonOrientable, IndicesSumUpToTheEulerCharacteristic)
{
  for (int degree = 1; degree <= 16; ++degree)
  {
    for (const double bias : { -0.7, 0.0, 1.0 })
    {
      for (const auto& [surface, characteristic] : std::vector<std::pair<Surface, int>>{
             { ProjectivePlane(0), 1 }, { ProjectivePlane(1), 1 }, { KleinBottle(7, 5), 0 } })
      {
        const Result result = Compute(surface, degree, bias);
        ASSERT_EQ(result.Components.size(), 1u);
        const ComponentReport& report = result.Components[0];
        EXPECT_TRUE(report.Closed);
        EXPECT_TRUE(report.Converged);
        EXPECT_EQ(report.EulerCharacteristic, characteristic);
        EXPECT_EQ(report.Vertices, static_cast<Index>(surface.Points.size()));
        EXPECT_EQ(report.Triangles, static_cast<Index>(surface.Triangles.size()));
        EXPECT_EQ(report.IndexSum, degree * characteristic) << degree << " " << bias;
        EXPECT_EQ(
          std::accumulate(result.SingularityIndex.begin(), result.SingularityIndex.end(), 0),
          degree * characteristic);
        EXPECT_EQ(result.OriginalPoint.size(), surface.Points.size());
        EXPECT_TRUE(result.SplitTriangles.empty());
      }
    }
  }
}

TEST(NonOrientable, HasTheEigenvalueOfItsCover)
{
  for (const int degree : { 1, 2, 3, 4, 6 })
  {
    for (const double bias : { 0.0, -0.6 })
    {
      const Result once = Compute(MoebiusStrip(24, 4), degree, bias);
      const Result twice = Compute(TwiceAroundMoebiusStrip(24, 4), degree, bias);
      EXPECT_EQ(twice.Repaired.NonOrientableComponents, 0);
      EXPECT_NEAR(once.Components[0].Eigenvalue, twice.Components[0].Eigenvalue,
        1e-9 * twice.Components[0].Eigenvalue + 1e-12);
      EXPECT_NEAR(
        once.Components[0].SmoothnessEnergy, once.Components[0].Eigenvalue, 1e-6 * degree);
    }
  }
}

TEST(NonOrientable, TheFieldIsSmoothEverywhere)
{
  for (const int degree : { 1, 2, 3, 4, 5, 6 })
  {
    for (const Surface& surface : { MoebiusStrip(80, 8), KleinBottle(80, 54) })
    {
      const Result result = Compute(surface, degree);
      EXPECT_LT(LargestTurn(surface, result), 15.0) << degree;
    }
  }
  // The measure sees a seam: vectors turn back where they come around the strip as normals do.
  const Surface strip = MoebiusStrip(80, 8);
  Result torn = Compute(strip, 1);
  for (Index i = 0; i < 9; ++i)
  {
    torn.Representation[i] = -torn.Representation[i];
  }
  EXPECT_GT(LargestTurn(strip, torn), 150.0);
}

TEST(NonOrientable, TheSeamIsNowhere)
{
  // Other orders and windings of the triangles, and so another spanning tree: the same field.
  for (const int degree : { 1, 2, 3, 4 })
  {
    for (const Surface& surface : { MoebiusStrip(30, 4), KleinBottle(20, 12), ProjectivePlane(2) })
    {
      Options options;
      options.Degree = degree;
      options.Tolerance = 1e-11;
      const Result expected = DirectionField(surface).Compute(options);
      for (unsigned seed = 1; seed < 4; ++seed)
      {
        std::vector<Index> newPoint, newTriangle;
        Surface shuffled = Shuffled(surface, seed, newPoint, newTriangle);
        for (std::size_t t = 0; t < shuffled.Triangles.size(); t += seed + 1)
        {
          std::swap(shuffled.Triangles[t][0], shuffled.Triangles[t][1]);
        }
        const Result result = DirectionField(shuffled).Compute(options);
        for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
        {
          if (std::abs(expected.Representation[i]) > 0.05)
          {
            EXPECT_LT(Deviation(result, newPoint[i], expected.Direction(i, 0)), 1e-3);
          }
        }
        for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
        {
          EXPECT_EQ(result.SingularityIndex[newTriangle[t]], expected.SingularityIndex[t]);
        }
      }
    }
  }
}

TEST(NonOrientable, FollowsConstraintsAndGuidance)
{
  const Surface strip = MoebiusStrip(80, 8);
  for (const int degree : { 1, 2, 3, 4 })
  {
    for (const ConstraintSolver solver :
      { ConstraintSolver::LeastSquares, ConstraintSolver::Energy })
    {
      Options options;
      options.Degree = degree;
      options.ConstraintSolver = solver;
      options.ConstrainBoundary = true;
      const Result result = DirectionField(strip).Compute(options);
      EXPECT_TRUE(result.Components[0].Converged);
      EXPECT_EQ(result.Components[0].Constraints, 160);
      EXPECT_EQ(Count(result, ConstraintKind::Boundary), 160);
      EXPECT_LT(LargestTurn(strip, result), 25.0);
      for (Index i = 0; i < 80; ++i)
      {
        // Along the edge to the next point of the side.
        const Index here = 9 * i;
        const Index next = i == 79 ? 8 : here + 9;
        const Vector3 edge = (strip.Points[next] - strip.Points[here]).normalized();
        const double forth = Deviation(result, here, edge);
        const double back = Deviation(result, here, -edge);
        EXPECT_LT(std::min(forth, back), 6.0);
      }
    }
  }

  // Vectors in space know no side.
  Guidance guidance;
  for (const Vector3& p : strip.Points)
  {
    guidance.Vectors.push_back(Vector3::UnitZ().cross(p) + 0.3 * p);
  }
  for (const int degree : { 1, 2, 3, 4 })
  {
    Options options;
    options.Degree = degree;
    options.Alignment = Alignment::PointVectors;
    options.AlignmentStrength = 1.0;
    const Result result = DirectionField(strip).Compute(options, guidance);
    for (Index i = 0; i < static_cast<Index>(strip.Points.size()); ++i)
    {
      const Vector3 tangential =
        guidance.Vectors[i] - guidance.Vectors[i].dot(result.Normal[i]) * result.Normal[i];
      EXPECT_NEAR(Deviation(result, i, tangential), 0.0, 1e-6);
    }
  }
}

TEST(NonOrientable, CurvatureGuidesCrossesButNoLines)
{
  const Surface bottle = KleinBottle(60, 40);
  Options options;
  options.Degree = 4;
  options.Alignment = Alignment::PrincipalCurvature;
  options.AlignmentStrength = 0.9;
  options.ConstrainCurvature = true;
  const Result crosses = DirectionField(bottle).Compute(options);
  EXPECT_TRUE(crosses.Notes.empty());
  EXPECT_GT(Count(crosses, ConstraintKind::Curvature), 0);
  EXPECT_EQ(crosses.Components[0].IndexSum, 0);
  double along = 0.0;
  for (Index i = 0; i < static_cast<Index>(bottle.Points.size()); ++i)
  {
    along += Deviation(crosses, i, crosses.Curvature->PrincipalDirection0[i]);
  }
  EXPECT_LT(along / static_cast<double>(bottle.Points.size()), 8.0);

  options.Degree = 2;
  const Result lines = DirectionField(bottle).Compute(options);
  ASSERT_FALSE(lines.Notes.empty());
  EXPECT_NE(lines.Notes[0].find("change places"), std::string::npos);
  EXPECT_EQ(Count(lines, ConstraintKind::Curvature), 0);
  Options free;
  free.Degree = 2;
  EXPECT_EQ(lines.Representation, DirectionField(bottle).Compute(free).Representation);
}

TEST(NonOrientable, OtherComponentsAreNotTouched)
{
  const Surface potato = Potato(1);
  const Result alone = Compute(potato, 4);
  const Result joined = Compute(Joined(potato, MoebiusStrip(20, 3)), 4);
  ASSERT_EQ(joined.Components.size(), 2u);
  EXPECT_EQ(joined.Components[0].Eigenvalue, alone.Components[0].Eigenvalue);
  EXPECT_TRUE(std::equal(
    alone.Representation.begin(), alone.Representation.end(), joined.Representation.begin()));
}

TEST(NonOrientable, GlyphsLieAlongTheFieldWhereCornersMeanDifferentSides)
{
  for (const int degree : { 1, 2, 3, 4 })
  {
    const Surface strip = MoebiusStrip(120, 8);
    const Result result = Compute(strip, degree);
    const SurfaceIncidence incidence(strip);
    const PointDirections field = Of(result);
    const GivenField given(strip, field);
    const FieldInterpolation interpolation(incidence, given, field);
    int torn = 0;
    for (Index t = 0; t < incidence.GetNumberOfTriangles(); ++t)
    {
      const Triangle& corners = strip.Triangles[t];
      torn += result.Normal[corners[0]].dot(result.Normal[corners[1]]) < 0.0;
      const DirectionsAt middle = interpolation.At({ t, { 1.0 / 3, 1.0 / 3, 1.0 / 3 } });
      for (int k = 0; k < degree; ++k)
      {
        EXPECT_LT(Deviation(result, corners[0], middle.Turned(k, degree)), 10.0);
      }
    }
    EXPECT_GT(torn, 0);
  }
}
