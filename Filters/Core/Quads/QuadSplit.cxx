// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Quads/QuadSplit.h"

#include <algorithm>

namespace DirectionFields::Internal
{
namespace
{
/// Finds edges by their ends in about the time that it takes to look at the edges of a vertex.
class Edges
{
public:
  explicit Edges(std::size_t vertices)
    : Newest(vertices, None)
  {
  }
  Index GetNumber() const { return static_cast<Index>(this->Items.size()); }

  /// The number of an edge; a new one where it was never asked for.
  Index Find(Index a, Index b)
  {
    const Index low = std::min(a, b);
    const Index high = std::max(a, b);
    for (Index e = this->Newest[low]; e != None; e = this->Items[e].Before)
    {
      if (this->Items[e].High == high)
      {
        return e;
      }
    }
    this->Items.push_back({ high, this->Newest[low] });
    this->Newest[low] = this->GetNumber() - 1;
    return this->Newest[low];
  }

private:
  struct Item
  {
    Index High;
    /// The edge of the same lower end that came before it, or None.
    Index Before;
  };
  std::vector<Index> Newest;
  std::vector<Item> Items;
};
}

void SplitIntoQuads(ComponentCells& cells)
{
  const Faces coarse = std::move(cells.Cells);
  cells.Cells = {};
  // The middle of edge e is vertex first + e.
  const auto first = static_cast<Index>(cells.Vertices.size());
  Edges edges(cells.Vertices.size());
  for (const Faces::Face& face : coarse.Corners)
  {
    const int size = Faces::Size(face);
    for (int c = 0; c < size; ++c)
    {
      const Index a = face[c];
      const Index b = face[(c + 1) % size];
      const Index middle = first + edges.Find(a, b);
      if (middle == static_cast<Index>(cells.Vertices.size()))
      {
        ComponentCells::Vertex vertex;
        vertex.Position = 0.5 * (cells.Vertices[a].Position + cells.Vertices[b].Position);
        vertex.IsBoundary = true;
        cells.Vertices.push_back(vertex);
      }
      else
      {
        cells.Vertices[middle].IsBoundary = false;
      }
    }
  }
  std::vector<ComponentCells::LineEdge> halves;
  for (const ComponentCells::LineEdge& edge : cells.LineEdges)
  {
    const Index middle = first + edges.Find(edge.Ends[0], edge.Ends[1]);
    cells.Vertices[middle].Line = edge.Line;
    halves.push_back({ { edge.Ends[0], middle }, edge.Line });
    halves.push_back({ { edge.Ends[1], middle }, edge.Line });
  }
  cells.LineEdges = std::move(halves);
  for (std::size_t f = 0; f < coarse.Corners.size(); ++f)
  {
    const Faces::Face& face = coarse.Corners[f];
    const int size = Faces::Size(face);
    const auto center = static_cast<Index>(cells.Vertices.size());
    ComponentCells::Vertex vertex;
    vertex.Position.setZero();
    for (int c = 0; c < size; ++c)
    {
      vertex.Position += cells.Vertices[face[c]].Position / size;
    }
    cells.Vertices.push_back(vertex);
    const auto middleAfter = [&](int c)
    {
      const Index a = face[c % size];
      const Index b = face[(c + 1) % size];
      return first + edges.Find(a, b);
    };
    for (int c = 0; c < size; ++c)
    {
      cells.Cells.Corners.push_back({ face[c], middleAfter(c), center, middleAfter(c + size - 1) });
      cells.Cells.IsRegular.push_back(coarse.IsRegular[f]);
    }
  }
}
}
