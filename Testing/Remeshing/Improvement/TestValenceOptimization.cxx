// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceMesh/FaceEdits.h"
#include "Improvement/ValenceOptimization.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
constexpr Index Cells = 8;

/// A square of Cells x Cells quads. Some are cut into triangles.
struct Square
{
  explicit Square(const std::vector<Index>& cut = {})
  {
    for (Index j = 0; j <= Cells; ++j)
    {
      for (Index i = 0; i <= Cells; ++i)
      {
        this->Points.emplace_back(i, j, 0.0);
        this->IsBoundary.push_back(i == 0 || j == 0 || i == Cells || j == Cells ? 1 : 0);
      }
    }
    for (Index k = 0; k < Cells * Cells; ++k)
    {
      const Index v = (k / Cells) * (Cells + 1) + k % Cells;
      const Faces::Face quad = { v, v + 1, v + Cells + 2, v + Cells + 1 };
      if (std::find(cut.begin(), cut.end(), k) == cut.end())
      {
        this->Cover.Corners.push_back(quad);
      }
      else
      {
        this->Cover.Corners.push_back({ quad[0], quad[1], quad[2], None });
        this->Cover.Corners.push_back({ quad[0], quad[2], quad[3], None });
      }
    }
    this->Cover.IsRegular.assign(this->Cover.Corners.size(), 1);
  }

  Index CountPoints() const { return static_cast<Index>(this->Points.size()); }

  std::vector<FaceEdits::Rule> GetRules() const
  {
    std::vector<FaceEdits::Rule> rules(this->Points.size());
    for (std::size_t v = 0; v < rules.size(); ++v)
    {
      rules[v].IsBoundary = rules[v].IsOnLine = this->IsBoundary[v] != 0;
      rules[v].IsFree = !rules[v].IsBoundary;
      rules[v].MayLeaveLine = rules[v].IsBoundary;
      rules[v].Target = rules[v].IsBoundary ? 2 : 4;
    }
    return rules;
  }

  /// The edges on the boundary.
  std::vector<FaceMesh::LineEdge> GetLineEdges() const
  {
    std::vector<FaceMesh::LineEdge> edges;
    for (Index k = 0; k < Cells; ++k)
    {
      const Index row = Cells + 1;
      edges.push_back({ { k, k + 1 }, 1 });
      edges.push_back({ { k * row + Cells, (k + 1) * row + Cells }, 1 });
      edges.push_back({ { Cells * row + k, Cells * row + k + 1 }, 1 });
      edges.push_back({ { k * row, (k + 1) * row }, 1 });
    }
    return edges;
  }

  /// Cleans up, with indices of singularities at some vertices.
  Faces Cleaned(VertexStars& stars, std::vector<int> index = {}, int degree = 4)
  {
    const double size = Cells;
    const Vector3 a = Vector3::Zero();
    const Vector3 c(size, size, 0.0);
    const ClosestPoints ground(std::vector<ClosestPoints::Corners>{
      { a, Vector3(size, 0.0, 0.0), c }, { a, c, Vector3(0.0, size, 0.0) } });
    const std::vector<ClosestPoints> noLines;
    SmoothingDomain domain{ ground, noLines, {}, {} };
    for (const char isFixed : this->IsBoundary)
    {
      domain.Line.push_back(isFixed != 0 ? -1 : 0);
      domain.EdgeLength.push_back(1.0);
    }
    MovableFaces movable(stars, domain, this->Points);
    index.resize(this->Points.size(), 0);
    std::vector<FaceMesh::Vertex> vertices(this->Points.size());
    for (std::size_t v = 0; v < vertices.size(); ++v)
    {
      vertices[v].IsBoundary = this->IsBoundary[v] != 0;
      vertices[v].SingularityIndex = index[v];
    }
    OptimizeValences(stars, movable, vertices, degree);
    return stars.Compressed();
  }

  std::vector<Vector3> Points;
  std::vector<char> IsBoundary;
  Faces Cover;
};

/// Each edge once each way at most, and a disk: V - E + F = 1, the vertices being those that are used.
void ExpectDisk(const Faces& faces)
{
  std::map<std::array<Index, 2>, int> directed;
  std::vector<Index> used;
  for (const Faces::Face& face : faces.Corners)
  {
    for (int c = 0; c < Faces::Size(face); ++c)
    {
      EXPECT_EQ(
        ++directed[(std::array<Index, 2>{ face[c], face[(c + 1) % Faces::Size(face)] })], 1);
      used.push_back(face[c]);
    }
  }
  std::sort(used.begin(), used.end());
  const auto end = std::unique(used.begin(), used.end());
  EXPECT_EQ(EulerCharacteristic(static_cast<Index>(end - used.begin()), faces), 1);
}

int IrregularityOf(const VertexStars& stars, const FaceEdits& edits)
{
  int sum = 0;
  for (Index v = 0; v < stars.GetNumberOfVertices(); ++v)
  {
    sum += edits.Irregularity(v);
  }
  for (Index f = 0; f < stars.GetNumberOfFaces(); ++f)
  {
    // The penalty for a triangle, in the units of Irregularity.
    sum += stars.IsFace(f) && Faces::Size(stars.Face(f)) == 3 ? 12 : 0;
  }
  return sum;
}

/// The number of faces at each vertex inside.
std::map<std::size_t, int> ValencesOf(const VertexStars& stars, const Square& square)
{
  std::map<std::size_t, int> valences;
  for (Index v = 0; v < stars.GetNumberOfVertices(); ++v)
  {
    if (square.IsBoundary[v] == 0 && !stars.At(v).empty())
    {
      ++valences[stars.At(v).size()];
    }
  }
  return valences;
}
}

TEST(FaceEdits, KeepTheTopologyAndTellHowIrregularTheyMakeIt)
{
  std::mt19937 engine(3);
  const Square square({ 18, 21, 44 });
  const std::vector<FaceMesh::LineEdge> lines = square.GetLineEdges();
  const VertexStars before(square.Cover, square.CountPoints(), lines);
  int shortened = 0;
  for (int run = 0; run < 20; ++run)
  {
    VertexStars stars(square.Cover, square.CountPoints(), lines);
    FaceEdits edits(stars, square.GetRules());
    int done = 0;
    for (int k = 0; k < 200; ++k)
    {
      const auto v = static_cast<Index>(engine() % square.Points.size());
      const std::vector<FaceEdits::Edit> all =
        engine() % 3 == 0 ? edits.FindForBadFaces(v) : edits.Find(v);
      if (all.empty())
      {
        continue;
      }
      const FaceEdits::Edit& edit = all[engine() % all.size()];
      const int sum = IrregularityOf(stars, edits);
      const int grown = edits.GrowthBy(edit);
      if (edits.Do(edit))
      {
        EXPECT_EQ(IrregularityOf(stars, edits), sum + grown);
        ++done;
      }
      else
      {
        EXPECT_EQ(IrregularityOf(stars, edits), sum);
      }
    }
    EXPECT_GT(done, 20);
    ExpectDisk(stars.Compressed());
    for (Index v = 0; v < stars.GetNumberOfVertices(); ++v)
    {
      // The boundary leads through all of its vertices that are left.
      EXPECT_EQ(
        stars.LineEnds(v).size(), square.IsBoundary[v] != 0 && !stars.At(v).empty() ? 2u : 0u);
      for (const Index w : stars.LineEnds(v))
      {
        EXPECT_TRUE(stars.AreJoined(v, w));
      }
      shortened += square.IsBoundary[v] != 0 && stars.At(v).empty() ? 1 : 0;
      EXPECT_TRUE(square.IsBoundary[v] != 0 || stars.At(v).empty() || stars.At(v).size() > 2);
    }
    stars.UndoTo(0);
    EXPECT_EQ(stars.Compressed().Corners, square.Cover.Corners);
    EXPECT_EQ(stars.Compressed().IsRegular, square.Cover.IsRegular);
    for (Index v = 0; v < stars.GetNumberOfVertices(); ++v)
    {
      EXPECT_EQ(stars.LineEnds(v), before.LineEnds(v));
    }
  }
  EXPECT_GT(shortened, 20);
}

TEST(ValenceOptimization, TurnsEdgesAndJoinsTriangles)
{
  // The edge of two quads turned makes two vertices of three edges and two of five.
  Square turned;
  VertexStars stars(turned.Cover, turned.CountPoints());
  FaceEdits edits(stars, turned.GetRules());
  ASSERT_TRUE(edits.Do({ 27, 28, 0 }) || edits.Do({ 27, 28, 1 }));
  EXPECT_EQ(ValencesOf(stars, turned)[4], 45);
  const Faces cleaned = turned.Cleaned(stars);
  ExpectDisk(cleaned);
  EXPECT_EQ(ValencesOf(stars, turned), (std::map<std::size_t, int>{ { 4, 49 } }));

  // Triangles become quads again.
  Square cut({ 27 });
  VertexStars halves(cut.Cover, cut.CountPoints());
  for (const Faces::Face& face : cut.Cleaned(halves).Corners)
  {
    EXPECT_EQ(Faces::Size(face), 4);
  }
}

TEST(ValenceOptimization, LeavesWhatTheFieldExplains)
{
  Square turned;
  VertexStars stars(turned.Cover, turned.CountPoints());
  FaceEdits edits(stars, turned.GetRules());
  ASSERT_TRUE(edits.Do({ 27, 28, 0 }) || edits.Do({ 27, 28, 1 }));
  std::vector<int> index(turned.Points.size(), 0);
  for (Index v = 0; v < turned.CountPoints(); ++v)
  {
    index[v] = turned.IsBoundary[v] != 0 ? 0 : 4 - static_cast<int>(stars.At(v).size());
  }
  const std::map<std::size_t, int> before = ValencesOf(stars, turned);
  turned.Cleaned(stars, index);
  EXPECT_EQ(ValencesOf(stars, turned), before);
}

TEST(ValenceOptimization, TrianglesStayAndGetSixAroundEachVertex)
{
  std::vector<Index> all;
  for (Index k = 0; k < Cells * Cells; ++k)
  {
    all.push_back(k);
  }
  Square square(all);
  // The diagonal of a cell in the middle is turned.
  const std::size_t first = 2 * (Cells * Cells / 2 + Cells / 2);
  Faces::Face& lower = square.Cover.Corners[first];
  Faces::Face& upper = square.Cover.Corners[first + 1];
  const Faces::Face turned = { lower[0], lower[1], upper[2], None };
  upper = { lower[1], lower[2], upper[2], None };
  lower = turned;
  VertexStars stars(square.Cover, square.CountPoints(), square.GetLineEdges());
  const Faces cleaned = square.Cleaned(stars, {}, 6);
  ExpectDisk(cleaned);
  EXPECT_EQ(cleaned.Corners.size(), static_cast<std::size_t>(2 * Cells * Cells));
  for (const Faces::Face& face : cleaned.Corners)
  {
    EXPECT_EQ(Faces::Size(face), 3);
  }
  for (Index v = 0; v < square.CountPoints(); ++v)
  {
    EXPECT_TRUE(square.IsBoundary[v] != 0 || stars.At(v).size() == 6) << v;
  }
}
