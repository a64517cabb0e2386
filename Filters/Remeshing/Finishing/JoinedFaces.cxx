// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/JoinedFaces.h"

#include <algorithm>

namespace DirectionFields::Internal
{
FaceMesh JoinFaces(const std::vector<ExtractedMesh>& components, const Seams& seams,
  const std::vector<char>& isTurn, Index& open)
{
  FaceMesh mesh;
  const std::vector<Index> joined = seams.Joined(components, open);
  std::vector<Index> number(joined.size(), None);
  std::size_t k = 0;
  for (const ExtractedMesh& cells : components)
  {
    for (const ExtractedMesh::Vertex& vertex : cells.Vertices)
    {
      const auto own = static_cast<Index>(k++);
      const bool isCorner = vertex.IsCorner &&
        (vertex.Line == 0 || vertex.Origin == None || isTurn[vertex.Origin] != 0);
      if (joined[own] != own)
      {
        number[own] = number[joined[own]];
        Index& line = mesh.Vertices[number[own]].Line;
        // A vertex between those of a component that is kept has no line of its own.
        line = isCorner || line < 0 ? -1 : std::max(line, vertex.Line);
        continue;
      }
      number[own] = static_cast<Index>(mesh.Points.size());
      mesh.Points.push_back(vertex.Position);
      mesh.Vertices.push_back({ isCorner ? -1 : vertex.Line, vertex.IsBoundary, vertex.IsCone,
        vertex.SingularityIndex, vertex.Origin });
    }
  }
  k = 0;
  for (const ExtractedMesh& cells : components)
  {
    for (const Faces::Face& face : cells.Cells.Corners)
    {
      Faces::Face corners{};
      for (int c = 0; c < 4; ++c)
      {
        corners[c] = face[c] == None ? None : number[face[c] + k];
      }
      mesh.Cells.Corners.push_back(corners);
    }
    mesh.Cells.IsRegular.insert(
      mesh.Cells.IsRegular.end(), cells.Cells.IsRegular.begin(), cells.Cells.IsRegular.end());
    for (const ExtractedMesh::LineEdge& edge : cells.LineEdges)
    {
      mesh.LineEdges.push_back(
        { { number[edge.Ends[0] + k], number[edge.Ends[1] + k] }, edge.Line });
    }
    k += cells.Vertices.size();
  }
  return mesh;
}
}
