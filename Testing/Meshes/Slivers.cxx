// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces that are triangulated badly.

#include "Mesh/TriangleMesh.h"
#include "Meshes/Surfaces.h"

#include <cmath>
#include <random>

using namespace DirectionFields;

namespace Meshes
{
namespace
{
Vector3 Normal(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return (b - a).cross(c - a);
}
}

Surface Scrambled(Surface surface, unsigned seed)
{
  std::mt19937 random(seed);
  TriangleMesh mesh(surface);
  const auto at = [&](Index h) -> const Vector3&
  { return surface.Points[mesh.Point(mesh.Tail(h))]; };
  for (Index k = 0; k < 4 * mesh.GetNumberOfEdges(); ++k)
  {
    const auto edge = static_cast<Index>(random() % mesh.GetNumberOfEdges());
    const Index h = mesh.HalfEdge(edge);
    const Index g = mesh.Twin(h);
    if (g == None)
    {
      continue;
    }
    const Vector3& left = at(TriangleMesh::Previous(h));
    const Vector3& right = at(TriangleMesh::Previous(g));
    const Vector3 n = Normal(at(h), at(g), left).normalized();
    const bool plane = n.cross(Normal(at(g), at(h), right)).norm() < 1e-12;
    // Not so bad that lengths would be mended.
    const double least = 5e-3 * (left - right).squaredNorm();
    if (plane && Normal(right, left, at(h)).dot(n) > least &&
      Normal(left, right, at(g)).dot(n) > least)
    {
      mesh.FlipEdge(edge);
    }
  }
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      surface.Triangles[t][c] = mesh.Point(mesh.Tail(3 * t + c));
    }
  }
  return surface;
}

Surface Folded(Surface surface, double angle)
{
  for (Vector3& p : surface.Points)
  {
    const double beyond = p.x() - 0.5;
    if (beyond > 0.0)
    {
      p.x() = 0.5 + std::cos(angle) * beyond;
      p.z() = std::sin(angle) * beyond;
    }
  }
  return surface;
}

Surface BadSquare(int cells, unsigned seed)
{
  Surface surface = Square(cells);
  std::mt19937 random(seed);
  const auto pick = [&] { return 0.5 * (random() / 4294967296.0 - 0.5) / cells; };
  for (Vector3& p : surface.Points)
  {
    const double dx = pick();
    const double dy = pick();
    if (p.x() > 0.0 && p.x() < 1.0 && p.y() > 0.0 && p.y() < 1.0)
    {
      p += Vector3(p.x() == 0.5 ? 0.0 : dx, dy, 0.0);
    }
  }
  return { surface.Points, Scrambled(Folded(surface, 0.3), seed).Triangles };
}

Surface BadSphere(int levels, double length, unsigned seed)
{
  Surface surface = Jittered(Icosphere(levels), length, seed);
  for (Vector3& p : surface.Points)
  {
    p.normalize();
  }
  return surface;
}
}
