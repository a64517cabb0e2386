// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/OwnedParts.h"

#include "Support/PointOrder.h"

namespace DirectionFields::Internal
{
namespace
{
/// The positions of a triangle's corners, in an order that depends on no numbering.
std::array<Vector3, 3> Place(const TriangleMesh& mesh, const Surface& surface, Index t)
{
  std::array<Vector3, 3> corners;
  for (int c = 0; c < 3; ++c)
  {
    corners[c] = surface.Points[mesh.Point(mesh.Tail(3 * t + c))];
  }
  std::sort(corners.begin(), corners.end(), LexicographicallyLess);
  return corners;
}
}

OwnedParts::OwnedParts(const TriangleMesh& mesh, const Surface& surface)
{
  for (const TriangleMesh::Component& component : mesh.GetComponents())
  {
    this->Components.push_back(
      { component.Vertices(), component.Edges(), component.Triangles(), 0 });
  }
  if (!surface.Ghost.empty())
  {
    this->LeaveOutGhosts(mesh, surface);
  }
  for (std::size_t c = 0; c < this->Components.size(); ++c)
  {
    if (mesh.GetComponents()[c].IsCover)
    {
      // Both sides have the same.
      Counts& counts = this->Components[c];
      counts = { counts.Vertices / 2, counts.Edges / 2, counts.Triangles / 2, counts.Ghosts / 2 };
    }
  }
}

void OwnedParts::LeaveOutGhosts(const TriangleMesh& mesh, const Surface& surface)
{
  const auto isGhost = [&](Index t) { return surface.Ghost[mesh.InputTriangle(t)] != 0; };
  const auto isBefore = [&](Index s, Index t)
  {
    const std::array<Vector3, 3> a = Place(mesh, surface, s);
    const std::array<Vector3, 3> b = Place(mesh, surface, t);
    return std::lexicographical_compare(
      a.begin(), a.end(), b.begin(), b.end(), LexicographicallyLess);
  };
  this->Vertex.assign(mesh.GetNumberOfVertices(), 1);
  for (std::size_t c = 0; c < this->Components.size(); ++c)
  {
    const TriangleMesh::Component& component = mesh.GetComponents()[c];
    Counts& counts = this->Components[c];
    for (Index t = component.FirstTriangle; t < component.EndTriangle; ++t)
    {
      counts.Ghosts += isGhost(t);
    }
    counts.Triangles -= counts.Ghosts;
    for (Index e = component.FirstEdge; e < component.EndEdge; ++e)
    {
      const Index h = mesh.HalfEdge(e);
      const Index twin = mesh.Twin(h);
      const bool useTwin =
        twin != None && isGhost(twin / 3) != isGhost(h / 3) && isBefore(twin / 3, h / 3);
      counts.Edges -= isGhost((useTwin ? twin : h) / 3);
    }
    for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
    {
      Index h = mesh.Outgoing(v);
      Index first = h / 3;
      Index ghosts = 0;
      Index fan = 0;
      do
      {
        ++fan;
        ghosts += isGhost(h / 3);
        h = mesh.NextOutgoing(h);
      } while (h != None && h != mesh.Outgoing(v));
      if (ghosts > 0 && ghosts < fan)
      {
        h = mesh.Outgoing(v);
        do
        {
          first = isBefore(h / 3, first) ? h / 3 : first;
          h = mesh.NextOutgoing(h);
        } while (h != None && h != mesh.Outgoing(v));
      }
      if (isGhost(first))
      {
        this->Vertex[v] = 0;
        --counts.Vertices;
      }
    }
  }
}
}
