// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/TriangleMesh.h"
#include "MeshError.h"
#include "Meshes/Surfaces.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
/// The kind and id of the error of a surface; the message must name the id.
std::pair<MeshError::Kind, Index> ErrorOf(const Surface& surface)
{
  try
  {
    const TriangleMesh mesh(surface);
  }
  catch (const MeshError& error)
  {
    EXPECT_NE(std::string(error.what()).find(std::to_string(error.GetId())), std::string::npos)
      << error.what();
    return { error.GetKind(), error.GetId() };
  }
  ADD_FAILURE() << "no error";
  return { MeshError::Kind::InvalidPointId, -7 };
}

void ExpectConsistent(const TriangleMesh& mesh)
{
  for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Index twin = mesh.Twin(h);
    if (twin != None)
    {
      ASSERT_EQ(mesh.Twin(twin), h);
      ASSERT_EQ(mesh.Tail(twin), mesh.Head(h));
      ASSERT_EQ(mesh.Head(twin), mesh.Tail(h));
      ASSERT_EQ(mesh.Edge(twin), mesh.Edge(h));
    }
  }
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    ASSERT_EQ(mesh.Tail(mesh.Outgoing(v)), v);
  }
}
}

TEST(TriangleMesh, CountsOfKnownSurfaces)
{
  const std::vector<std::pair<Surface, int>> surfaces = { { Tetrahedron(), 2 }, { Octahedron(), 2 },
    { Cube(), 2 }, { Icosphere(2), 2 }, { Torus(7, 5), 0 }, { DoubleTorus(), -2 }, { Disk(4), 1 },
    { Cylinder(9, 3, 1.0), 0 }, { Square(3), 1 } };
  for (const auto& [surface, chi] : surfaces)
  {
    const TriangleMesh mesh(surface);
    ExpectConsistent(mesh);
    ASSERT_EQ(mesh.GetComponents().size(), 1u);
    EXPECT_EQ(
      mesh.GetNumberOfVertices() - mesh.GetNumberOfEdges() + mesh.GetNumberOfTriangles(), chi);
    EXPECT_EQ(mesh.GetRepairs().ReversedTriangles, 0);
  }
  EXPECT_TRUE(TriangleMesh(Torus(7, 5)).GetComponents()[0].Closed);
  EXPECT_FALSE(TriangleMesh(Disk(4)).GetComponents()[0].Closed);
}

TEST(TriangleMesh, BoundaryVerticesStartAtTheFirstEdgeOfTheFan)
{
  const TriangleMesh mesh(Disk(4));
  Index boundary = 0;
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    boundary += mesh.IsBoundary(v);
  }
  EXPECT_EQ(boundary, 24);
}

TEST(TriangleMesh, ComponentsAreContiguous)
{
  // Triangles of two surfaces alternate.
  const Surface joined = Joined(Cube(), Tetrahedron());
  Surface mixed{ joined.Points, {} };
  for (std::size_t k = 0; k < 12; ++k)
  {
    mixed.Triangles.push_back(joined.Triangles[k]);
    if (k < 4)
    {
      mixed.Triangles.push_back(joined.Triangles[12 + k]);
    }
  }
  const TriangleMesh mesh(mixed);
  ExpectConsistent(mesh);
  ASSERT_EQ(mesh.GetComponents().size(), 2u);
  const auto& cube = mesh.GetComponents()[0];
  const auto& tetrahedron = mesh.GetComponents()[1];
  EXPECT_EQ(cube.Vertices(), 8);
  EXPECT_EQ(cube.Edges(), 18);
  EXPECT_EQ(cube.Triangles(), 12);
  EXPECT_EQ(tetrahedron.Vertices(), 4);
  EXPECT_EQ(tetrahedron.Edges(), 6);
  EXPECT_EQ(tetrahedron.FirstVertex, 8);
  for (Index t = tetrahedron.FirstTriangle; t < tetrahedron.EndTriangle; ++t)
  {
    EXPECT_EQ(mesh.InputTriangle(t) % 2, 1);
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      EXPECT_GE(mesh.Point(mesh.Tail(h)), 8);
    }
  }
}

TEST(TriangleMesh, TurnsTheMinority)
{
  Surface s = Icosphere(2);
  for (const std::size_t t : { 3u, 4u, 50u, 100u, 319u })
  {
    std::swap(s.Triangles[t][0], s.Triangles[t][1]);
  }
  const TriangleMesh mesh(s);
  ExpectConsistent(mesh);
  EXPECT_EQ(mesh.GetRepairs().ReversedTriangles, 5);
  // All point outwards again.
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    const Vector3& a = s.Points[mesh.Point(mesh.Tail(3 * t))];
    const Vector3& b = s.Points[mesh.Point(mesh.Tail(3 * t + 1))];
    const Vector3& c = s.Points[mesh.Point(mesh.Tail(3 * t + 2))];
    EXPECT_GT((b - a).cross(c - a).dot(a), 0.0);
  }
}

TEST(TriangleMesh, IgnoresCollapsedAndDuplicateTriangles)
{
  Surface s = Octahedron();
  s.Triangles.insert(s.Triangles.begin(), { 2, 2, 4 });
  s.Triangles.push_back({ 4, 0, 2 });
  s.Triangles.push_back({ 2, 0, 4 });
  const TriangleMesh mesh(s);
  ExpectConsistent(mesh);
  EXPECT_EQ(mesh.GetNumberOfTriangles(), 8);
  EXPECT_EQ(mesh.GetRepairs().CollapsedTriangles, 1);
  EXPECT_EQ(mesh.GetRepairs().DuplicateTriangles, 2);
  EXPECT_TRUE(mesh.GetComponents()[0].Closed);
  // The first of the equal ones stays.
  std::set<Index> kept;
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    kept.insert(mesh.InputTriangle(t));
  }
  EXPECT_EQ(kept, std::set<Index>({ 1, 2, 3, 4, 5, 6, 7, 8 }));

  const TriangleMesh pillow(
    Surface{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 1 } } });
  EXPECT_EQ(pillow.GetNumberOfTriangles(), 1);
  EXPECT_EQ(pillow.GetRepairs().DuplicateTriangles, 1);
}

TEST(TriangleMesh, RefusesInvalidPointIds)
{
  Surface s = Tetrahedron();
  s.Triangles[2][1] = 4;
  EXPECT_EQ(ErrorOf(s), std::pair(MeshError::Kind::InvalidPointId, Index(4)));
  s.Triangles[2][1] = -1;
  EXPECT_EQ(ErrorOf(s), std::pair(MeshError::Kind::InvalidPointId, Index(-1)));
}

TEST(TriangleMesh, RefusesCoordinatesTooLargeToComputeWithAndSaysWhatHelps)
{
  // Every library takes surfaces as meshes: what is refused here is refused by all of them.
  for (const double bad : { 1.1e300, -1e305, std::numeric_limits<double>::max() })
  {
    Surface s = Icosahedron();
    s.Points[5].y() = bad;
    s.Points[9].x() = bad;
    EXPECT_EQ(ErrorOf(s), std::pair(MeshError::Kind::NonFinitePoint, Index(5)));
    try
    {
      const TriangleMesh mesh(s);
      ADD_FAILURE() << bad;
    }
    catch (const MeshError& error)
    {
      EXPECT_EQ(std::string(error.what()),
        "2 points of the surface have coordinates beyond 1e300, too large to compute with, the first "
        "is point 5. Scale the surface down, or remove the cells at these points.");
    }
    // The first point that is nowhere is told before others that are far.
    s.Points[11].z() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(ErrorOf(s), std::pair(MeshError::Kind::NonFinitePoint, Index(11)));
    Surface unused = Icosahedron();
    unused.Points.emplace_back(bad, bad, bad);
    EXPECT_NO_THROW(TriangleMesh{ unused });
  }
  Surface largest = Icosahedron();
  largest.Points[5].y() = 1e300;
  EXPECT_NO_THROW(TriangleMesh{ largest });
}

TEST(TriangleMesh, RefusesNonFiniteCoordinatesOfUsedPointsOnly)
{
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() })
  {
    Surface s = Icosahedron();
    s.Points[5].y() = bad;
    s.Points[9].x() = bad;
    EXPECT_EQ(ErrorOf(s), std::pair(MeshError::Kind::NonFinitePoint, Index(5)));
    Surface unused = Icosahedron();
    unused.Points.emplace_back(bad, bad, bad);
    EXPECT_NO_THROW(TriangleMesh{ unused });
  }
}

TEST(TriangleMesh, SplitsNonManifoldEdgesIntoSheets)
{
  Surface fin = Square(2);
  fin.Points.emplace_back(0.5, 0.25, 1.0);
  // A third triangle on the edge from the middle of the lower side to the center.
  fin.Triangles.push_back({ 1, 4, 9 });
  const TriangleMesh mesh(fin);
  ExpectConsistent(mesh);
  EXPECT_EQ(mesh.GetRepairs().NonManifoldEdges, 1);
  // The slit reaches the border in point 1 and ends in the center, point 4: there the square has
  // one fan, in point 1 two, and the fin has its own.
  EXPECT_EQ(mesh.GetRepairs().NonManifoldPoints, 2);
  ASSERT_EQ(mesh.GetComponents().size(), 2u);
  EXPECT_EQ(mesh.GetComponents()[0].Vertices(), 10);
  EXPECT_EQ(mesh.GetComponents()[1].Vertices(), 3);
  Index split = 0;
  for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (mesh.IsNonManifold(h))
    {
      ++split;
      EXPECT_EQ(mesh.Twin(h), None);
      EXPECT_EQ(mesh.Point(mesh.Tail(h)) + mesh.Point(mesh.Head(h)), 5);
    }
  }
  EXPECT_EQ(split, 3);
}

TEST(TriangleMesh, SplitsPointsWhereFansMeet)
{
  // A bow-tie within a component, and two components that share a point.
  Surface bow = Disk(2);
  bow.Triangles.erase(bow.Triangles.begin() + 1);
  bow.Triangles.erase(bow.Triangles.begin() + 3);
  const TriangleMesh pinched(bow);
  ExpectConsistent(pinched);
  EXPECT_EQ(pinched.GetRepairs().NonManifoldPoints, 1);
  EXPECT_EQ(pinched.GetRepairs().NonManifoldEdges, 0);
  EXPECT_EQ(pinched.GetNumberOfVertices(), static_cast<Index>(bow.Points.size()) + 1);

  const Surface touching{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { -1, 0, 0 }, { -1, -1, 0 } },
    { { 1, 2, 0 }, { 0, 3, 4 } } };
  const TriangleMesh two(touching);
  ExpectConsistent(two);
  EXPECT_EQ(two.GetComponents().size(), 2u);
  EXPECT_EQ(two.GetNumberOfVertices(), 6);
  EXPECT_EQ(two.GetRepairs().NonManifoldPoints, 1);
}

TEST(TriangleMesh, CoversNonOrientableSurfaces)
{
  struct
  {
    Surface Input;
    int Characteristic;
    bool Closed;
  } surfaces[] = { { MoebiusStrip(12), 0, false }, { MoebiusStrip(15, 4), 0, false },
    { KleinBottle(14, 9), 0, true }, { ProjectivePlane(0), 1, true },
    { ProjectivePlane(2), 1, true } };
  for (const auto& [surface, characteristic, closed] : surfaces)
  {
    const TriangleMesh mesh(surface);
    ExpectConsistent(mesh);
    ASSERT_EQ(mesh.GetComponents().size(), 1u);
    const TriangleMesh::Component& component = mesh.GetComponents()[0];
    EXPECT_TRUE(component.IsCover);
    EXPECT_EQ(component.Closed, closed);
    EXPECT_EQ(component.Triangles(), 2 * static_cast<Index>(surface.Triangles.size()));
    EXPECT_EQ(component.Vertices(), 2 * static_cast<Index>(surface.Points.size()));
    EXPECT_EQ(component.Vertices() - component.Edges() + component.Triangles(), 2 * characteristic);
    EXPECT_EQ(mesh.GetRepairs().NonOrientableComponents, 1);
    EXPECT_EQ(mesh.GetRepairs().ReversedTriangles, 0);
    EXPECT_EQ(mesh.GetRepairs().NonManifoldPoints, 0);
    for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      const Index mirror = mesh.Mirror(h);
      ASSERT_EQ(mesh.Mirror(mirror), h);
      ASSERT_EQ(mesh.InputTriangle(mirror / 3), mesh.InputTriangle(h / 3));
      ASSERT_NE(mesh.IsFront(h / 3), mesh.IsFront(mirror / 3));
      ASSERT_EQ(mesh.Point(mesh.Tail(mirror)), mesh.Point(mesh.Head(h)));
      ASSERT_EQ(mesh.MirrorVertex(mesh.Tail(h)), mesh.Head(mirror));
      ASSERT_EQ(mesh.Twin(h) == None, mesh.Twin(mirror) == None);
      if (mesh.Twin(h) != None)
      {
        ASSERT_EQ(mesh.Mirror(mesh.Twin(h)), mesh.Twin(mirror));
      }
    }
    for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      ASSERT_EQ(mesh.MirrorVertex(mesh.MirrorVertex(v)), v);
      ASSERT_NE(mesh.IsFrontVertex(v), mesh.IsFrontVertex(mesh.MirrorVertex(v)));
    }
  }
  // Nothing is there twice beside it, and a point that both have is split.
  Surface mixed = Joined(Tetrahedron(), Joined(MoebiusStrip(8), Disk(2)));
  for (Triangle& t : mixed.Triangles)
  {
    std::replace(t.begin(), t.end(), Index(0), Index(4));
  }
  const TriangleMesh mesh(mixed);
  ExpectConsistent(mesh);
  ASSERT_EQ(mesh.GetComponents().size(), 3u);
  EXPECT_FALSE(mesh.GetComponents()[0].IsCover);
  EXPECT_TRUE(mesh.GetComponents()[1].IsCover);
  EXPECT_FALSE(mesh.GetComponents()[2].IsCover);
  EXPECT_EQ(mesh.GetComponents()[1].Triangles(), 32);
  EXPECT_EQ(mesh.GetComponents()[2].Vertices(), 19);
  EXPECT_EQ(mesh.GetRepairs().NonManifoldPoints, 1);
}

TEST(TriangleMesh, WithoutAMajorityTheFirstTriangleDecides)
{
  const Surface hinge{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } },
    { { 1, 2, 3 }, { 0, 1, 2 } } };
  for (const bool swapped : { false, true })
  {
    Surface s = hinge;
    if (swapped)
    {
      std::swap(s.Triangles[0], s.Triangles[1]);
    }
    const TriangleMesh mesh(s);
    ExpectConsistent(mesh);
    EXPECT_EQ(mesh.GetRepairs().ReversedTriangles, 1);
    for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      const Triangle& first = s.Triangles[0];
      if (mesh.InputTriangle(h / 3) == 0 && mesh.Point(mesh.Tail(h)) == first[0])
      {
        EXPECT_EQ(mesh.Point(mesh.Head(h)), first[1]);
      }
    }
  }
}

TEST(TriangleMesh, NeighboursAreCloseInMemoryWhateverTheOrderOfTheInput)
{
  std::vector<Index> newPoint;
  std::vector<Index> newTriangle;
  const Surface parts =
    Joined(Potato(4), Transformed(Potato(5), Eigen::Matrix3d::Identity(), Vector3(0.4, 0.3, 0.2)));
  const Surface shuffled = Shuffled(parts, 5, newPoint, newTriangle);
  const TriangleMesh mesh(shuffled);
  ExpectConsistent(mesh);
  ASSERT_EQ(mesh.GetComponents().size(), 2u);
  for (const auto& component : mesh.GetComponents())
  {
    // A patch of k vertices has about sqrt(k) edges to others; in random order the mean were a
    // third of all.
    double distance = 0.0;
    for (Index e = component.FirstEdge; e < component.EndEdge; ++e)
    {
      const Index h = mesh.HalfEdge(e);
      distance += std::abs(mesh.Tail(h) - mesh.Head(h));
    }
    const double vertices = component.Vertices();
    EXPECT_LT(distance / component.Edges(), 3.0 * std::sqrt(vertices));
    distance = 0.0;
    Index inner = 0;
    for (Index h = 3 * component.FirstTriangle; h < 3 * component.EndTriangle; ++h)
    {
      distance += std::abs(mesh.Twin(h) / 3 - h / 3);
      ++inner;
    }
    EXPECT_LT(distance / inner, 6.0 * std::sqrt(vertices));
  }
}

TEST(TriangleMesh, VerticesHaveTheSameOrderWhateverThatOfTheInput)
{
  std::vector<Index> newPoint;
  std::vector<Index> newTriangle;
  Surface surface =
    Joined(Potato(3), Transformed(Hemisphere(3), ObliqueRotation(1.0), { 9, 0, 0 }));
  // Wound by a majority of two to one.
  for (std::size_t t = 0; t < surface.Triangles.size(); t += 3)
  {
    std::swap(surface.Triangles[t][0], surface.Triangles[t][1]);
  }
  const Surface shuffled = Shuffled(surface, 11, newPoint, newTriangle);
  const TriangleMesh a(surface);
  const TriangleMesh b(shuffled);
  ASSERT_EQ(a.GetNumberOfVertices(), b.GetNumberOfVertices());
  const Index other = a.GetComponents()[0].Vertices() == b.GetComponents()[0].Vertices() ? 0 : 1;
  for (Index c = 0; c < 2; ++c)
  {
    const auto& from = a.GetComponents()[c];
    const auto& to = b.GetComponents()[c ^ other];
    ASSERT_EQ(from.Vertices(), to.Vertices());
    for (Index v = 0; v < from.Vertices(); ++v)
    {
      EXPECT_EQ(newPoint[a.Point(from.FirstVertex + v)], b.Point(to.FirstVertex + v));
    }
  }
}

TEST(TriangleMesh, SameNumbersForAnyNumberOfThreads)
{
  std::vector<Index> newPoint;
  std::vector<Index> newTriangle;
  // Fins and a bow-tie among them, some pieces for each thread.
  Surface surface = Joined(Potato(5), Square(60));
  surface.Points.emplace_back(0.5, 0.25, 1.0);
  const auto tip = static_cast<Index>(surface.Points.size()) - 1;
  surface.Triangles.push_back({ 0, surface.Triangles[0][1], tip });
  surface.Triangles.push_back({ 12000, 11000, tip });
  surface = Shuffled(surface, 3, newPoint, newTriangle);
  const auto numbers = [&surface](int threads)
  {
    Threads several(threads);
    const Threads::Scope scope(several);
    const TriangleMesh mesh(surface);
    std::vector<std::array<Index, 4>> all;
    for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      all.push_back({ mesh.Tail(h), mesh.Twin(h), mesh.Edge(h), mesh.InputTriangle(h / 3) });
    }
    for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      all.push_back({ mesh.Point(v), mesh.Outgoing(v), 0, 0 });
    }
    for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
    {
      all.push_back({ mesh.HalfEdge(e), 0, 0, 0 });
    }
    return all;
  };
  const auto serial = numbers(1);
  EXPECT_EQ(numbers(2), serial);
  EXPECT_EQ(numbers(3), serial);
}

TEST(TriangleMesh, EmptySurface)
{
  const TriangleMesh mesh(Surface{});
  EXPECT_EQ(mesh.GetNumberOfTriangles(), 0);
  EXPECT_TRUE(mesh.GetComponents().empty());
}
