// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/FaceShaping.h"

#include "Improvement/FaceSmoothing.h"
#include "Improvement/QualityRepair.h"
#include "Improvement/ValenceOptimization.h"

#include <algorithm>
#include <map>

namespace DirectionFields::Internal
{
namespace
{
std::array<Index, 2> EndsOf(Index a, Index b)
{
  return { std::min(a, b), std::max(a, b) };
}

/// The edges of lines that faces have after changes.
std::vector<FaceMesh::LineEdge> LineEdgesOf(const VertexStars& stars, const FaceMesh& mesh)
{
  std::map<std::array<Index, 2>, Index> lines;
  for (const FaceMesh::LineEdge& edge : mesh.LineEdges)
  {
    lines[EndsOf(edge.Ends[0], edge.Ends[1])] = edge.Line;
  }
  for (const VertexStars::Change& change : stars.GetChanges())
  {
    if (change.Face == None)
    {
      const auto [goes, stays, other, none] = change.Corners;
      lines[EndsOf(stays, other)] = mesh.Vertices[goes].Line;
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

/// Takes out the faces and vertices that are no longer used.
void Compress(const VertexStars& stars, FaceMesh& mesh)
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
}

/// The steps before the edits tell which faces can become good.
void Improve(VertexStars& stars, MovableFaces& movable,
  const std::vector<FaceMesh::Vertex>& vertices, const ShapingSettings& settings,
  const Progress& progress)
{
  const int before = 2 * settings.Steps / 3;
  RelaxFaces(movable, before, progress.Part(0.1, 0.4));
  if (settings.AreQuads)
  {
    OptimizeValences(stars, movable, vertices, progress.Part(0.4, 0.5));
  }
  RelaxFaces(movable, settings.Steps - before, progress.Part(0.5, 0.7));
  ImproveFaces(movable, progress.Part(0.7, 0.9));
  if (settings.AreQuads && settings.RepairsFaces)
  {
    RepairQuality(stars, movable, vertices, settings.MayMakeTriangles, progress.Part(0.9, 1.0));
  }
}
}

void ShapeFaces(FaceMesh& mesh, const ShapingSettings& settings, const ClosestPoints& surface,
  const std::vector<ClosestPoints>& lines, const std::vector<double>& edgeLength,
  const Progress& progress)
{
  if (settings.Steps == 0 && !settings.Joins)
  {
    return;
  }
  VertexStars stars(mesh.Cells, static_cast<Index>(mesh.Points.size()), mesh.LineEdges);
  SmoothingDomain domain{ surface, lines, {}, edgeLength };
  for (const FaceMesh::Vertex& vertex : mesh.Vertices)
  {
    domain.Line.push_back(vertex.Line);
  }
  MovableFaces movable(stars, domain, mesh.Points);
  if (settings.Joins)
  {
    JoinTriangles(stars, movable, mesh.Vertices, *settings.Joins, progress.Part(0.0, 0.1));
  }
  if (settings.Steps > 0)
  {
    Improve(stars, movable, mesh.Vertices, settings, progress);
  }
  if (!stars.GetChanges().empty())
  {
    Compress(stars, mesh);
  }
}
}
