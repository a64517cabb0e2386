// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceMesh/EditedMesh.h"

#include "Support/SortedEnds.h"

#include <algorithm>
#include <array>
#include <map>

namespace DirectionFields::Internal
{
namespace
{
/// The edges of lines that faces have after changes.
std::vector<FaceMesh::LineEdge> LineEdgesOf(const VertexStars& stars, const FaceMesh& mesh)
{
  std::map<std::array<Index, 2>, Index> lines;
  for (const FaceMesh::LineEdge& edge : mesh.LineEdges)
  {
    lines[SortedEnds(edge.Ends[0], edge.Ends[1])] = edge.Line;
  }
  for (const VertexStars::Change& change : stars.GetChanges())
  {
    if (change.Face == None)
    {
      const auto [goes, stays, other, none] = change.Corners;
      lines[SortedEnds(stays, other)] = mesh.Vertices[goes].Line;
    }
  }
  std::vector<FaceMesh::LineEdge> edges;
  for (const auto& [ends, line] : lines)
  {
    if (stars.IsLineEdge(ends[0], ends[1]) && stars.AreJoined(ends[0], ends[1]))
    {
      edges.push_back({ ends, line });
    }
  }
  return edges;
}
}

std::vector<Index> TakeOver(const VertexStars& stars, FaceMesh& mesh)
{
  mesh.LineEdges = LineEdgesOf(stars, mesh);
  std::vector<Index> number(mesh.Points.size(), None);
  Index left = 0;
  for (std::size_t v = 0; v < number.size(); ++v)
  {
    if (!stars.At(static_cast<Index>(v)).empty())
    {
      number[v] = left;
      mesh.Points[left] = mesh.Points[v];
      mesh.Vertices[left] = mesh.Vertices[v];
      ++left;
    }
  }
  mesh.Points.resize(left);
  mesh.Vertices.resize(left);
  mesh.Cells = stars.Compressed();
  for (Faces::Face& face : mesh.Cells.Corners)
  {
    for (Index& v : face)
    {
      v = v == None ? None : number[v];
    }
  }
  for (FaceMesh::LineEdge& edge : mesh.LineEdges)
  {
    edge.Ends = { number[edge.Ends[0]], number[edge.Ends[1]] };
  }
  return number;
}
}
