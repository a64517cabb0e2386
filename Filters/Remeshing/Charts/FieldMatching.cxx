// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Charts/FieldMatching.h"

#include "Support/Threads.h"

#include <cmath>

namespace DirectionFields::Internal
{
FieldMatching::FieldMatching(
  const IntrinsicGeometry& geometry, int degree, const std::vector<Complex>& section)
  : Degree(degree)
  , Angle(geometry.Mesh.GetNumberOfVertices())
  , Matching(geometry.Mesh.GetNumberOfEdges())
  , Remainder(geometry.Mesh.GetNumberOfEdges())
  , SingularityIndex(geometry.Mesh.GetNumberOfTriangles())
{
  const TriangleMesh& mesh = geometry.Mesh;
  ParallelFor(mesh.GetNumberOfVertices(), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        this->Angle[v] = std::arg(section[v]) / degree;
      }
    });
  const double step = 2.0 * Pi / degree;
  ParallelFor(mesh.GetNumberOfEdges(), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index e = begin; e < end; ++e)
      {
        const Index h = mesh.HalfEdge(e);
        const double difference = this->AngleAtTail(geometry, h) - this->AngleAtHead(geometry, h);
        const double m = std::nearbyint(difference / step);
        this->Remainder[e] = difference - m * step;
        const int wrapped = static_cast<int>(m) % degree;
        this->Matching[e] = wrapped < 0 ? wrapped + degree : wrapped;
      }
    });
  ParallelFor(mesh.GetNumberOfTriangles(), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        const double sum = geometry.Transport.Curvature[t] + this->RemainderAlong(mesh, 3 * t) +
          this->RemainderAlong(mesh, 3 * t + 1) + this->RemainderAlong(mesh, 3 * t + 2);
        this->SingularityIndex[t] = static_cast<int>(std::lround(sum / step));
      }
    });
}
}
