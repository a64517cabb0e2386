// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Singularities.h"

#include "LargeArray.h"
#include "Threads.h"
#include "VectorMath.h"

#include <cmath>

namespace DirectionFields
{
namespace
{
constexpr Index PieceSize = 1 << 13;
}

std::vector<int> SingularityIndices(const TriangleMesh& mesh, const Connection& connection,
  int degree, const std::vector<Complex>& field)
{
  LargeArray<double> phase(mesh.GetNumberOfVertices());
  ParallelFor(mesh.GetNumberOfVertices(), PieceSize,
    [&](Index begin, Index end)
    { Arguments(field.data() + begin, end - begin, phase.data() + begin); });
  // Computed in the direction of the edge for both its triangles, and where the edge is seen from two
  // sides, on one of them: rounding must not break a tie between pi and -pi in two ways.
  const auto along = [&](Index side)
  {
    const Index mirror = mesh.Mirror(side);
    const Index h = mirror != None && mesh.Edge(mirror) < mesh.Edge(side) ? mirror : side;
    const Index e = mesh.Edge(h);
    const bool forwards = mesh.HalfEdge(e) == h;
    const Index from = forwards ? mesh.Tail(h) : mesh.Head(h);
    const Index to = forwards ? mesh.Head(h) : mesh.Tail(h);
    const double angle = phase[to] - phase[from] - degree * connection.Rotation[e];
    const double omega = angle - 2.0 * Pi * std::nearbyint(angle / (2.0 * Pi));
    return forwards ? omega : -omega;
  };
  std::vector<int> index(mesh.GetNumberOfTriangles());
  ParallelFor(mesh.GetNumberOfTriangles(), PieceSize,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        const double sum =
          degree * connection.Curvature[t] + along(3 * t) + along(3 * t + 1) + along(3 * t + 2);
        index[t] = static_cast<int>(std::lround(sum / (2.0 * Pi)));
      }
    });
  return index;
}
}
