// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Extraction/BoundaryVertices.h"

#include "Support/SortedEnds.h"

#include <algorithm>

namespace DirectionFields::Internal
{
namespace
{
/// Cuts the face at an edge that becomes a path into one quad, if it was one, and triangles.
void CutFace(Faces& faces, Index f, const std::vector<Index>& path, std::vector<Index>& parts)
{
  const Faces::Face face = faces.Corners[f];
  const int size = Faces::Size(face);
  const auto at =
    static_cast<int>(std::find(face.begin(), face.end(), path.front()) - face.begin());
  const Index after = face[(at + 2) % size];
  const Index before = face[(at + size - 1) % size];
  const std::size_t middle = (path.size() - 1) / 2;
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    Faces::Face part{ path[i], path[i + 1], i < middle ? before : after, None };
    if (i == middle && size == 4)
    {
      part[3] = before;
    }
    if (i == 0)
    {
      faces.Corners[f] = part;
      faces.IsRegular[f] = 0;
    }
    else
    {
      parts.push_back(static_cast<Index>(faces.Corners.size()));
      faces.Corners.push_back(part);
      faces.IsRegular.push_back(0);
    }
  }
}

bool HasEdge(const Faces::Face& face, Index tail, Index head)
{
  for (int c = 0; c < Faces::Size(face); ++c)
  {
    if (face[c] == tail && face[(c + 1) % Faces::Size(face)] == head)
    {
      return true;
    }
  }
  return false;
}
}

void InsertBoundaryVertices(ExtractedMesh& cells, std::vector<BoundaryVertices>& all)
{
  std::sort(all.begin(), all.end(),
    [&](const BoundaryVertices& a, const BoundaryVertices& b)
    { return SortedEnds(a.Tail, a.Head) < SortedEnds(b.Tail, b.Head); });
  std::vector<ExtractedMesh::LineEdge> others;
  for (const ExtractedMesh::LineEdge& edge : cells.LineEdges)
  {
    const std::array<Index, 2> key = SortedEnds(edge.Ends[0], edge.Ends[1]);
    const auto found = std::lower_bound(all.begin(), all.end(), key,
      [&](const BoundaryVertices& i, const std::array<Index, 2>& k)
      { return SortedEnds(i.Tail, i.Head) < k; });
    if (found != all.end() && SortedEnds(found->Tail, found->Head) == key)
    {
      found->Line = edge.Line;
    }
    else
    {
      others.push_back(edge);
    }
  }
  cells.LineEdges = std::move(others);
  std::sort(all.begin(), all.end(),
    [](const BoundaryVertices& a, const BoundaryVertices& b)
    { return a.Face != b.Face ? a.Face < b.Face : a.Tail < b.Tail; });
  // A face with two edges on seams is cut twice: the second time the part that has the edge.
  std::vector<Index> parts;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const BoundaryVertices& inserted = all[i];
    if (i == 0 || all[i - 1].Face != inserted.Face)
    {
      parts = { inserted.Face };
    }
    std::vector<Index> path = { inserted.Tail };
    for (const Vector3& position : inserted.Positions)
    {
      path.push_back(static_cast<Index>(cells.Vertices.size()));
      ExtractedMesh::Vertex vertex;
      vertex.Position = position;
      vertex.Line = inserted.Line;
      vertex.IsBoundary = true;
      cells.Vertices.push_back(vertex);
    }
    path.push_back(inserted.Head);
    for (std::size_t k = 0; inserted.Line > 0 && k + 1 < path.size(); ++k)
    {
      cells.LineEdges.push_back({ { path[k], path[k + 1] }, inserted.Line });
    }
    const auto part = std::find_if(parts.begin(), parts.end(),
      [&](Index f) { return HasEdge(cells.Cells.Corners[f], inserted.Tail, inserted.Head); });
    const Index face = *part;
    CutFace(cells.Cells, face, path, parts);
  }
}
}
