// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Geometry/DihedralAngles.h"

#include "Support/Threads.h"
#include "Support/VectorMath.h"

#include <algorithm>
#include <array>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index FewEdges = 64;
}

std::vector<double> DihedralAngles(const SurfaceGeometry& geometry)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const auto point = [&](Index h) -> const Vector3& { return geometry.Positions[mesh.Tail(h)]; };
  std::vector<Vector3> normals(mesh.GetNumberOfTriangles());
  ParallelFor(mesh.GetNumberOfTriangles(), MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        const Vector3& a = point(3 * t);
        normals[t] = (point(3 * t + 1) - a)
                       .stableNormalized()
                       .cross((point(3 * t + 2) - a).stableNormalized())
                       .stableNormalized();
      }
    });
  std::vector<double> angles(mesh.GetNumberOfEdges());
  ParallelFor(mesh.GetNumberOfEdges(), MediumPiece,
    [&](Index begin, Index end)
    {
      std::array<Complex, FewEdges> turns;
      for (Index first = begin; first < end; first += FewEdges)
      {
        const Index last = std::min(end, first + FewEdges);
        for (Index e = first; e < last; ++e)
        {
          const Index h = mesh.HalfEdge(e);
          const Index twin = mesh.Twin(h);
          turns[e - first] = 0.0;
          if (twin != None)
          {
            const Vector3& left = normals[h / 3];
            const Vector3& right = normals[twin / 3];
            const Vector3 along = (point(twin) - point(h)).stableNormalized();
            turns[e - first] = Complex(left.dot(right), along.dot(left.cross(right)));
          }
        }
        Arguments(turns.data(), last - first, angles.data() + first);
      }
    });
  return angles;
}
}
