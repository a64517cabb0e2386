// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Quads/QuadSplit.h"

#include <map>

namespace DirectionFields::Internal
{
void SplitIntoQuads(ComponentCells& cells)
{
  const Faces coarse = std::move(cells.Cells);
  cells.Cells = {};
  struct Edge
  {
    Index Middle;
    int Faces;
  };
  std::map<std::array<Index, 2>, Edge> edges;
  for (const Faces::Face& face : coarse.Corners)
  {
    const int size = Faces::Size(face);
    for (int c = 0; c < size; ++c)
    {
      const Index a = face[c];
      const Index b = face[(c + 1) % size];
      const auto [edge, isNew] = edges.insert({ { std::min(a, b), std::max(a, b) }, { None, 0 } });
      ++edge->second.Faces;
      if (isNew)
      {
        edge->second.Middle = static_cast<Index>(cells.Vertices.size());
        ComponentCells::Vertex vertex;
        vertex.Position = 0.5 * (cells.Vertices[a].Position + cells.Vertices[b].Position);
        cells.Vertices.push_back(vertex);
      }
    }
  }
  const auto& lines = cells.EdgeLines;
  for (const auto& [ends, edge] : edges)
  {
    ComponentCells::Vertex& vertex = cells.Vertices[edge.Middle];
    vertex.IsBoundary = edge.Faces == 1;
    const auto line = lines.find(ends);
    vertex.Line = line != lines.end() ? line->second : 0;
  }
  std::map<std::array<Index, 2>, Index> halves;
  for (const auto& [ends, line] : lines)
  {
    const Index middle = edges.at(ends).Middle;
    halves[{ ends[0], middle }] = halves[{ ends[1], middle }] = line;
  }
  cells.EdgeLines = std::move(halves);
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
      return edges.at({ std::min(a, b), std::max(a, b) }).Middle;
    };
    for (int c = 0; c < size; ++c)
    {
      cells.Cells.Corners.push_back({ face[c], middleAfter(c), center, middleAfter(c + size - 1) });
      cells.Cells.IsRegular.push_back(coarse.IsRegular[f]);
    }
  }
}
}
