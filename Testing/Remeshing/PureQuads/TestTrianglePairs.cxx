// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PureQuads/TrianglePairs.h"
#include "PureQuads/TriangleParity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>
#include <vector>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
using Ends = std::array<Index, 2>;

Ends EndsOf(Index a, Index b)
{
  return { std::min(a, b), std::max(a, b) };
}

/// Two squares of 8 x 8 unit quads side by side. Features are the sides of each; the edge between the two is one as well.
struct Plates
{
  static constexpr Index Rows = 8;
  static constexpr Index Columns = 16;

  Plates()
  {
    const auto at = [](Index i, Index j) { return j * (Columns + 1) + i; };
    for (Index j = 0; j <= Rows; ++j)
    {
      for (Index i = 0; i <= Columns; ++i)
      {
        this->Mesh.Points.emplace_back(i, j, 0.0);
        const bool isOnColumn = i % Rows == 0;
        const bool isOnRow = j % Rows == 0;
        FaceMesh::Vertex vertex;
        vertex.IsBoundary = isOnRow || i == 0 || i == Columns;
        vertex.Line = isOnColumn && isOnRow ? -1
          : isOnRow                         ? 1 + j / Rows
          : isOnColumn                      ? 3 + i / Rows
                                            : 0;
        this->Mesh.Vertices.push_back(vertex);
        if (i < Columns && j < Rows)
        {
          this->AddFace({ at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) });
        }
        if (i < Columns && isOnRow)
        {
          this->Mesh.LineEdges.push_back({ { at(i, j), at(i + 1, j) }, 1 + j / Rows });
        }
        if (j < Rows && isOnColumn)
        {
          this->Mesh.LineEdges.push_back({ { at(i, j), at(i, j + 1) }, 3 + i / Rows });
        }
      }
    }
  }

  void AddFace(const Faces::Face& face)
  {
    this->Mesh.Cells.Corners.push_back(face);
    this->Mesh.Cells.IsRegular.push_back(1);
  }

  /// Makes a triangle and a quad of a quad at the lower side, or at the upper one, with a vertex in the side.
  void AddTriangle(Index column, bool isUpper)
  {
    Faces::Face& quad = this->Mesh.Cells.Corners[isUpper ? column + (Rows - 1) * Columns : column];
    const int c = isUpper ? 2 : 0;
    const auto middle = static_cast<Index>(this->Mesh.Points.size());
    const Index tail = quad[c];
    const Index head = quad[c + 1];
    this->Mesh.Points.emplace_back(0.5 * (this->Mesh.Points[tail] + this->Mesh.Points[head]));
    FaceMesh::Vertex vertex;
    vertex.IsBoundary = true;
    vertex.Line = isUpper ? 2 : 1;
    this->Mesh.Vertices.push_back(vertex);
    const Faces::Face triangle = { middle, head, quad[(c + 2) % 4], None };
    quad = { tail, middle, quad[(c + 2) % 4], quad[(c + 3) % 4] };
    this->AddFace(triangle);
    std::vector<FaceMesh::LineEdge>& edges = this->Mesh.LineEdges;
    const auto edge = std::find_if(edges.begin(), edges.end(),
      [&](const FaceMesh::LineEdge& e)
      { return EndsOf(e.Ends[0], e.Ends[1]) == EndsOf(tail, head); });
    edge->Ends = { tail, middle };
    edges.push_back({ { middle, head }, vertex.Line });
  }

  /// The lines are as long as they were.
  void ExpectSound() const
  {
    this->ExpectSheet();
    double length = 0.0;
    for (const FaceMesh::LineEdge& edge : this->Mesh.LineEdges)
    {
      length += (this->Mesh.Points[edge.Ends[0]] - this->Mesh.Points[edge.Ends[1]]).norm();
    }
    EXPECT_NEAR(length, 2.0 * Columns + 3.0 * Rows, 1e-9);
  }

  /// Each edge has two faces, wound alike, or is part of a line, and there is one sheet without holes.
  void ExpectSheet() const
  {
    std::map<Ends, int> directed;
    std::map<Ends, int> faces;
    std::set<Index> used;
    for (const Faces::Face& face : this->Mesh.Cells.Corners)
    {
      for (int c = 0; c < Faces::Size(face); ++c)
      {
        const Index next = face[(c + 1) % Faces::Size(face)];
        EXPECT_EQ(++directed[(Ends{ face[c], next })], 1);
        ++faces[EndsOf(face[c], next)];
        used.insert(face[c]);
      }
    }
    EXPECT_EQ(EulerCharacteristic(static_cast<Index>(used.size()), this->Mesh.Cells), 1);
    std::set<Ends> onLines;
    for (const FaceMesh::LineEdge& edge : this->Mesh.LineEdges)
    {
      EXPECT_TRUE(onLines.insert(EndsOf(edge.Ends[0], edge.Ends[1])).second);
      EXPECT_EQ(faces.count(EndsOf(edge.Ends[0], edge.Ends[1])), 1U);
    }
    for (const auto& [ends, count] : faces)
    {
      EXPECT_TRUE(count == 2 || onLines.count(ends) == 1);
    }
  }

  /// The triangles left and right of the feature between the plates.
  std::array<int, 2> CountTriangles() const
  {
    std::array<int, 2> count = { 0, 0 };
    for (const Faces::Face& face : this->Mesh.Cells.Corners)
    {
      if (Faces::Size(face) == 3)
      {
        double x = 0.0;
        for (int c = 0; c < 3; ++c)
        {
          x += this->Mesh.Points[face[c]][0] / 3.0;
        }
        ++count[x < Rows ? 0 : 1];
      }
    }
    return count;
  }

  /// Takes out row number 3 at the columns of vertices from one to another: at the end the row goes on beyond a
  /// triangle.
  void TakeOutRow(Index from, Index to)
  {
    for (Index i = from; i <= to; ++i)
    {
      const Index stays = 3 * (Columns + 1) + i;
      const Index goes = stays + Columns + 1;
      Faces left;
      for (const Faces::Face& face : this->Mesh.Cells.Corners)
      {
        Faces::Face corners = { None, None, None, None };
        int size = 0;
        for (int c = 0; c < Faces::Size(face); ++c)
        {
          const Index v = face[c] == goes ? stays : face[c];
          if (std::find(corners.begin(), corners.end(), v) == corners.end())
          {
            corners[size++] = v;
          }
        }
        if (size > 2)
        {
          left.Corners.push_back(corners);
          left.IsRegular.push_back(1);
        }
      }
      this->Mesh.Cells = left;
      std::vector<FaceMesh::LineEdge>& edges = this->Mesh.LineEdges;
      for (FaceMesh::LineEdge& edge : edges)
      {
        std::replace(edge.Ends.begin(), edge.Ends.end(), goes, stays);
      }
      edges.erase(std::remove_if(edges.begin(), edges.end(),
                    [](const FaceMesh::LineEdge& e) { return e.Ends[0] == e.Ends[1]; }),
        edges.end());
    }
  }

  /// Joins the triangles; returns the faces.
  void Join(JoinPolicy policy = JoinPolicy::AtAnyPrice)
  {
    const double right = Columns;
    const double top = Rows;
    const auto corner = [](double x, double y) { return Vector3(x, y, 0.0); };
    const Vector3 a = corner(0.0, 0.0);
    const Vector3 b = corner(right, 0.0);
    const Vector3 c = corner(right, top);
    const Vector3 d = corner(0.0, top);
    const ClosestPoints ground(std::vector<ClosestPoints::Corners>{ { a, b, c }, { a, c, d } });
    std::vector<ClosestPoints> lines;
    const Vector3 low = corner(0.5 * right, 0.0);
    const Vector3 high = corner(0.5 * right, top);
    for (const auto& [from, to] :
      { std::pair(a, b), std::pair(d, c), std::pair(a, d), std::pair(low, high), std::pair(b, c) })
    {
      lines.emplace_back(std::vector<ClosestPoints::Corners>{ { from, to, to } });
    }
    SmoothingDomain domain{ ground, lines, {}, {} };
    for (const FaceMesh::Vertex& vertex : this->Mesh.Vertices)
    {
      domain.Line.push_back(vertex.Line);
      domain.EdgeLength.push_back(1.0);
    }
    VertexStars stars(
      this->Mesh.Cells, static_cast<Index>(this->Mesh.Points.size()), this->Mesh.LineEdges);
    MovableFaces movable(stars, domain, this->Mesh.Points);
    JoinTriangles(stars, movable, this->Mesh.Vertices, policy);
    this->Mesh.Cells = stars.Compressed();
    // Vertices of lines may be gone.
    std::map<Ends, Index> lineOf;
    for (const FaceMesh::LineEdge& edge : this->Mesh.LineEdges)
    {
      lineOf[EndsOf(edge.Ends[0], edge.Ends[1])] = edge.Line;
    }
    this->Mesh.LineEdges.clear();
    for (Index v = 0; v < stars.GetNumberOfVertices(); ++v)
    {
      for (const Index w : stars.LineEnds(v))
      {
        if (v < w)
        {
          this->Mesh.LineEdges.push_back({ { v, w }, lineOf[EndsOf(v, w)] });
        }
      }
    }
  }

  double LeastQuality() const
  {
    double least = 1.0;
    for (const Faces::Face& face : this->Mesh.Cells.Corners)
    {
      least = std::min(least, ScaledJacobian(this->Mesh.Points, face));
    }
    return least;
  }

  std::size_t CountFaces() const { return this->Mesh.Cells.Corners.size(); }

  FaceMesh Mesh;
};
}

TEST(TrianglePairs, TrianglesFarApartBecomeQuadsWithThoseBetween)
{
  // In the same column, some columns apart, and next to the feature.
  for (const auto& [lower, upper] : { std::pair<Index, Index>(3, 3), { 1, 6 }, { 7, 0 }, { 0, 7 } })
  {
    Plates plates;
    plates.AddTriangle(lower, false);
    plates.AddTriangle(upper, true);
    EXPECT_EQ(plates.CountTriangles(), (std::array<int, 2>{ 2, 0 }));
    const std::size_t before = plates.CountFaces();
    plates.Join();
    EXPECT_EQ(plates.CountTriangles(), (std::array<int, 2>{ 0, 0 }));
    // Two triangles and k quads are k + 1 quads.
    EXPECT_EQ(plates.CountFaces(), before - 1);
    plates.ExpectSound();
    EXPECT_GT(plates.LeastQuality(), 0.3) << "columns " << lower << ", " << upper;
  }
}

TEST(TrianglePairs, NoWayCrossesAFeature)
{
  Plates plates;
  plates.AddTriangle(3, false);
  plates.AddTriangle(12, false);
  plates.Join();
  EXPECT_EQ(plates.CountTriangles(), (std::array<int, 2>{ 1, 1 }));
  plates.ExpectSound();
}

TEST(TrianglePairs, RowsBetweenTrianglesAreTakenOutOverAFeature)
{
  // To the boundary on both sides, between the two triangles, and to one side only.
  for (const auto& ranges :
    std::vector<std::vector<Ends>>{ { { 4, 12 } }, { { 0, 4 }, { 12, 16 } }, { { 0, 9 } } })
  {
    Plates plates;
    for (const Ends& range : ranges)
    {
      plates.TakeOutRow(range[0], range[1]);
    }
    const std::array<int, 2> triangles = plates.CountTriangles();
    EXPECT_GT(triangles[0] + triangles[1], 0);
    plates.Join(JoinPolicy::Cheap);
    EXPECT_EQ(plates.CountTriangles(), (std::array<int, 2>{ 0, 0 }));
    // What is left of the row, or less.
    EXPECT_GE(plates.CountFaces(), static_cast<std::size_t>(Plates::Columns * (Plates::Rows - 1)));
    plates.ExpectSound();
    EXPECT_GT(plates.LeastQuality(), 0.3);
  }
}

TEST(TrianglePairs, AnyTrianglesBecomeQuads)
{
  std::mt19937 engine(5);
  for (int run = 0; run < 30; ++run)
  {
    Plates plates;
    for (Index column = 0; column < Plates::Columns; ++column)
    {
      for (const bool isUpper : { false, true })
      {
        if (engine() % 8 == 0)
        {
          plates.AddTriangle(column, isUpper);
        }
      }
    }
    EvenOutTriangles(plates.Mesh);
    plates.ExpectSound();
    const std::array<int, 2> count = plates.CountTriangles();
    EXPECT_EQ(count[0] % 2, 0);
    EXPECT_EQ(count[1] % 2, 0);
    plates.Join();
    EXPECT_EQ(plates.CountTriangles(), (std::array<int, 2>{ 0, 0 })) << "run " << run;
    plates.ExpectSheet();
  }
}

TEST(TriangleParity, OddRegionsAreLedToTheBoundary)
{
  Plates plates;
  plates.AddTriangle(3, false);
  const std::size_t faces = plates.CountFaces();
  const std::size_t points = plates.Mesh.Points.size();
  EvenOutTriangles(plates.Mesh);
  EXPECT_EQ(plates.CountTriangles(), (std::array<int, 2>{ 2, 0 }));
  EXPECT_EQ(plates.CountFaces(), faces + 1);
  EXPECT_EQ(plates.Mesh.Points.size(), points + 1);
  EXPECT_TRUE(plates.Mesh.Vertices.back().IsBoundary);
  plates.ExpectSound();

  // Even numbers stay.
  const Faces before = plates.Mesh.Cells;
  EvenOutTriangles(plates.Mesh);
  EXPECT_EQ(plates.Mesh.Cells.Corners, before.Corners);
}

TEST(TriangleParity, ClosedRegionsAreLedToEachOther)
{
  // An octahedron with a feature around it, one half of which has a triangle more: it is a tetrahedron's.
  FaceMesh mesh;
  mesh.Points = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { -1.0, -1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
  mesh.Vertices.resize(4);
  mesh.Cells.Corners = { { 0, 1, 3, None }, { 1, 2, 3, None }, { 2, 0, 3, None },
    { 1, 0, 2, None } };
  mesh.Cells.IsRegular.assign(4, 0);
  mesh.LineEdges = { { { 0, 1 }, 1 }, { { 1, 2 }, 1 }, { { 2, 0 }, 1 } };
  EvenOutTriangles(mesh);
  ASSERT_EQ(mesh.Points.size(), 5U);
  EXPECT_FALSE(mesh.Vertices.back().IsBoundary);
  EXPECT_EQ(mesh.Vertices.back().Line, 1);
  // Both faces at the edge are cut: three and one become four and two.
  EXPECT_EQ(mesh.Cells.Corners.size(), 6U);
  EXPECT_EQ(mesh.LineEdges.size(), 4U);
  EXPECT_EQ(EulerCharacteristic(5, mesh.Cells), 2);
}

TEST(TriangleParity, SheetsThatMeetOnlyInEdgesOfMoreFacesAreEvenedOutThere)
{
  // Three sheets of one triangle each that share all their edges.
  FaceMesh mesh;
  mesh.Points = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
  mesh.Vertices.resize(3);
  mesh.Cells.Corners = { { 0, 1, 2, None }, { 0, 1, 2, None }, { 2, 1, 0, None } };
  mesh.Cells.IsRegular.assign(3, 0);
  mesh.LineEdges = { { { 0, 1 }, 1 }, { { 1, 2 }, 1 }, { { 2, 0 }, 1 } };
  EvenOutTriangles(mesh);
  // Each edge is cut, and three cuts make four triangles, or fewer and quads, of each sheet.
  EXPECT_EQ(mesh.Points.size(), 6U);
  EXPECT_EQ(mesh.LineEdges.size(), 6U);
  EXPECT_EQ(mesh.Cells.Corners.size() % 3, 0U);
  const auto triangles = std::count_if(mesh.Cells.Corners.begin(), mesh.Cells.Corners.end(),
    [](const Faces::Face& face) { return Faces::Size(face) == 3; });
  EXPECT_EQ(triangles % 2, 0);
}

TEST(TrianglePairs, ComponentsWithoutAMapAreNotCut)
{
  Plates plates;
  plates.AddTriangle(3, false);
  const std::size_t others = plates.CountFaces();
  // A triangle around its middle, all of whose edges stay.
  const auto first = static_cast<Index>(plates.Mesh.Points.size());
  for (const Vector3& place :
    { Vector3(30, 0, 0), Vector3(33, 0, 0), Vector3(30, 3, 0), Vector3(31, 1, 0) })
  {
    plates.Mesh.Points.push_back(place);
    FaceMesh::Vertex vertex;
    vertex.Line = -1;
    plates.Mesh.Vertices.push_back(vertex);
  }
  std::vector<Faces::Face> kept;
  for (Index c = 0; c < 3; ++c)
  {
    kept.push_back({ first + c, first + (c + 1) % 3, first + 3, None });
    plates.AddFace(kept.back());
    plates.Mesh.LineEdges.push_back({ { first + c, first + (c + 1) % 3 }, 0 });
    plates.Mesh.LineEdges.push_back({ { first + c, first + 3 }, 0 });
  }
  EvenOutTriangles(plates.Mesh);
  const std::vector<Faces::Face>& faces = plates.Mesh.Cells.Corners;
  for (const Faces::Face& face : kept)
  {
    EXPECT_EQ(std::count(faces.begin(), faces.end(), face), 1);
  }
  // What is beside it becomes even, by one edge of the boundary that is split.
  EXPECT_EQ(plates.CountTriangles()[0], 2);
  EXPECT_EQ(plates.CountFaces(), others + 3 + 1);
  for (const FaceMesh::LineEdge& edge : plates.Mesh.LineEdges)
  {
    for (const Index v : edge.Ends)
    {
      EXPECT_NE(plates.Mesh.Vertices[v].Line, 0);
    }
  }
}
