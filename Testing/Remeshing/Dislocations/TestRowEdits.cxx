// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Dislocations/RowEdits.h"

#include "Dislocations/RowSearch.h"
#include "Meshes/FacesAtEdges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
constexpr Index Cells = 12;

Index At(Index i, Index j)
{
  return j * (Cells + 1) + i;
}

/// A square of unit quads; its sides are the line 1, its corners do not move.
FaceMesh Grid()
{
  FaceMesh mesh;
  for (Index j = 0; j <= Cells; ++j)
  {
    for (Index i = 0; i <= Cells; ++i)
    {
      const int sides = (i % Cells == 0 ? 1 : 0) + (j % Cells == 0 ? 1 : 0);
      mesh.Points.emplace_back(i, j, 0.0);
      FaceMesh::Vertex vertex;
      vertex.Line = sides == 2 ? -1 : sides;
      vertex.IsBoundary = sides > 0;
      mesh.Vertices.push_back(vertex);
      if (i < Cells && j < Cells)
      {
        mesh.Cells.Corners.push_back({ At(i, j), At(i + 1, j), At(i + 1, j + 1), At(i, j + 1) });
        mesh.Cells.IsRegular.push_back(1);
      }
    }
  }
  for (Index k = 0; k < Cells; ++k)
  {
    mesh.LineEdges.push_back({ { At(k, 0), At(k + 1, 0) }, 1 });
    mesh.LineEdges.push_back({ { At(k, Cells), At(k + 1, Cells) }, 1 });
    mesh.LineEdges.push_back({ { At(0, k), At(0, k + 1) }, 1 });
    mesh.LineEdges.push_back({ { At(Cells, k), At(Cells, k + 1) }, 1 });
  }
  return mesh;
}

/// Makes a row of vertices a feature.
void AddLine(FaceMesh& mesh, Index j)
{
  for (Index i = 0; i < Cells; ++i)
  {
    mesh.LineEdges.push_back({ { At(i, j), At(i + 1, j) }, 2 });
    mesh.Vertices[At(i, j)].Line = i == 0 ? -1 : 2;
  }
  mesh.Vertices[At(Cells, j)].Line = -1;
}

/// The half-edges of the chain in a column, upwards, from one row to another one.
std::vector<Index> Column(const EdgeLoops& chains, Index i, Index from, Index to)
{
  std::vector<Index> part;
  for (const std::vector<Index>& chain : chains.GetAll())
  {
    for (const Index h : chain)
    {
      for (const Index upwards : { h, chains.Twin(h) })
      {
        const Index tail = chains.Tail(upwards);
        const bool isOfColumn = tail % (Cells + 1) == i && chains.Head(upwards) == tail + Cells + 1;
        if (isOfColumn && tail / (Cells + 1) >= from && tail / (Cells + 1) < to)
        {
          part.push_back(upwards);
        }
      }
    }
  }
  std::sort(
    part.begin(), part.end(), [&](Index a, Index b) { return chains.Tail(a) < chains.Tail(b); });
  return part;
}

/// The number of faces at each vertex that is inside, without the regular ones, and at all of the
/// boundary: vertices with each number.
std::map<Index, int> Irregular(const FaceMesh& mesh)
{
  std::vector<Index> faces(mesh.Points.size(), 0);
  for (const Faces::Face& face : mesh.Cells.Corners)
  {
    for (const Index v : face)
    {
      ++faces[v];
    }
  }
  std::map<Index, int> count;
  for (std::size_t v = 0; v < faces.size(); ++v)
  {
    if (!mesh.Vertices[v].IsBoundary && faces[v] != 4)
    {
      ++count[faces[v]];
    }
  }
  return count;
}

/// A disk of quads that are wound alike, whose rim is the line 1.
void ExpectSound(const FaceMesh& mesh)
{
  EXPECT_EQ(mesh.Vertices.size(), mesh.Points.size());
  EXPECT_EQ(mesh.Cells.IsRegular.size(), mesh.Cells.Corners.size());
  EXPECT_EQ(EulerCharacteristic(static_cast<Index>(mesh.Points.size()), mesh.Cells), 1);
  double area = 0.0;
  std::set<std::array<Index, 2>> halfEdges;
  for (const Faces::Face& face : mesh.Cells.Corners)
  {
    area += AreaVector(mesh.Points, face)[2];
    for (int c = 0; c < 4; ++c)
    {
      EXPECT_TRUE(halfEdges.insert({ face[c], face[(c + 1) % 4] }).second);
    }
  }
  EXPECT_NEAR(area, static_cast<double>(Cells * Cells), 1e-9);
  std::set<std::array<Index, 2>> rim;
  std::set<std::array<Index, 2>> line;
  for (const auto& [ends, faces] : Meshes::FacesAtEdges(mesh.Cells.Corners))
  {
    if (faces == 1)
    {
      rim.insert(ends);
    }
  }
  for (const FaceMesh::LineEdge& edge : mesh.LineEdges)
  {
    if (edge.Line == 1)
    {
      line.insert({ std::min(edge.Ends[0], edge.Ends[1]), std::max(edge.Ends[0], edge.Ends[1]) });
    }
  }
  EXPECT_EQ(rim, line);
}
}

/// A grid has a chain in each of its rows and columns inside, which go from side to side.
TEST(EdgeLoops, OfAGridAreItsRowsAndColumns)
{
  const FaceMesh mesh = Grid();
  const EdgeLoops chains(mesh);
  ASSERT_EQ(chains.GetAll().size(), 2U * (Cells - 1));
  for (const std::vector<Index>& chain : chains.GetAll())
  {
    ASSERT_EQ(chain.size(), static_cast<std::size_t>(Cells));
    EXPECT_TRUE(chains.IsMouth(chains.Tail(chain.front())));
    EXPECT_TRUE(chains.IsMouth(chains.Head(chain.back())));
    const Vector3 way = mesh.Points[chains.Head(chain[0])] - mesh.Points[chains.Tail(chain[0])];
    for (std::size_t k = 1; k < chain.size(); ++k)
    {
      EXPECT_EQ(chains.Tail(chain[k]), chains.Head(chain[k - 1]));
      EXPECT_EQ(mesh.Points[chains.Head(chain[k])] - mesh.Points[chains.Tail(chain[k])], way);
    }
    for (std::size_t k = 0; k + 1 < chain.size(); ++k)
    {
      const Vector3 left(-way.y(), way.x(), 0.0);
      const Vector3& here = mesh.Points[chains.Head(chain[k])];
      const auto [toLeft, toRight] = chains.Beside(chain[k], chains.Head(chain[k]));
      EXPECT_EQ(mesh.Points[toLeft] - here, left);
      EXPECT_EQ(mesh.Points[toRight] - here, -left);
      EXPECT_EQ(mesh.Points[chains.Head(chains.ToRight(chain[k]))] - here, -left);
    }
  }
}

/// No chain is along a line, and each goes on straight over one.
TEST(EdgeLoops, GoOverLinesAndNotAlongThem)
{
  FaceMesh mesh = Grid();
  AddLine(mesh, 5);
  const EdgeLoops chains(mesh);
  EXPECT_EQ(chains.GetAll().size(), 2U * (Cells - 1) - 1U);
  EXPECT_EQ(Column(chains, 3, 0, Cells).size(), static_cast<std::size_t>(Cells));
}

/// Two rows more, or two less, from a vertex inside to the boundary: one vertex of three faces and
/// one of five.
TEST(RowEdits, EndInAPairOfVerticesInside)
{
  for (const bool inserts : { true, false })
  {
    for (const bool hasLine : { true, false })
    {
      FaceMesh mesh = Grid();
      if (hasLine)
      {
        AddLine(mesh, 8);
      }
      const EdgeLoops chains(mesh);
      RowEdit edit;
      edit.Inserts = inserts;
      edit.HalfEdges = Column(chains, 6, 4, Cells);
      ASSERT_EQ(edit.HalfEdges.size(), static_cast<std::size_t>(Cells - 4));
      edit.EndsAtBoundary = true;
      const auto before = static_cast<Index>(mesh.Cells.Corners.size());
      Apply({ edit }, chains, mesh);
      const auto after = static_cast<Index>(mesh.Cells.Corners.size());
      // One quad at the end inside, and two in each row of faces beyond.
      EXPECT_EQ(after - before, (inserts ? 1 : -1) * (2 * (Cells - 5) + 1));
      EXPECT_EQ(Irregular(mesh), (std::map<Index, int>{ { 3, 1 }, { 5, 1 } }));
      ExpectSound(mesh);
      const auto ofLine = std::count_if(mesh.LineEdges.begin(), mesh.LineEdges.end(),
        [](const FaceMesh::LineEdge& edge) { return edge.Line == 2; });
      EXPECT_EQ(ofLine, hasLine ? Cells + (inserts ? 2 : -2) : 0);
    }
  }
}

/// Rows inside have a pair at either end, and several edits at once keep out of each other's way.
TEST(RowEdits, HaveTwoPairsInside)
{
  FaceMesh mesh = Grid();
  const EdgeLoops chains(mesh);
  RowEdit more;
  more.HalfEdges = Column(chains, 3, 3, 9);
  RowEdit less = more;
  less.Inserts = false;
  less.HalfEdges = Column(chains, 8, 3, 9);
  const std::size_t before = mesh.Cells.Corners.size();
  Apply({ more, less }, chains, mesh);
  EXPECT_EQ(mesh.Cells.Corners.size(), before);
  EXPECT_EQ(Irregular(mesh), (std::map<Index, int>{ { 3, 4 }, { 5, 4 } }));
  ExpectSound(mesh);
}

/// Where edges are as wanted there are no rows to be found; twice as long as wanted they need more,
/// half as long fewer.
TEST(RowSearch, FindsRowsWhereEdgesAreOff)
{
  const FaceMesh mesh = Grid();
  const EdgeLoops chains(mesh);
  EXPECT_TRUE(FindRows(mesh, chains, std::vector<double>(mesh.Points.size(), 1.0)).empty());
  for (const double wanted : { 0.5, 2.0 })
  {
    const std::vector<RowEdit> edits =
      FindRows(mesh, chains, std::vector<double>(mesh.Points.size(), wanted));
    ASSERT_FALSE(edits.empty());
    for (const RowEdit& edit : edits)
    {
      EXPECT_EQ(edit.Inserts, wanted < 1.0);
      EXPECT_TRUE(edit.BeginsAtBoundary && edit.EndsAtBoundary);
    }
    FaceMesh changed = mesh;
    Apply(edits, chains, changed);
    EXPECT_TRUE(Irregular(changed).empty());
    ExpectSound(changed);
  }
}
