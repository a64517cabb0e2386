// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Extraction/MeshExtraction.h"

#include "Extraction/DoubleEdges.h"
#include "Extraction/ExtractionMesh.h"
#include "Extraction/FoldRepair.h"
#include "Extraction/GridPoints.h"
#include "Extraction/Pairing.h"
#include "Extraction/VertexRemoval.h"
#include "Parametrization/IntegerGridMap.h"
#include "Parametrization/NarrowCorners.h"

#include <algorithm>

namespace DirectionFields::Internal
{
namespace
{
/// Maps that are made of a component, each with fewer features than the one before.
constexpr int MostAttempts = 3;

/// The triangles of a component as they are.
ExtractedMesh Unchanged(
  const ExtractionInput& input, const TriangleMesh::Component& component, const char* failure)
{
  const TriangleMesh& mesh = input.Geometry.Mesh;
  ExtractedMesh out;
  out.Failure = failure;
  for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
  {
    ExtractedMesh::Vertex vertex;
    vertex.Position = input.Geometry.Positions[v];
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

/// Removes what can be removed, and mends folds, until neither does anything.
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

/// The vertices that are left, numbered anew.
void Collect(const ExtractionMesh& cells, const CutMesh& charted,
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
      vertex.IsCone && v < static_cast<Index>(charted.ConeIndex.size()) ? charted.ConeIndex[v] : 0;
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

IntegerGridMap::Settings SettingsFor(
  const ExtractionInput& input, const TriangleMesh::Component& component, const CutMesh& charted)
{
  IntegerGridMap::Settings settings;
  settings.PerLength.assign(charted.Positions.size(), 0.0);
  std::copy(input.PerLength.begin() + component.FirstVertex,
    input.PerLength.begin() + component.EndVertex, settings.PerLength.begin());
  for (const CutMesh::MapTriangle& t : charted.Triangles)
  {
    // The cones are the first corners of their triangles.
    if (t.Vertex[0] >= component.Vertices())
    {
      settings.PerLength[t.Vertex[0]] = settings.PerLength[t.Vertex[1]];
    }
  }
  return settings;
}

/// Takes back features that came to nothing in a map: without them there is a better one. The boundary stays.
/// Returns whether there were any.
bool DropFeatures(const ExtractionInput& input, const TriangleMesh::Component& component,
  const std::vector<Index>& edges)
{
  const TriangleMesh& mesh = input.Geometry.Mesh;
  bool hasDropped = false;
  for (const Index e : edges)
  {
    if (mesh.Twin(mesh.HalfEdge(e)) != None)
    {
      input.Features.IsFeature[e] = 0;
      input.Features.Line[e] = 0;
      hasDropped = true;
    }
  }
  if (hasDropped)
  {
    UpdateFrameless(
      input.Geometry, input.Charts.Degree, component, input.Features.IsFeature, input.IsFrameless);
  }
  return hasDropped;
}

/// The cells of a map.
void Extract(const TriangleMesh::Component& component, const CutMesh& charted,
  const IntegerGridMap& map, const Progress& progress, ExtractedMesh& out)
{
  ExtractionMesh cells(charted, map);
  SplitDoubleEdges(cells);
  InsertGridPoints(cells);
  progress.Report(0.3);
  out.KeptVertices = Reduce(cells, progress);
  out.FlippedTriangles = map.CountFlipped();
  out.Integers = map.GetNumberOfIntegers();
  out.Cones = static_cast<Index>(std::count_if(charted.Cones.begin(), charted.Cones.end(),
    [](const CutMesh::Cone& cone) { return cone.Holonomy.Turn != 0; }));
  Collect(cells, charted, component, out);
  progress.Report(1.0);
}
}

ExtractedMesh ExtractMesh(
  const ExtractionInput& input, const TriangleMesh::Component& component, const Progress& progress)
{
  DropFeatures(input, component,
    EdgesInNarrowCorners(
      input.Geometry, component, input.Charts, input.Features, input.IsFrameless, input.PerLength));
  ParametrizationCache& kept = input.Maps[&component - input.Geometry.Mesh.GetComponents().data()];
  ExtractedMesh out;
  for (int attempt = 0; attempt < MostAttempts; ++attempt)
  {
    const CutMesh& charted = kept.MeshFor(
      input.Geometry, component, input.Charts, input.Features, input.IsFrameless, input.Section);
    const IntegerGridMap::Settings settings = SettingsFor(input, component, charted);
    const IntegerGridMap map(
      kept.EquationsFor(settings.PerLength), settings, progress.Part(0.15, 0.7));
    kept.Shrink(static_cast<double>(component.Triangles()) /
      static_cast<double>(input.Geometry.Mesh.GetNumberOfTriangles()));
    if (map.GetFailure() != nullptr)
    {
      return Unchanged(input, component, map.GetFailure());
    }
    if (attempt + 1 < MostAttempts && DropFeatures(input, component, map.GetCollapsedFeatures()))
    {
      continue;
    }
    Extract(component, charted, map, progress.Part(0.7, 1.0), out);
    break;
  }
  return out;
}
}
