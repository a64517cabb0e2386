// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Interpolation/FieldInterpolant.h"
#include "Interpolation/GivenField.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace DirectionFields;

namespace
{
/// A field as it comes back from a file: numbers in single precision, and any of the n directions first.
PointDirections FromFile(const Result& result)
{
  PointDirections field = Fields::Of(result);
  field.Direction = [&result](Index point, int k)
  {
    const Vector3 direction = result.Direction(point, (k + 3 * point) % result.Degree);
    return Vector3(direction.cast<float>().cast<double>());
  };
  field.Magnitude = [&result](Index point)
  { return static_cast<double>(static_cast<float>(std::abs(result.Representation[point]))); };
  return field;
}

std::vector<int> IndicesOfInput(const GivenField& field)
{
  std::vector<int> indices(field.GetSurface().Triangles.size(), 0);
  const std::vector<int> given = field.Indices();
  for (std::size_t t = 0; t < indices.size(); ++t)
  {
    const Index triangle = field.GetMeshTriangles()[t];
    indices[t] = triangle == None ? 0 : given[triangle];
  }
  return indices;
}

Surface OutputSurface(const Surface& surface, const Result& result)
{
  Surface split;
  for (const Index i : result.OriginalPoint)
  {
    split.Points.push_back(surface.Points[i]);
  }
  split.Triangles = result.SplitTriangles.empty() ? surface.Triangles : result.SplitTriangles;
  return split;
}
}

TEST(GivenField, HasTheIndicesAndVectorsOfTheFieldThatWasWritten)
{
  const std::vector<Surface> surfaces = { Meshes::Potato(3), Meshes::Torus(24, 12),
    Meshes::Hemisphere(3), Meshes::MoebiusStrip(14, 2), Meshes::KleinBottle(24, 16),
    Meshes::Soup(Meshes::Potato(2)), Meshes::BadSphere(3, 0.5, 2),
    Meshes::Joined(Meshes::Potato(2), Meshes::Square(5)) };
  for (const Surface& surface : surfaces)
  {
    for (const int degree : { 1, 2, 3, 4, 6 })
    {
      const Result result = Fields::Compute(surface, degree);
      const Surface output = OutputSurface(surface, result);
      const GivenField field(output, FromFile(result));
      EXPECT_EQ(IndicesOfInput(field), result.SingularityIndex);
      for (Index t = 0; t < static_cast<Index>(output.Triangles.size()); ++t)
      {
        const Index triangle = field.GetMeshTriangles()[t];
        ASSERT_NE(triangle, None);
        for (int c = 0; c < 3; ++c)
        {
          const int corner = field.MeshCorner(triangle, c);
          ASSERT_NE(corner, None);
          EXPECT_EQ(field.PointAt(triangle, corner), output.Triangles[t][c]);
          const Index v = field.GetMesh().Tail(3 * triangle + corner);
          EXPECT_NEAR(std::abs(field.GetSection()[v]),
            std::abs(result.Representation[output.Triangles[t][c]]), 1e-5);
        }
      }
    }
  }
}

TEST(GivenField, LiesInTheTriangle)
{
  const Surface surface = Meshes::Potato(2);
  const Result result = Fields::Compute(surface, 4);
  const GivenField field(surface, Fields::Of(result));
  for (Index t = 0; t < field.GetMesh().GetNumberOfTriangles(); ++t)
  {
    const TriangleInSpace triangle = field.InSpace(t);
    const FlatTriangle flat(field.GetGeometry(), t);
    for (int c = 0; c < 3; ++c)
    {
      const Vector3 edge = (triangle.Corners[(c + 1) % 3] - triangle.Corners[c]).normalized();
      EXPECT_LT((triangle.Direction(flat.Along(c)) - edge).norm(), 1e-12);
    }
    EXPECT_NEAR(triangle.X.cross(triangle.Y).dot(triangle.Normal), 1.0, 1e-12);
  }
}

TEST(GivenField, KeepsSeamsWhereTheDirectionsDiffer)
{
  Surface surface = Meshes::Joined(Meshes::Square(3), Meshes::Square(3));
  for (Index i = 16; i < 32; ++i)
  {
    surface.Points[i].x() += 1.0;
  }
  const auto along = [](const Vector3&) { return 0.3; };
  const GivenField one(surface, Fields::PlanarField(surface, 4, along));
  EXPECT_EQ(one.GetMesh().GetComponents().size(), 1u);
  PointDirections torn = Fields::PlanarField(surface, 4, along);
  const auto direction = torn.Direction;
  torn.Direction = [direction](Index point, int k) -> Vector3
  { return direction(point < 16 ? point : 0, k) + (point < 16 ? 0.0 : 0.2) * Vector3::UnitX(); };
  const GivenField two(surface, torn);
  EXPECT_EQ(two.GetMesh().GetComponents().size(), 2u);
}

TEST(GivenField, LeavesOutWhatIsUnsound)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Surface surface = Meshes::Potato(1);
  const Result result = Fields::Compute(surface, 2);
  surface.Points[3].x() = nan;
  surface.Triangles[7][1] = 100000;
  surface.Triangles[9][2] = -4;
  PointDirections directions = Fields::Of(result);
  const auto direction = directions.Direction;
  directions.Direction = [&](Index point, int k) {
    return point == 5 ? Vector3(nan, 0, 0) : point == 6 ? Vector3::Zero() : direction(point, k);
  };
  const GivenField field(surface, directions);
  EXPECT_EQ(field.GetMeshTriangles()[7], None);
  EXPECT_EQ(field.GetMeshTriangles()[9], None);
  for (Index v = 0; v < field.GetMesh().GetNumberOfVertices(); ++v)
  {
    const Index point = field.GetMesh().Point(v);
    EXPECT_NE(point, 3);
    EXPECT_EQ(field.GetSection()[v] == 0.0, point == 5 || point == 6);
  }
  EXPECT_EQ(GivenField(Surface(), directions).GetMesh().GetNumberOfTriangles(), 0);
  Surface nothing;
  nothing.Triangles = { { 0, 1, 2 } };
  EXPECT_EQ(GivenField(nothing, directions).GetMesh().GetNumberOfTriangles(), 0);
}
