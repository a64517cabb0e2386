// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Charts/FieldMatching.h"
#include "Curves/CurveCut.h"
#include "OwnField/FreeEnds.h"
#include "OwnField/OwnField.h"

#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
/// The unit square with a line in the middle, at this angle to its sides.
struct Example
{
  Example(double length, double degrees)
    : Cut(CutAlong(Meshes::Square(40), { { Line(length, degrees) }, {} }))
    , Geometry(this->Cut.Cut)
    , IsFeature(this->Geometry.Mesh.GetNumberOfEdges(), 0)
  {
    const std::set<std::array<Index, 2>> edges(this->Cut.Edges.begin(), this->Cut.Edges.end());
    const TriangleMesh& mesh = this->Geometry.Mesh;
    for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
    {
      const Index a = mesh.Point(mesh.Tail(mesh.HalfEdge(e)));
      const Index b = mesh.Point(mesh.Head(mesh.HalfEdge(e)));
      this->IsFeature[e] = edges.count({ a, b }) + edges.count({ b, a }) > 0 ? 1 : 0;
    }
  }

  static std::vector<Vector3> Line(double length, double degrees)
  {
    const double angle = degrees * Pi / 180.0;
    const Vector3 half = 0.5 * length * Vector3(std::cos(angle), std::sin(angle), 0.0);
    const Vector3 middle(0.5, 0.5, 0.0);
    return { middle - half, middle + half };
  }

  std::vector<Complex> Field() const
  {
    OwnFieldSettings settings;
    settings.Face = Face;
    return OwnField(std::make_shared<Surface>(this->Cut.Cut), this->Geometry, this->IsFeature,
      settings, {}, Progress());
  }

  /// Four times the index of the field around each place that has one, from the points of its
  /// triangle.
  std::vector<std::pair<Vector3, int>> Singularities() const
  {
    const FieldMatching matching(this->Geometry, 4, this->Field());
    std::vector<std::pair<Vector3, int>> found;
    const TriangleMesh& mesh = this->Geometry.Mesh;
    for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
    {
      if (matching.SingularityIndex[t] != 0)
      {
        found.emplace_back(
          this->Geometry.Positions[mesh.Tail(3 * t)], matching.SingularityIndex[t]);
      }
    }
    return found;
  }

  static constexpr double Face = 0.02;
  CurveCut Cut;
  SurfaceGeometry Geometry;
  std::vector<char> IsFeature;
};
}

TEST(FreeEnds, LineThatTurnsTheFieldHasSingularitiesAtBothEnds)
{
  for (const double degrees : { 38.0, 42.0, 45.0 })
  {
    const Example example(0.6, degrees);
    const std::vector<Vector3> ends = Example::Line(0.6, degrees);
    std::array<int, 2> count{};
    int sum = 0;
    for (const auto& [place, index] : example.Singularities())
    {
      // The triangles are 1/40 wide.
      const bool isFirst = (place - ends[0]).norm() < 0.1;
      EXPECT_TRUE(isFirst || (place - ends[1]).norm() < 0.1) << place.transpose();
      ++count[isFirst ? 0 : 1];
      sum += index;
    }
    EXPECT_GT(count[0], 0) << degrees;
    EXPECT_GT(count[1], 0) << degrees;
    EXPECT_EQ(sum, 0) << degrees;
  }
}

TEST(FreeEnds, HalfwayBetweenTwoDirectionsOneSideTurnsTheOtherWay)
{
  const std::vector<std::pair<Vector3, int>> found = Example(0.6, 45.0).Singularities();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(std::abs(found[0].second), 1);
  EXPECT_EQ(found[0].second, -found[1].second);
}

TEST(FreeEnds, DirectionsTurnTheOtherWayAroundTheOtherEnd)
{
  // Along the line the field is turned by 42 degrees, and by less and less beside it.
  constexpr double turned = 42.0 * Pi / 180.0;
  const Example example(0.6, 42.0);
  const std::vector<Vector3> ends = Example::Line(0.6, 42.0);
  const SurfaceGeometry& geometry = example.Geometry;
  std::vector<Complex> section;
  for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
  {
    const Vector3 edge = ends[1] - ends[0];
    const Vector3& p = geometry.Positions[v];
    const double along = std::clamp((p - ends[0]).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    const double angle = turned * std::max(0.0, 1.0 - (p - ends[0] - along * edge).norm() / 0.2);
    const Complex direction =
      geometry.Frames.Tangential(v, Vector3(std::cos(angle), std::sin(angle), 0.0));
    section.push_back(std::polar(1.0, 4.0 * std::arg(direction)));
  }
  const FreeEnds found(geometry, 4, example.IsFeature, section, Example::Face);
  ASSERT_FALSE(found.IsEmpty());
  const std::vector<Vector3> directions = found.Directions();
  std::array<double, 2> turns{};
  for (std::size_t k = 0; k < 2; ++k)
  {
    const Vector3 back = (ends[1 - k] - ends[k]).normalized();
    for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
    {
      const Vector3 from = geometry.Positions[v] - ends[k];
      if (directions[v].isZero(0.0) || from.norm() > 0.1)
      {
        continue;
      }
      // Counter-clockwise from the line the directions turn by a quarter of the angle around. The
      // line ends at a point of the plane within a twentieth of its edges.
      double around = std::atan2(back.cross(from).z(), back.dot(from));
      around += around < 0.0 ? 2.0 * Pi : 0.0;
      const double turn = std::atan2(back.cross(directions[v]).z(), back.dot(directions[v]));
      EXPECT_NEAR(std::abs(turn), around / 4.0, 0.1);
      turns[k] += turn;
    }
  }
  EXPECT_LT(turns[0] * turns[1], 0.0);
}

TEST(FreeEnds, LinesThatTurnTheFieldLittleHaveNone)
{
  EXPECT_TRUE(Example(0.6, 20.0).Singularities().empty());
  EXPECT_TRUE(Example(0.15, 42.0).Singularities().empty());
}

TEST(FreeEnds, FluxIsThatOfTheHarmonicRotation)
{
  // Sizes jump by more than 20 beside the long line only, as the capacity of a slit in a square
  // says: 2 pi over the logarithm of the conformal radii, .54 and a quarter of the length, times
  // the angle. That is 3.2 at 38 degrees, and 2.8 at 33.
  for (const auto& [length, degrees, turns] :
    { std::tuple(0.6, 40.0, true), { 0.6, 31.0, false }, { 0.3, 44.0, false } })
  {
    const Example example(length, degrees);
    const double angle = degrees * Pi / 180.0;
    const double capacity = 2.0 * Pi / std::log(0.54 / (0.25 * length));
    EXPECT_EQ(capacity * angle > 3.0, turns);
    EXPECT_EQ(example.Singularities().empty(), !turns) << length << ' ' << degrees;
  }
}
