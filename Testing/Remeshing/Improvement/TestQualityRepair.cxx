// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceMesh/FaceEdits.h"
#include "Improvement/QualityRepair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
constexpr Index Cells = 6;

/// A square of Cells x Cells unit quads, whose four sides are features that their vertices may slide along.
struct Plate
{
  Plate()
  {
    for (Index j = 0; j <= Cells; ++j)
    {
      for (Index i = 0; i <= Cells; ++i)
      {
        this->Mesh.Points.emplace_back(i, j, 0.0);
        const bool isSide = i == 0 || i == Cells;
        const bool isEnd = j == 0 || j == Cells;
        FaceMesh::Vertex vertex;
        vertex.IsBoundary = isSide || isEnd;
        vertex.Line = isSide && isEnd ? -1 : j == 0 ? 1 : i == Cells ? 2 : j == Cells ? 3 : 0;
        vertex.Line = vertex.Line == 0 && i == 0 ? 4 : vertex.Line;
        this->Mesh.Vertices.push_back(vertex);
        if (i < Cells && j < Cells)
        {
          const Index v = j * (Cells + 1) + i;
          this->AddFace({ v, v + 1, v + Cells + 2, v + Cells + 1 });
        }
      }
    }
    for (Index k = 0; k < Cells; ++k)
    {
      const Index row = Cells + 1;
      this->Mesh.LineEdges.push_back({ { k, k + 1 }, 1 });
      this->Mesh.LineEdges.push_back({ { k * row + Cells, (k + 1) * row + Cells }, 2 });
      this->Mesh.LineEdges.push_back({ { Cells * row + k, Cells * row + k + 1 }, 3 });
      this->Mesh.LineEdges.push_back({ { k * row, (k + 1) * row }, 4 });
    }
  }

  void AddFace(const Faces::Face& face)
  {
    this->Mesh.Cells.Corners.push_back(face);
    this->Mesh.Cells.IsRegular.push_back(1);
  }

  /// A new vertex in an edge of the lower side: with the edge's ends it makes a triangle without area.
  void AddFlatTriangle(Index tail, double at)
  {
    const auto middle = static_cast<Index>(this->Mesh.Points.size());
    this->Mesh.Points.emplace_back(this->Mesh.Points[tail] + Vector3(at, 0.0, 0.0));
    FaceMesh::Vertex vertex;
    vertex.IsBoundary = true;
    vertex.Line = 1;
    this->Mesh.Vertices.push_back(vertex);
    this->AddFace({ tail, middle, tail + 1, None });
    std::vector<FaceMesh::LineEdge>& edges = this->Mesh.LineEdges;
    edges.erase(std::find_if(edges.begin(), edges.end(),
      [&](const FaceMesh::LineEdge& e) {
        return e.Ends == std::array<Index, 2>{ tail, tail + 1 };
      }));
    edges.push_back({ { tail, middle }, 1 });
    edges.push_back({ { middle, tail + 1 }, 1 });
  }

  Faces Mended(bool mayMakeTriangles, int degree = 4)
  {
    constexpr double size = Cells;
    const std::array<Vector3, 4> corner = { Vector3(0.0, 0.0, 0.0), Vector3(size, 0.0, 0.0),
      Vector3(size, size, 0.0), Vector3(0.0, size, 0.0) };
    const ClosestPoints ground(std::vector<ClosestPoints::Corners>{
      { corner[0], corner[1], corner[2] }, { corner[0], corner[2], corner[3] } });
    std::vector<ClosestPoints> lines;
    for (int k = 0; k < 4; ++k)
    {
      const Vector3& end = corner[(k + 1) % 4];
      lines.emplace_back(std::vector<ClosestPoints::Corners>{ { corner[k], end, end } });
    }
    SmoothingDomain domain{ ground, lines, {}, {} };
    for (const FaceMesh::Vertex& vertex : this->Mesh.Vertices)
    {
      domain.Line.push_back(vertex.Line);
      domain.EdgeLength.push_back(1.0);
    }
    VertexStars stars(
      this->Mesh.Cells, static_cast<Index>(this->Mesh.Points.size()), this->Mesh.LineEdges);
    MovableFaces places(stars, domain, this->Mesh.Points);
    RepairQuality(stars, places, this->Mesh.Vertices, mayMakeTriangles, degree);
    return stars.Compressed();
  }

  double LeastQuality(const Faces& faces) const
  {
    double least = 1.0;
    for (const Faces::Face& face : faces.Corners)
    {
      least = std::min(least, ScaledJacobian(this->Mesh.Points, face));
    }
    return least;
  }

  /// Each edge once each way at most, V - E + F = 1, the area of the square and its corners.
  void ExpectCover(const Faces& faces) const
  {
    std::map<std::array<Index, 2>, int> directed;
    std::vector<Index> used;
    double area = 0.0;
    for (const Faces::Face& face : faces.Corners)
    {
      const int size = Faces::Size(face);
      for (int c = 0; c < size; ++c)
      {
        const Vector3& p = this->Mesh.Points[face[c]];
        const Vector3& q = this->Mesh.Points[face[(c + 1) % size]];
        EXPECT_EQ(++directed[(std::array<Index, 2>{ face[c], face[(c + 1) % size] })], 1);
        area += 0.5 * p.cross(q)[2];
        used.push_back(face[c]);
      }
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    EXPECT_EQ(EulerCharacteristic(static_cast<Index>(used.size()), faces), 1);
    EXPECT_NEAR(area, Cells * Cells, 1e-9);
    for (const Index v : { Index(0), Cells, Cells * (Cells + 1), Cells * (Cells + 2) })
    {
      EXPECT_TRUE(std::binary_search(used.begin(), used.end(), v));
    }
  }

  FaceMesh Mesh;
};
}

TEST(QualityRepair, LeaveGoodFacesAsTheyAre)
{
  Plate plate;
  const std::vector<Vector3> points = plate.Mesh.Points;
  EXPECT_EQ(plate.Mended(true).Corners, plate.Mesh.Cells.Corners);
  EXPECT_EQ(plate.Mesh.Points, points);
}

TEST(QualityRepair, TakeVerticesOutOfLines)
{
  // All three corners of the triangle are on one line, along which no move gives it any area.
  for (const Index tail : { 0, 2, Cells - 1 })
  {
    Plate plate;
    plate.AddFlatTriangle(tail, 0.3);
    EXPECT_LT(plate.LeastQuality(plate.Mesh.Cells), 1e-9);
    const Faces mended = plate.Mended(true);
    EXPECT_GT(plate.LeastQuality(mended), 0.5) << tail;
    plate.ExpectCover(mended);
  }
}

TEST(QualityRepair, MakeNoTrianglesWhereAllAreToBeQuads)
{
  // The edge between two quads on the boundary turned away from it: one quad has an angle of 180 degrees there.
  for (const bool mayMakeTriangles : { false, true })
  {
    Plate plate;
    VertexStars stars(
      plate.Mesh.Cells, static_cast<Index>(plate.Mesh.Points.size()), plate.Mesh.LineEdges);
    std::vector<FaceEdits::Rule> rules(plate.Mesh.Points.size());
    for (std::size_t v = 0; v < rules.size(); ++v)
    {
      rules[v].IsBoundary = plate.Mesh.Vertices[v].IsBoundary;
    }
    FaceEdits edits(stars, rules);
    ASSERT_TRUE(edits.Do({ 2, 3, 0 }) || edits.Do({ 2, 3, 1 }));
    plate.Mesh.Cells = stars.Compressed();
    EXPECT_LT(plate.LeastQuality(plate.Mesh.Cells), 0.3);
    const Faces mended = plate.Mended(mayMakeTriangles);
    EXPECT_GT(plate.LeastQuality(mended), 0.3) << mayMakeTriangles;
    plate.ExpectCover(mended);
    for (const Faces::Face& face : mended.Corners)
    {
      EXPECT_TRUE(mayMakeTriangles || Faces::Size(face) == 4);
    }
  }
}

TEST(QualityRepair, TrianglesWithoutAreaGoAndNoQuadsCome)
{
  Plate plate;
  const std::vector<Faces::Face> quads = plate.Mesh.Cells.Corners;
  plate.Mesh.Cells = Faces();
  for (const Faces::Face& quad : quads)
  {
    plate.AddFace({ quad[0], quad[1], quad[2], None });
    plate.AddFace({ quad[0], quad[2], quad[3], None });
  }
  plate.AddFlatTriangle(2, 0.4);
  const Faces mended = plate.Mended(false, 6);
  plate.ExpectCover(mended);
  EXPECT_GT(plate.LeastQuality(mended), 0.3);
  for (const Faces::Face& face : mended.Corners)
  {
    EXPECT_EQ(Faces::Size(face), 3);
  }
}
