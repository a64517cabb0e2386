// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Extraction/MeshExtraction.h"

#include "Extraction/DoubleEdges.h"
#include "Extraction/ExtractionMesh.h"
#include "Extraction/FoldRepair.h"
#include "Extraction/GridPoints.h"
#include "Extraction/Pairing.h"
#include "Extraction/VertexRemoval.h"
#include "Integers/IntegerRounding.h"

#include <algorithm>

namespace DirectionFields::Internal
{
namespace
{
/// The triangles of a component as they are.
ExtractedMesh Unchanged(
  const SurfaceGeometry& geometry, const TriangleMesh::Component& component, MapFailure failure)
{
  const TriangleMesh& mesh = geometry.Mesh;
  ExtractedMesh out;
  out.Failure = failure;
  for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
  {
    ExtractedMesh::Vertex vertex;
    vertex.Position = geometry.Positions[v];
    vertex.Origin = v;
    vertex.IsBoundary = mesh.IsBoundary(v);
    // Nothing is to move.
    vertex.IsCorner = true;
    out.Vertices.push_back(vertex);
  }
  for (Index h = 3 * component.FirstTriangle; h < 3 * component.EndTriangle; h += 3)
  {
    out.Cells.Corners.push_back({ mesh.Tail(h) - component.FirstVertex,
      mesh.Tail(h + 1) - component.FirstVertex, mesh.Tail(h + 2) - component.FirstVertex, None });
    out.Cells.IsRegular.push_back(0);
    for (Index k = h; k < h + 3; ++k)
    {
      // No edge is to be turned.
      out.LineEdges.push_back(
        { { mesh.Tail(k) - component.FirstVertex, mesh.Head(k) - component.FirstVertex }, 0 });
    }
  }
  return out;
}

/// Removes vertices and repairs folds in turn, until neither changes anything. Returns the number
/// of vertices that are no grid points and could not be removed.
Index Reduce(ExtractionMesh& cells, const Progress& progress)
{
  VertexRemoval removal(cells);
  constexpr int mostRounds = 12;
  Index left = removal.RemoveAll(VertexRemoval::Mode::Strict);
  for (int k = 0; k < mostRounds && RepairFolds(cells); ++k)
  {
    progress.RequireToGoOn();
    left = removal.RemoveAll(VertexRemoval::Mode::Strict);
  }
  for (int k = 0; k < mostRounds; ++k)
  {
    progress.RequireToGoOn();
    const Index before = left;
    removal.RemoveAll(VertexRemoval::Mode::Joining);
    RepairFolds(cells);
    left = removal.RemoveAll(VertexRemoval::Mode::Strict);
    if (left >= before)
    {
      break;
    }
  }
  for (int k = 0; k < mostRounds; ++k)
  {
    progress.RequireToGoOn();
    left = removal.RemoveAll(VertexRemoval::Mode::Relaxed);
    if (!RepairFolds(cells))
    {
      break;
    }
  }
  return left;
}

/// Copies the remaining vertices, numbered without gaps, and the faces between them.
void Collect(const ExtractionMesh& cells, const CutMesh& cutMesh,
  const TriangleMesh::Component& component, ExtractedMesh& out)
{
  std::vector<Index> number(cells.GetNumberOfVertices(), None);
  std::vector<Index> star;
  for (Index v = 0; v < cells.GetNumberOfVertices(); ++v)
  {
    if (!cells.IsVertex(v))
    {
      continue;
    }
    number[v] = static_cast<Index>(out.Vertices.size());
    ExtractedMesh::Vertex vertex;
    vertex.Position = cells.Position(v);
    vertex.Origin = v < component.Vertices() ? component.FirstVertex + v : None;
    vertex.IsBoundary = cells.GetStar(v, star);
    vertex.IsCorner = cells.GetRole(v).IsCorner;
    vertex.IsCone = cells.GetRole(v).IsCone;
    vertex.SingularityIndex =
      vertex.IsCone && v < static_cast<Index>(cutMesh.ConeIndex.size()) ? cutMesh.ConeIndex[v] : 0;
    for (const Index h : star)
    {
      vertex.Line = std::max(vertex.Line, cells.Feature(h));
    }
    out.Vertices.push_back(vertex);
  }
  for (Index h = 0; h < 3 * cells.GetNumberOfTriangles(); ++h)
  {
    if (cells.IsTriangle(h / 3) && cells.IsFeature(h) && cells.Twin(h) < h)
    {
      out.LineEdges.push_back(
        { { number[cells.Tail(h)], number[cells.Head(h)] }, cells.Feature(h) });
    }
  }
  out.Cells = PairTriangles(cells);
  for (Faces::Face& face : out.Cells.Corners)
  {
    for (Index& v : face)
    {
      v = v == None ? None : number[v];
    }
  }
}

/// The cells of a map.
ExtractedMesh CellsOf(const ComponentMap& mapped, const Progress& progress)
{
  ExtractionMesh cells(mapped.Mesh, mapped.Map);
  SplitDoubleEdges(cells);
  InsertGridPoints(cells);
  progress.Report(0.3);
  ExtractedMesh out;
  out.KeptVertices = Reduce(cells, progress);
  out.FlippedTriangles = mapped.Map.CountFlipped();
  out.Integers = mapped.Map.GetNumberOfIntegers();
  out.Cones = static_cast<Index>(std::count_if(mapped.Mesh.Cones.begin(), mapped.Mesh.Cones.end(),
    [](const CutMesh::Cone& cone) { return cone.Holonomy.Turn != 0; }));
  Collect(cells, mapped.Mesh, mapped.Component, out);
  progress.Report(1.0);
  return out;
}
}

ExtractedMesh ExtractMesh(
  const SurfaceGeometry& geometry, const ComponentMap& map, const Progress& progress)
{
  const std::optional<MapFailure>& failure = map.Map.GetFailure();
  return failure ? Unchanged(geometry, map.Component, *failure) : CellsOf(map, progress);
}

bool AreCostly(const std::vector<ExtractedMesh>& extracted)
{
  return std::any_of(extracted.begin(), extracted.end(),
    [](const ExtractedMesh& part) { return part.Integers > MostRounded; });
}
}
