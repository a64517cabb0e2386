// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PureQuads/QuadSplit.h"

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

void SplitIntoQuads(FaceMesh& mesh)
{
  const Faces coarse = std::move(mesh.Cells);
  mesh.Cells = {};
  // The middle of edge e is vertex first + e.
  const auto first = static_cast<Index>(mesh.Points.size());
  Edges edges(mesh.Points.size());
  // How many faces each edge has.
  std::vector<int> faces;
  for (const Faces::Face& face : coarse.Corners)
  {
    const int size = Faces::Size(face);
    for (int c = 0; c < size; ++c)
    {
      const Index a = face[c];
      const Index b = face[(c + 1) % size];
      const Index e = edges.Find(a, b);
      if (e == static_cast<Index>(faces.size()))
      {
        mesh.Points.emplace_back(0.5 * (mesh.Points[a] + mesh.Points[b]));
        mesh.Vertices.emplace_back();
        faces.push_back(0);
      }
      ++faces[e];
    }
  }
  for (std::size_t e = 0; e < faces.size(); ++e)
  {
    mesh.Vertices[first + e].IsBoundary = faces[e] != 2;
  }
  std::vector<FaceMesh::LineEdge> halves;
  for (const FaceMesh::LineEdge& edge : mesh.LineEdges)
  {
    const Index middle = first + edges.Find(edge.Ends[0], edge.Ends[1]);
    mesh.Vertices[middle].Line = edge.Line;
    halves.push_back({ { edge.Ends[0], middle }, edge.Line });
    halves.push_back({ { edge.Ends[1], middle }, edge.Line });
  }
  mesh.LineEdges = std::move(halves);
  for (std::size_t f = 0; f < coarse.Corners.size(); ++f)
  {
    const Faces::Face& face = coarse.Corners[f];
    const int size = Faces::Size(face);
    const auto center = static_cast<Index>(mesh.Points.size());
    Vector3 sum = Vector3::Zero();
    for (int c = 0; c < size; ++c)
    {
      sum += mesh.Points[face[c]];
    }
    mesh.Points.emplace_back(sum / size);
    mesh.Vertices.emplace_back();
    const auto middleAfter = [&](int c)
    {
      const Index a = face[c % size];
      const Index b = face[(c + 1) % size];
      return first + edges.Find(a, b);
    };
    for (int c = 0; c < size; ++c)
    {
      mesh.Cells.Corners.push_back({ face[c], middleAfter(c), center, middleAfter(c + size - 1) });
      mesh.Cells.IsRegular.push_back(coarse.IsRegular[f]);
    }
  }
}
}
