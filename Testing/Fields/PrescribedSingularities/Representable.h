// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Representable_h
#define DirectionFields_Representable_h

#include "Geometry/IntrinsicGeometry.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <vector>

/// Which indices a mesh can represent.
namespace Placements
{
using namespace DirectionFields;

/// Whether rotations of at most a bound along each edge can add up to 2 pi k - Omega around each triangle of the first component: a
/// flow from triangle to triangle with the bound as capacity of each edge (max-flow min-cut; E. Dinitz 1970). On surfaces of
/// genus 0 that is when some field has the indices k.
class Flow
{
public:
  Flow(const IntrinsicGeometry& geometry, int degree, const std::vector<int>& indices, double bound)
  {
    const TriangleMesh& mesh = geometry.Mesh;
    const TriangleMesh::Component& component = mesh.GetComponents()[0];
    const Index outside = component.Triangles();
    this->Source = outside + 1;
    this->Sink = outside + 2;
    this->Arcs.resize(static_cast<std::size_t>(outside) + 3);
    for (Index e = component.FirstEdge; e < component.EndEdge; ++e)
    {
      const Index h = mesh.HalfEdge(e);
      this->Connect(h / 3, mesh.Twin(h) == None ? outside : mesh.Twin(h) / 3, bound, bound);
    }
    double sum = 0.0;
    for (Index t = 0; t < outside; ++t)
    {
      const double supply = 2.0 * Pi * indices[t] - degree * geometry.Transport.Curvature[t];
      this->Supply(t, supply);
      sum += supply;
    }
    if (!component.Closed)
    {
      this->Supply(outside, -sum);
    }
  }

  bool IsFeasible()
  {
    double flow = 0.0;
    while (this->FindLevels())
    {
      this->At.assign(this->Arcs.size(), 0);
      while (const double pushed = this->Push(this->Source, std::numeric_limits<double>::max()))
      {
        flow += pushed;
      }
    }
    return flow > this->Total - 1e-6;
  }

private:
  struct Arc
  {
    Index To;
    double Left;
    std::size_t Back;
  };

  void Connect(Index a, Index b, double forward, double backward)
  {
    this->Arcs[a].push_back({ b, forward, this->Arcs[b].size() });
    this->Arcs[b].push_back({ a, backward, this->Arcs[a].size() - 1 });
  }

  void Supply(Index node, double supply)
  {
    if (supply > 0.0)
    {
      this->Connect(this->Source, node, supply, 0.0);
      this->Total += supply;
    }
    else
    {
      this->Connect(node, this->Sink, -supply, 0.0);
    }
  }

  bool FindLevels()
  {
    this->Level.assign(this->Arcs.size(), -1);
    this->Level[this->Source] = 0;
    std::queue<Index> queue;
    queue.push(this->Source);
    while (!queue.empty())
    {
      const Index node = queue.front();
      queue.pop();
      for (const Arc& arc : this->Arcs[node])
      {
        if (arc.Left > Least && this->Level[arc.To] < 0)
        {
          this->Level[arc.To] = this->Level[node] + 1;
          queue.push(arc.To);
        }
      }
    }
    return this->Level[this->Sink] >= 0;
  }

  double Push(Index node, double most)
  {
    if (node == this->Sink)
    {
      return most;
    }
    for (std::size_t& k = this->At[node]; k < this->Arcs[node].size(); ++k)
    {
      Arc& arc = this->Arcs[node][k];
      if (arc.Left > Least && this->Level[arc.To] == this->Level[node] + 1)
      {
        const double pushed = this->Push(arc.To, std::min(most, arc.Left));
        if (pushed > 0.0)
        {
          arc.Left -= pushed;
          this->Arcs[arc.To][arc.Back].Left += pushed;
          return pushed;
        }
      }
    }
    return 0.0;
  }

  static constexpr double Least = 1e-9;
  std::vector<std::vector<Arc>> Arcs;
  std::vector<int> Level;
  std::vector<std::size_t> At;
  Index Source;
  Index Sink;
  double Total = 0.0;
};
}

#endif
