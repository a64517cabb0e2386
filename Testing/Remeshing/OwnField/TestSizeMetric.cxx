// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "OwnField/SizeMetric.h"

#include "Meshes/Surfaces.h"
#include "Remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <string>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
template <typename Value>
std::vector<double> AtPoints(const Surface& surface, const Value& value)
{
  std::vector<double> values;
  for (const Vector3& point : surface.Points)
  {
    values.push_back(value(point));
  }
  return values;
}

RemeshOptions WithSizes(std::vector<double>&& sizes, bool addsPairs)
{
  RemeshOptions options;
  options.NumberOfFaces = 3000;
  options.Sizing = std::move(sizes);
  options.AddIrregularPairs = addsPairs;
  return options;
}

RemeshResult Remeshed(const Surface& surface, const RemeshOptions& options)
{
  return Remesh(std::make_shared<Surface>(surface)).Compute(options);
}

SurfaceGeometry InSizes(const Surface& surface, const std::vector<double>& sizes)
{
  return { TriangleMesh(surface), surface, sizes };
}

/// From 1 along a great circle to 5 far from it.
double Front(const Vector3& p)
{
  const double distance = (0.8 * p.x() + 0.6 * p.z()) / 0.35;
  return 1.0 + 4.0 * (1.0 - std::exp(-distance * distance));
}
}

/// Of an edge length the geometric mean of the sizes at its ends is divided out.
TEST(SizeMetric, DividesLengthsBySizes)
{
  const Surface potato = Meshes::Potato(2);
  const std::vector<double> sizes =
    AtPoints(potato, [](const Vector3& p) { return std::exp(0.3 * p.x() - 0.2 * p.y()); });
  const SurfaceGeometry own(potato);
  const SurfaceGeometry divided = InSizes(potato, sizes);
  const TriangleMesh& mesh = own.Mesh;
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = mesh.HalfEdge(e);
    const double square = sizes[mesh.Point(mesh.Tail(h))] * sizes[mesh.Point(mesh.Head(h))];
    const double before = own.Lengths.SquaredLength[e] * own.Lengths.Unit[0] * own.Lengths.Unit[0];
    const double after =
      divided.Lengths.SquaredLength[e] * divided.Lengths.Unit[0] * divided.Lengths.Unit[0];
    EXPECT_NEAR(after * square, before, 1e-12 * before);
  }
}

/// In the metric of sizes |p|^2 the plane without its origin is the plane again, turned inside out
/// by an inversion.
TEST(SizeMetric, SizesOfAnInversionMakeThePlaneThePlane)
{
  constexpr int cells = 12;
  Surface square = Meshes::Square(cells);
  for (Vector3& p : square.Points)
  {
    p += Vector3(0.5, 0.25, 0.0);
  }
  Surface inverted = square;
  for (Vector3& p : inverted.Points)
  {
    p /= p.squaredNorm();
  }
  const SurfaceGeometry divided =
    InSizes(square, AtPoints(square, [](const Vector3& p) { return p.squaredNorm(); }));
  const SurfaceGeometry plane(inverted);
  // The two have their triangles in different orders.
  const auto anglesOf = [](const SurfaceGeometry& geometry)
  {
    const TriangleMesh& mesh = geometry.Mesh;
    std::map<std::array<Index, 2>, double> angles;
    for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      angles[{ mesh.Point(mesh.Tail(h)), mesh.Point(mesh.Head(h)) }] =
        geometry.Lengths.CornerAngle(mesh, h);
    }
    return angles;
  };
  const auto expected = anglesOf(plane);
  const auto angles = anglesOf(divided);
  ASSERT_EQ(angles.size(), expected.size());
  for (const auto& [edge, angle] : expected)
  {
    ASSERT_EQ(angles.count(edge), 1U);
    EXPECT_NEAR(angles.at(edge), angle, 1e-9);
  }
}

/// Sizes get no larger than they were, and along no edge more than a factor of 1.3 apart.
TEST(SizeMetric, SizesDoNotJump)
{
  const Surface square = Meshes::Square(20);
  const SurfaceGeometry geometry(square);
  const auto jump = [](const Vector3& p) { return p.x() < 0.5 ? 0.2 : 5.0; };
  const std::vector<double> given = AtPoints(square, jump);
  const std::vector<double> sizes = SizesOfMetric(geometry, given);
  ASSERT_EQ(sizes.size(), given.size());
  for (const Triangle& t : square.Triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_LE(sizes[t[c]], 1.3 * sizes[t[(c + 1) % 3]] * (1.0 + 1e-12));
      EXPECT_LE(sizes[t[c]], given[t[c]]);
    }
  }
  EXPECT_EQ(*std::min_element(sizes.begin(), sizes.end()), 0.2);
  EXPECT_TRUE(SizesOfMetric(geometry, std::vector<double>(given.size(), 3.0)).empty());
  EXPECT_TRUE(SizesOfMetric(geometry, {}).empty());
}

/// Nor do they across a line where three sheets meet.
TEST(SizeMetric, SizesDoNotJumpBetweenSheets)
{
  constexpr int cells = 8;
  Surface rib = Meshes::Square(cells);
  const auto plate = static_cast<Index>(rib.Points.size());
  std::map<int, Index> last;
  for (Index p = 0; p < plate; ++p)
  {
    if (std::abs(rib.Points[p].y() - 0.5) < 1e-9)
    {
      last[static_cast<int>(std::lround(rib.Points[p].x() * cells))] = p;
    }
  }
  ASSERT_EQ(last.size(), cells + 1U);
  for (int row = 1; row <= cells; ++row)
  {
    std::map<int, Index> next;
    for (const auto& [column, p] : last)
    {
      next[column] = static_cast<Index>(rib.Points.size());
      rib.Points.emplace_back(rib.Points[p].x(), 0.5, static_cast<double>(row) / cells);
    }
    for (int column = 0; column < cells; ++column)
    {
      rib.Triangles.push_back({ last[column], last[column + 1], next[column] });
      rib.Triangles.push_back({ next[column], last[column + 1], next[column + 1] });
    }
    last = next;
  }
  const SurfaceGeometry geometry(rib);
  const std::vector<double> sizes = SizesOfMetric(
    geometry, AtPoints(rib, [](const Vector3& p) { return p.z() > 0.0 ? 0.2 : 5.0; }));
  ASSERT_EQ(sizes.size(), rib.Points.size());
  for (const Triangle& t : rib.Triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_LE(sizes[t[c]], 1.3 * sizes[t[(c + 1) % 3]] * (1.0 + 1e-12));
    }
  }
}

/// On needles and caps, as CAD programs write them, lengths divided by sizes that jump are those of
/// triangles.
TEST(SizeMetric, NeedlesAndCapsStayTriangles)
{
  Surface strip;
  constexpr int needles = 60;
  for (Index k = 0; k <= needles; ++k)
  {
    strip.Points.emplace_back(0.03 * k, 0.0, 0.0);
    strip.Points.emplace_back(0.03 * k, 1.0, 0.0);
    if (k > 0)
    {
      strip.Triangles.push_back({ 2 * k - 2, 2 * k, 2 * k - 1 });
      strip.Triangles.push_back({ 2 * k - 1, 2 * k, 2 * k + 1 });
    }
  }
  // Beside the strip, and the largest size at the apex.
  const auto cap = static_cast<Index>(strip.Points.size());
  strip.Points.insert(
    strip.Points.end(), { { 0.0, 3.0, 0.0 }, { 1.0, 3.0, 0.0 }, { 0.5, 3.05, 0.0 } });
  strip.Triangles.push_back({ cap, cap + 1, cap + 2 });
  std::vector<double> wanted =
    AtPoints(strip, [](const Vector3& p) { return p.x() < 0.8 ? 0.2 : 5.0; });
  wanted[cap + 1] = 0.2;
  wanted[cap + 2] = 5.0;
  const std::vector<double> sizes = SizesOfMetric(SurfaceGeometry(strip), wanted);
  ASSERT_EQ(sizes.size(), strip.Points.size());
  for (const Triangle& t : strip.Triangles)
  {
    std::array<double, 3> lengths{};
    for (int c = 0; c < 3; ++c)
    {
      const Index p = t[c];
      const Index q = t[(c + 1) % 3];
      lengths[c] = (strip.Points[p] - strip.Points[q]).norm() / std::sqrt(sizes[p] * sizes[q]);
    }
    std::sort(lengths.begin(), lengths.end());
    EXPECT_LT(lengths[2], lengths[0] + lengths[1]);
  }
}

/// A direction along an edge is along that edge in the other metric, too, and back again all
/// directions are what they were.
TEST(SizeMetric, DirectionsKeepToTheirEdges)
{
  for (const Surface& surface : { Meshes::Potato(2), Meshes::Hemisphere(2) })
  {
    const SurfaceGeometry own(surface);
    const SurfaceGeometry divided = InSizes(
      surface, AtPoints(surface, [](const Vector3& p) { return std::exp(0.6 * p.z() + p.x()); }));
    const TriangleMesh& mesh = own.Mesh;
    for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      std::vector<Index> fan;
      mesh.GetFan(v, fan);
      const Index h = fan.back();
      std::vector<Complex> section(mesh.GetNumberOfVertices(), 1.0);
      section[v] = std::polar(1.0, divided.Transport.EdgeAngle[h]);
      // A field of one direction has no others that turn by different angles.
      TurnToFrames(divided, own, 1, section);
      EXPECT_NEAR(std::abs(section[v] - std::polar(1.0, own.Transport.EdgeAngle[h])), 0.0, 1e-9);
      section[v] = std::polar(1.0, own.Transport.EdgeAngle[h] + 0.3);
      const std::vector<Complex> before = section;
      TurnToFrames(own, divided, 1, section);
      TurnToFrames(divided, own, 1, section);
      if (!mesh.IsBoundary(v))
      {
        EXPECT_NEAR(std::abs(section[v] - before[v]), 0.0, 1e-9);
      }
    }
  }
}

/// The field has pairs of singularities that even sizes do not need, and edges get their lengths.
TEST(SizeMetric, PairsOfIrregularVerticesMeetTheSizes)
{
  const Surface sphere = Meshes::Icosphere(5);
  const RemeshResult without = Remeshed(sphere, WithSizes(AtPoints(sphere, Front), false));
  const RemeshResult with = Remeshed(sphere, WithSizes(AtPoints(sphere, Front), true));
  RecordProperty("Without", std::to_string(without.EdgesAsWanted));
  RecordProperty("With", std::to_string(with.EdgesAsWanted));
  EXPECT_GT(with.EdgesAsWanted, 0.9);
  EXPECT_LT(without.EdgesAsWanted, with.EdgesAsWanted - 0.15);
  EXPECT_GT(with.IrregularVertices, without.IrregularVertices);
  EXPECT_EQ(with.EulerCharacteristicAfter, 2);
}

/// The same sizes everywhere need no pairs, and a mesh after one of other sizes is as a first one.
TEST(SizeMetric, IsMadeAnewForOtherSizes)
{
  const Surface sphere = Meshes::Icosphere(4);
  const RemeshOptions even = WithSizes(std::vector<double>(sphere.Points.size(), 2.0), true);
  RemeshOptions evenWithout = even;
  evenWithout.AddIrregularPairs = false;
  EXPECT_EQ(Remeshed(sphere, even).Points, Remeshed(sphere, evenWithout).Points);
  Remesh remesh(std::make_shared<Surface>(sphere));
  remesh.Compute(even);
  const RemeshOptions front = WithSizes(AtPoints(sphere, Front), true);
  EXPECT_EQ(remesh.Compute(front).Points, Remeshed(sphere, front).Points);
  RemeshOptions frontWithout = front;
  frontWithout.AddIrregularPairs = false;
  EXPECT_EQ(remesh.Compute(frontWithout).Points, Remeshed(sphere, frontWithout).Points);
  EXPECT_EQ(remesh.Compute(front).Points, Remeshed(sphere, front).Points);
}
