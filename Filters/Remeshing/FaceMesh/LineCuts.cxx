// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceMesh/LineCuts.h"

#include "FaceMesh/FaceCut.h"
#include "Support/SortedEnds.h"

#include <algorithm>
#include <iterator>

namespace DirectionFields::Internal
{
namespace
{
/// The corner from which a face has an edge; its number of corners if it has it not.
int CornerBefore(const Faces::Face& face, const std::array<Index, 2>& ends)
{
  const int size = Faces::Size(face);
  int at = 0;
  while (at < size && SortedEnds(face[at], face[(at + 1) % size]) != ends)
  {
    ++at;
  }
  return at;
}
}

LineCuts::LineCuts(FaceMesh& mesh)
  : Mesh(mesh)
{
  for (std::size_t k = 0; k < mesh.LineEdges.size(); ++k)
  {
    const std::array<Index, 2>& ends = mesh.LineEdges[k].Ends;
    this->Edges.emplace(SortedEnds(ends[0], ends[1]), k);
  }
}

double LineCuts::QualityOf(Index f, const std::array<Index, 2>& ends, const Vector3& middle) const
{
  const Index part = this->PartWith(f, ends);
  return CutAtEdge(this->Mesh.Points, this->Mesh.Cells.Corners[part], ends, middle).Quality;
}

void LineCuts::Cut(const Wall& wall, const Vector3& middle)
{
  const auto fresh = static_cast<Index>(this->Mesh.Points.size());
  for (const Index f : wall.Faces)
  {
    const Index part = this->PartWith(f, wall.Ends);
    const FaceParts parts =
      CutAtEdge(this->Mesh.Points, this->Mesh.Cells.Corners[part], wall.Ends, middle);
    this->Mesh.Cells.Corners[part] = parts.First;
    this->Mesh.Cells.IsRegular[part] = 0;
    this->PartsOf.emplace(f, static_cast<Index>(this->Mesh.Cells.Corners.size()));
    this->Mesh.Cells.Corners.push_back(parts.Second);
    this->Mesh.Cells.IsRegular.push_back(0);
  }
  this->Mesh.Points.push_back(middle);
  FaceMesh::Vertex vertex;
  vertex.Line = wall.Line;
  vertex.IsBoundary = wall.Faces.size() != 2;
  this->Mesh.Vertices.push_back(vertex);
  std::vector<FaceMesh::LineEdge>& edges = this->Mesh.LineEdges;
  const auto [first, last] = this->Edges.equal_range(wall.Ends);
  std::vector<std::size_t> there;
  std::transform(
    first, last, std::back_inserter(there), [](const auto& item) { return item.second; });
  this->Edges.erase(first, last);
  for (const std::size_t k : there)
  {
    const Index second = edges[k].Ends[1];
    this->Edges.emplace(SortedEnds(edges[k].Ends[0], fresh), k);
    this->Edges.emplace(SortedEnds(fresh, second), edges.size());
    edges[k].Ends[1] = fresh;
    edges.push_back({ { fresh, second }, edges[k].Line });
  }
}

/// The part of a face, which may have been cut before, that has an edge.
Index LineCuts::PartWith(Index f, const std::array<Index, 2>& ends) const
{
  const auto [first, last] = this->PartsOf.equal_range(f);
  const auto part = std::find_if(first, last,
    [&](const auto& item)
    {
      const Faces::Face& face = this->Mesh.Cells.Corners[item.second];
      return CornerBefore(face, ends) < Faces::Size(face);
    });
  return part != last ? part->second : f;
}
}
