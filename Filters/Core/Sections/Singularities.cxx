// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Sections/Singularities.h"

#include "Support/LargeArray.h"
#include "Support/Threads.h"
#include "Support/VectorMath.h"

namespace DirectionFields
{
namespace
{
/// The nearest integer of a number of modulus below 2^51. The compiler can do this for several at once.
double Nearest(double x)
{
  constexpr double unitIsLastBit = 6755399441055744.0;
  return (x + unitIsLastBit) - unitIsLastBit;
}
}

std::vector<int> SingularityIndices(
  const IntrinsicGeometry& geometry, int degree, const std::vector<Complex>& field)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const Connection& connection = geometry.Transport;
  LargeArray<double> phase(mesh.GetNumberOfVertices());
  ParallelFor(mesh.GetNumberOfVertices(), LightPiece,
    [&](Index begin, Index end)
    { Arguments(field.data() + begin, end - begin, phase.data() + begin); });
  // omega is computed once, in the direction of the edge, for both its triangles, and on one side where
  // the edge is seen from two: rounding must not break a tie between pi and -pi in two ways.
  LargeArray<double> omega(mesh.GetNumberOfEdges());
  ParallelFor(mesh.GetNumberOfEdges(), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index e = begin; e < end; ++e)
      {
        const Index h = mesh.HalfEdge(e);
        const double angle =
          phase[mesh.Head(h)] - phase[mesh.Tail(h)] - degree * connection.Rotation[e];
        omega[e] = angle - 2.0 * Pi * Nearest(angle / (2.0 * Pi));
      }
    });
  const auto along = [&](Index side)
  {
    const Index mirror = mesh.Mirror(side);
    const Index h = mirror != None && mesh.Edge(mirror) < mesh.Edge(side) ? mirror : side;
    return mesh.GivesDirection(h) ? omega[mesh.Edge(h)] : -omega[mesh.Edge(h)];
  };
  std::vector<int> index(mesh.GetNumberOfTriangles());
  ParallelFor(mesh.GetNumberOfTriangles(), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        const double sum =
          degree * connection.Curvature[t] + along(3 * t) + along(3 * t + 1) + along(3 * t + 2);
        index[t] = static_cast<int>(Nearest(sum / (2.0 * Pi)));
      }
    });
  return index;
}
}
