// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Extraction/DelaunayFlips.h"

namespace DirectionFields::Internal
{
namespace
{
bool IsToFlip(const CellMesh& mesh, Index h)
{
  const Index g = mesh.Twin(h);
  if (g == None || mesh.IsFeature(h) || h / 3 == g / 3 || !mesh.IsPositive(h / 3) ||
    !mesh.IsPositive(g / 3))
  {
    return false;
  }
  const Lattice& plane = mesh.GetPlane();
  const Index opposite = CellMesh::Previous(h);
  const Index beyond = CellMesh::Previous(g);
  const LatticePoint& a = mesh.Place(h);
  const LatticePoint& b = mesh.Place(CellMesh::Next(h));
  const LatticePoint& c = mesh.Place(opposite);
  const LatticePoint d = plane.Apply(mesh.Across(h), mesh.Place(beyond));
  return plane.IsInCircle(a, b, c, d) && Lattice::Orientation(d, c, a) > 0 &&
    Lattice::Orientation(c, d, b) > 0 && !mesh.AreJoined(mesh.Tail(opposite), mesh.Tail(beyond));
}
}

void MakeDelaunay(CellMesh& mesh, std::vector<Index>& edges)
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
      { CellMesh::Next(h), CellMesh::Previous(h), CellMesh::Next(g), CellMesh::Previous(g) });
  }
}
}
