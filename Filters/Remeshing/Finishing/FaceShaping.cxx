// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/FaceShaping.h"

#include "FaceMesh/EditedMesh.h"
#include "Improvement/FaceSmoothing.h"
#include "Improvement/QualityRepair.h"
#include "Improvement/ValenceOptimization.h"

namespace DirectionFields::Internal
{
namespace
{
/// The steps before the edits tell which faces can become good.
void Improve(VertexStars& stars, MovableFaces& movable,
  const std::vector<FaceMesh::Vertex>& vertices, const ShapingSettings& settings,
  const Progress& progress)
{
  const int before = 2 * settings.Steps / 3;
  RelaxFaces(movable, before, progress.Part(0.1, 0.4));
  if (settings.EditsFaces)
  {
    OptimizeValences(stars, movable, vertices, settings.Degree, progress.Part(0.4, 0.5));
  }
  RelaxFaces(movable, settings.Steps - before, progress.Part(0.5, 0.7));
  ImproveFaces(movable, progress.Part(0.7, 0.9));
  if (settings.EditsFaces && settings.RepairsFaces)
  {
    RepairQuality(stars, movable, vertices, settings.MayMakeTriangles, settings.Degree,
      progress.Part(0.9, 1.0));
  }
}
}

void ShapeFaces(FaceMesh& mesh, const ShapingSettings& settings, const ClosestPoints& surface,
  const std::vector<ClosestPoints>& lines, const std::vector<double>& edgeLength,
  const VertexPatches& patches, const Progress& progress)
{
  if (settings.Steps == 0 && !settings.Joins)
  {
    return;
  }
  VertexStars stars(mesh.Cells, static_cast<Index>(mesh.Points.size()), mesh.LineEdges);
  SmoothingDomain domain{ surface, lines, {}, edgeLength, settings.MostStraying, false, patches,
    settings.IsRough };
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
    TakeOver(stars, mesh);
  }
}
}
