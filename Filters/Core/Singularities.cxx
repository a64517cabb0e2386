// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Singularities.h"

#include <cmath>

namespace DirectionFields
{
std::vector<int> SingularityIndices(const TriangleMesh& mesh, const Connection& connection,
  int degree, const std::vector<Complex>& field)
{
  std::vector<double> phase(mesh.GetNumberOfVertices());
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    phase[v] = std::arg(field[v]);
  }
  std::vector<double> omega(mesh.GetNumberOfEdges());
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = mesh.HalfEdge(e);
    omega[e] = std::remainder(
      phase[mesh.Head(h)] - phase[mesh.Tail(h)] - degree * connection.Rotation[e], 2.0 * Pi);
  }
  std::vector<int> index(mesh.GetNumberOfTriangles());
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    double sum = degree * connection.Curvature[t];
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      const double along = omega[mesh.Edge(h)];
      sum += mesh.GivesDirection(h) ? along : -along;
    }
    index[t] = static_cast<int>(std::lround(sum / (2.0 * Pi)));
  }
  return index;
}
}
