// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Extraction/DelaunayFlips.h"

namespace DirectionFields::Internal
{
namespace
{
bool IsToFlip(const ExtractionMesh& mesh, Index h)
{
  const Index g = mesh.Twin(h);
  if (g == None || mesh.IsFeature(h) || h / 3 == g / 3 || !mesh.IsPositive(h / 3) ||
    !mesh.IsPositive(g / 3))
  {
    return false;
  }
  const IntegerGrid& plane = mesh.GetPlane();
  const Index opposite = ExtractionMesh::Previous(h);
  const Index beyond = ExtractionMesh::Previous(g);
  const GridPoint& a = mesh.Place(h);
  const GridPoint& b = mesh.Place(ExtractionMesh::Next(h));
  const GridPoint& c = mesh.Place(opposite);
  const GridPoint d = plane.Apply(mesh.Across(h), mesh.Place(beyond));
  return plane.IsInCircle(a, b, c, d) && IntegerGrid::Orientation(d, c, a) > 0 &&
    IntegerGrid::Orientation(c, d, b) > 0 &&
    !mesh.AreJoined(mesh.Tail(opposite), mesh.Tail(beyond));
}
}

void MakeDelaunay(ExtractionMesh& mesh, std::vector<Index>& edges)
{
  while (!edges.empty())
  {
    const Index h = edges.back();
    edges.pop_back();
    if (!mesh.IsTriangle(h / 3) || !IsToFlip(mesh, h))
    {
      continue;
    }
    const Index g = mesh.Twin(h);
    mesh.Flip(h);
    edges.insert(edges.end(),
      { ExtractionMesh::Next(h), ExtractionMesh::Previous(h), ExtractionMesh::Next(g),
        ExtractionMesh::Previous(g) });
  }
}
}
