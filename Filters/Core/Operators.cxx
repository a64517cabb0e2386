// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Operators.h"

#include "SectionIntegrals.h"

#include <algorithm>
#include <utility>

namespace DirectionFields
{
namespace
{
/// Entries of both matrices on the diagonal, and in row tail and column head of each edge.
struct Entries
{
  std::vector<double> EnergyDiagonal;
  std::vector<double> MassDiagonal;
  std::vector<Complex> Energy;
  std::vector<Complex> Mass;
};

Entries Integrate(const TriangleMesh& mesh, const Metric& metric, const Connection& connection,
  const TriangleMesh::Component& component, int degree, double energyBias)
{
  std::vector<Complex> transport(component.Edges());
  for (Index e = component.FirstEdge; e < component.EndEdge; ++e)
  {
    transport[e - component.FirstEdge] = std::polar(1.0, degree * connection.Rotation[e]);
  }
  Entries entries;
  entries.EnergyDiagonal.assign(component.Vertices(), 0.0);
  entries.MassDiagonal.assign(component.Vertices(), 0.0);
  entries.Energy.assign(component.Edges(), 0.0);
  entries.Mass.assign(component.Edges(), 0.0);
  for (Index t = component.FirstTriangle; t < component.EndTriangle; ++t)
  {
    std::array<double, 3> squaredLength;
    std::array<Complex, 3> r;
    for (int c = 0; c < 3; ++c)
    {
      const Index h = 3 * t + c;
      const Complex& along = transport[mesh.Edge(h) - component.FirstEdge];
      squaredLength[c] = metric.SquaredLength[mesh.Edge(h)];
      r[c] = mesh.GivesDirection(h) ? along : std::conj(along);
    }
    const LocalMatrices local(
      squaredLength, metric.Area[t], degree * connection.Curvature[t], r, energyBias);
    for (int c = 0; c < 3; ++c)
    {
      const Index h = 3 * t + c;
      const Index e = mesh.Edge(h) - component.FirstEdge;
      const Index v = mesh.Tail(h) - component.FirstVertex;
      const bool along = mesh.GivesDirection(h);
      entries.EnergyDiagonal[v] += local.EnergyDiagonal[c];
      entries.MassDiagonal[v] += local.MassDiagonal;
      entries.Energy[e] += along ? local.Energy[c] : std::conj(local.Energy[c]);
      entries.Mass[e] += along ? local.Mass[c] : std::conj(local.Mass[c]);
    }
  }
  return entries;
}

/// A neighbour in a column: its row, and the edge to it, complemented where it is directed away
/// from the row.
struct Neighbour
{
  Index Row;
  Index Edge;
  bool operator<(const Neighbour& other) const
  {
    return this->Row != other.Row ? this->Row < other.Row : this->Edge < other.Edge;
  }
};

SparseMatrix Fill(const std::vector<Index>& begin, const std::vector<Neighbour>& neighbours,
  const std::vector<double>& diagonal, const std::vector<Complex>& edges)
{
  const auto n = static_cast<Index>(diagonal.size());
  SparseMatrix matrix(n, n);
  matrix.resizeNonZeros(static_cast<Eigen::Index>(neighbours.size()) + n);
  Index* outer = matrix.outerIndexPtr();
  Index* inner = matrix.innerIndexPtr();
  Complex* values = matrix.valuePtr();
  Index at = 0;
  for (Index column = 0; column < n; ++column)
  {
    outer[column] = at;
    Index k = begin[column];
    const auto take = [&](Index end)
    {
      for (; k < begin[column + 1] && neighbours[k].Row < end; ++k)
      {
        const Index edge = neighbours[k].Edge;
        const Complex value = edge >= 0 ? edges[edge] : std::conj(edges[~edge]);
        if (at > outer[column] && inner[at - 1] == neighbours[k].Row)
        {
          // Along a slit, where the surface was split, two edges join the same vertices.
          values[at - 1] += value;
        }
        else
        {
          inner[at] = neighbours[k].Row;
          values[at++] = value;
        }
      }
    };
    take(column);
    inner[at] = column;
    values[at++] = diagonal[column];
    take(n);
  }
  outer[n] = at;
  matrix.resizeNonZeros(at);
  return matrix;
}
}

Operators AssembleOperators(const TriangleMesh& mesh, const Metric& metric,
  const Connection& connection, const TriangleMesh::Component& component, int degree,
  double energyBias)
{
  const Entries entries = Integrate(mesh, metric, connection, component, degree, energyBias);

  std::vector<Index> begin(component.Vertices() + 1, 0);
  const auto ends = [&](Index e)
  {
    const Index h = mesh.HalfEdge(e);
    return std::pair(mesh.Tail(h) - component.FirstVertex, mesh.Head(h) - component.FirstVertex);
  };
  for (Index e = component.FirstEdge; e < component.EndEdge; ++e)
  {
    const auto [tail, head] = ends(e);
    ++begin[tail + 1];
    ++begin[head + 1];
  }
  for (Index v = 0; v < component.Vertices(); ++v)
  {
    begin[v + 1] += begin[v];
  }
  std::vector<Neighbour> neighbours(begin.back());
  std::vector<Index> fill(begin.begin(), begin.end() - 1);
  for (Index e = component.FirstEdge; e < component.EndEdge; ++e)
  {
    const auto [tail, head] = ends(e);
    const Index edge = e - component.FirstEdge;
    neighbours[fill[head]++] = { tail, edge };
    neighbours[fill[tail]++] = { head, ~edge };
  }
  for (Index v = 0; v < component.Vertices(); ++v)
  {
    std::sort(neighbours.begin() + begin[v], neighbours.begin() + begin[v + 1]);
  }
  return { Fill(begin, neighbours, entries.EnergyDiagonal, entries.Energy),
    Fill(begin, neighbours, entries.MassDiagonal, entries.Mass) };
}
}
