// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Exchange/SharpEdges.h"

#include "Features/FeatureChains.h"
#include "Geometry/DihedralAngles.h"
#include "Geometry/SurfaceGeometry.h"

#include <algorithm>
#include <tuple>

namespace DirectionFields::Internal
{
std::vector<SharpEdge> FindSharpEdges(
  const Surface& surface, double featureAngle, double minimumLength)
{
  const SurfaceGeometry geometry(surface);
  const TriangleMesh& mesh = geometry.Mesh;
  const std::vector<double> dihedral = DihedralAngles(geometry);
  const FeatureChains features(geometry, dihedral, { featureAngle * Pi / 180.0, minimumLength });
  std::vector<SharpEdge> edges;
  for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const bool isRim = mesh.Twin(h) == None;
    if (!mesh.IsFront(h / 3) || (!isRim && !features.IsFeature(mesh.Edge(h))))
    {
      continue;
    }
    const Index input = mesh.InputTriangle(h / 3);
    const Triangle& corners = surface.Triangles[input];
    const std::array<Index, 2> ends = { mesh.Point(mesh.Tail(h)), mesh.Point(mesh.Head(h)) };
    for (int c = 0; c < 3; ++c)
    {
      const Index from = corners[c];
      const Index to = corners[(c + 1) % 3];
      // A triangle that is wound against the others has its edges the other way.
      if ((from == ends[0] && to == ends[1]) || (from == ends[1] && to == ends[0]))
      {
        edges.push_back({ isRim || dihedral[mesh.Edge(h)] >= 0.0, input, c });
      }
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const SharpEdge& a, const SharpEdge& b)
    { return std::tie(a.Triangle, a.Corner) < std::tie(b.Triangle, b.Corner); });
  return edges;
}
}
