// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Extraction/FoldRepair.h"

#include <algorithm>

namespace DirectionFields::Internal
{
namespace
{
/// Of two grid points at the same place in the ring of a vertex that could not be removed, one need
/// not stay. Near a cone or corner only grid points at its own place are given up: others may lie
/// on different sheets.
bool TakeBack(ExtractionMesh& mesh, Index v, ExtractionMesh::Layout& layout)
{
  mesh.LayOut(v, layout);
  const auto isCone = [&](Index w) { return mesh.GetRole(w).IsCone || mesh.GetRole(w).IsCorner; };
  const bool hasCone = std::any_of(layout.Ring.begin(), layout.Ring.end(), isCone);
  if (!layout.IsFlat || (!hasCone && layout.Positive == static_cast<Index>(layout.Star.size())))
  {
    return false;
  }
  const auto isPoint = [&](Index w)
  { return mesh.GetRole(w).IsKept && !mesh.GetRole(w).IsCone && !mesh.GetRole(w).IsCorner; };
  for (std::size_t i = 0; i < layout.Ring.size(); ++i)
  {
    for (std::size_t j = 0; j < layout.Ring.size(); ++j)
    {
      const Index a = layout.Ring[i];
      const Index b = layout.Ring[j];
      if (a == b || layout.Places[i] != layout.Places[j] || !isPoint(b))
      {
        continue;
      }
      const bool isFirst = hasCone ? isCone(a) : isPoint(a) && a < b;
      if (isFirst)
      {
        mesh.SetKept(b, false);
        return true;
      }
    }
  }
  return false;
}

int CountFeatures(const ExtractionMesh& mesh, Index v)
{
  std::vector<Index> star;
  int count = mesh.GetStar(v, star) ? 1 : 0;
  for (const Index h : star)
  {
    count += mesh.IsFeature(h) ? 1 : 0;
  }
  return count;
}

/// Whether a vertex may move onto its neighbour: along features only, and corners stay.
bool MayMove(const ExtractionMesh& mesh, Index h)
{
  const Index v = mesh.Tail(h);
  return !mesh.GetRole(v).IsCorner && (mesh.IsFeature(h) || CountFeatures(mesh, v) == 0);
}

bool CollapseZeroEdges(ExtractionMesh& mesh)
{
  bool hasChanged = false;
  ExtractionMesh::Layout layout;
  for (Index h = 0; h < 3 * mesh.GetNumberOfTriangles(); ++h)
  {
    if (!mesh.IsTriangle(h / 3) || mesh.Place(h) != mesh.Place(ExtractionMesh::Next(h)))
    {
      continue;
    }
    const Index v = mesh.Tail(h);
    const Index w = mesh.Head(h);
    // A vertex that is no grid point is merged into the other one; of two cones the one that may
    // move.
    const auto rank = [&](Index u)
    {
      const ExtractionMesh::Role& role = mesh.GetRole(u);
      return role.IsCorner ? 3 : role.IsCone ? 2 : role.IsKept ? 1 : 0;
    };
    const Index twin = mesh.Twin(h);
    Index edge = rank(v) <= rank(w) || twin == None ? h : twin;
    const auto isPossible = [&](Index k)
    { return k != None && MayMove(mesh, k) && mesh.MayCollapse(k); };
    if (!isPossible(edge))
    {
      // A cone beside a feature moves onto it, but not onto the boundary, where faces would get
      // worse.
      edge = edge == h ? twin : h;
      if (!isPossible(edge) || mesh.IsBoundary(mesh.Head(edge)))
      {
        continue;
      }
    }
    const Index stays = mesh.Head(edge);
    const bool isKept = mesh.GetRole(v).IsKept || mesh.GetRole(w).IsKept;
    mesh.Collapse(edge);
    mesh.LayOut(stays, layout);
    mesh.SetCone(stays, !layout.IsFlat);
    mesh.SetKept(stays, isKept);
    hasChanged = true;
  }
  return hasChanged;
}
}

bool RepairFolds(ExtractionMesh& mesh)
{
  bool hasChanged = false;
  ExtractionMesh::Layout layout;
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (mesh.IsVertex(v) && !mesh.GetRole(v).IsKept)
    {
      hasChanged = TakeBack(mesh, v, layout) || hasChanged;
    }
  }
  return CollapseZeroEdges(mesh) || hasChanged;
}
}
