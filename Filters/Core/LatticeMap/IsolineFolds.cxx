// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LatticeMap/IsolineFolds.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Steps shorter than this part of what they should be count as folds.
constexpr double ShortestStep = 0.1;

class Isolines
{
public:
  Isolines(const ChartedMesh& mesh, const std::vector<Transition>& own,
    const std::vector<char>& fixed, std::vector<LatticePoint>& places)
    : Mesh(mesh)
    , Plane(mesh.Degree)
    , Own(own)
    , Fixed(fixed)
    , Places(places)
    , EdgesAt(mesh.Positions.size())
    , IsSeen(mesh.Isolines.size(), 0)
  {
    for (std::size_t e = 0; e < mesh.Isolines.size(); ++e)
    {
      this->EdgesAt[this->End(e, false)].push_back(e);
      this->EdgesAt[this->End(e, true)].push_back(e);
    }
  }

  Index UnfoldAll()
  {
    Index count = 0;
    // Stretches between fixed vertices, then closed ones.
    for (const bool fromFixed : { true, false })
    {
      for (std::size_t v = 0; v < this->EdgesAt.size(); ++v)
      {
        if (this->IsEnd(static_cast<Index>(v)) != fromFixed)
        {
          continue;
        }
        for (const std::size_t e : this->EdgesAt[v])
        {
          if (this->IsSeen[e] == 0)
          {
            count += this->Unfold(this->Follow(static_cast<Index>(v), e)) ? 1 : 0;
          }
        }
      }
    }
    return count;
  }

private:
  struct Step
  {
    std::size_t Edge;
    bool IsReversed;
  };

  Index End(std::size_t e, bool atHead) const
  {
    const ChartedMesh::IsolineEdge& edge = this->Mesh.Isolines[e];
    return this->Mesh.Triangles[edge.Triangle].Vertex[(edge.Corner + (atHead ? 1 : 0)) % 3];
  }
  bool IsEnd(Index v) const { return this->Fixed[v] != 0 || this->EdgesAt[v].size() != 2; }

  std::vector<Step> Follow(Index start, std::size_t first)
  {
    std::vector<Step> steps;
    Index v = start;
    std::size_t e = first;
    while (true)
    {
      this->IsSeen[e] = 1;
      const bool isReversed = this->End(e, false) != v;
      steps.push_back({ e, isReversed });
      v = this->End(e, !isReversed);
      if (v == start || this->IsEnd(v))
      {
        return steps;
      }
      const std::vector<std::size_t>& edges = this->EdgesAt[v];
      const auto next = std::find_if(
        edges.begin(), edges.end(), [&](std::size_t k) { return this->IsSeen[k] == 0; });
      if (next == edges.end())
      {
        return steps;
      }
      e = *next;
    }
  }

  /// How far a map goes along an edge.
  std::int64_t LengthOf(std::size_t e) const
  {
    const ChartedMesh::IsolineEdge& edge = this->Mesh.Isolines[e];
    const Index tail = 3 * edge.Triangle + edge.Corner;
    const Index head = 3 * edge.Triangle + (edge.Corner + 1) % 3;
    const LatticePoint along =
      this->Plane.Apply(this->Own[head], this->Places[this->End(e, true)]) -
      this->Plane.Apply(this->Own[tail], this->Places[this->End(e, false)]);
    return this->Plane.Turned(along, -edge.Axis).A;
  }

  bool Unfold(const std::vector<Step>& steps)
  {
    std::vector<std::int64_t> length;
    std::vector<double> wanted;
    std::int64_t total = 0;
    double sum = 0.0;
    for (const Step& step : steps)
    {
      const ChartedMesh::IsolineEdge& edge = this->Mesh.Isolines[step.Edge];
      length.push_back(this->LengthOf(step.Edge));
      wanted.push_back(std::abs(this->Mesh.Triangles[edge.Triangle].Target[edge.Corner]));
      total += length.back();
      sum += wanted.back();
    }
    bool hasFold = false;
    for (std::size_t i = 0; i < steps.size(); ++i)
    {
      hasFold = hasFold ||
        static_cast<double>(length[i]) * sum <
          ShortestStep * wanted[i] * static_cast<double>(total);
    }
    if (!hasFold || total <= 0 || !(sum > 0.0))
    {
      return false;
    }
    std::int64_t before = 0;
    double reached = 0.0;
    for (std::size_t i = 0; i + 1 < steps.size(); ++i)
    {
      before += length[i];
      reached += wanted[i];
      const std::int64_t shift = std::llround(reached / sum * static_cast<double>(total)) - before;
      // The direction of the edge in the chart of the vertex that it leads to.
      const ChartedMesh::IsolineEdge& edge = this->Mesh.Isolines[steps[i].Edge];
      const bool atHead = !steps[i].IsReversed;
      const Index corner = 3 * edge.Triangle + (edge.Corner + (atHead ? 1 : 0)) % 3;
      const int turn =
        edge.Axis - this->Own[corner].Turn + (steps[i].IsReversed ? this->Mesh.Degree / 2 : 0);
      LatticePoint& place = this->Places[this->End(steps[i].Edge, atHead)];
      place = place + this->Plane.Turned({ shift, 0 }, turn);
    }
    return true;
  }

  const ChartedMesh& Mesh;
  Lattice Plane;
  const std::vector<Transition>& Own;
  const std::vector<char>& Fixed;
  std::vector<LatticePoint>& Places;
  /// The edges of isolines at each vertex.
  std::vector<std::vector<std::size_t>> EdgesAt;
  std::vector<char> IsSeen;
};
}

Index UnfoldIsolines(const ChartedMesh& mesh, const std::vector<Transition>& own,
  const std::vector<char>& fixed, std::vector<LatticePoint>& places)
{
  return Isolines(mesh, own, fixed, places).UnfoldAll();
}
}
