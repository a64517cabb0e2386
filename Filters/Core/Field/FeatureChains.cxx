// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Field/FeatureChains.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Edges are very sharp from twice the angle on, or from this one on.
constexpr double VerySharp = Pi / 3.0;
}

FeatureChains::FeatureChains(
  const SurfaceGeometry& geometry, const std::vector<double>& dihedral, const Settings& settings)
  : Mesh(geometry.Mesh)
  , Lengths(geometry.Lengths)
  , Dihedral(dihedral)
  , Wanted(settings)
  , Features(geometry.Mesh.GetNumberOfEdges())
{
  for (Index e = 0; e < this->Mesh.GetNumberOfEdges(); ++e)
  {
    this->Features[e] = std::abs(dihedral[e]) > settings.Angle;
  }
  if (!(settings.MinimumLength > 0.0))
  {
    return;
  }
  this->Valence.assign(this->Mesh.GetNumberOfVertices(), 0);
  for (Index e = 0; e < this->Mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = this->Mesh.HalfEdge(e);
    this->Valence[this->Mesh.Tail(h)] += this->Features[e];
    this->Valence[this->Mesh.Head(h)] += this->Features[e];
  }
  std::vector<char> isSeen(this->Mesh.GetNumberOfVertices(), 0);
  for (Index c = 0; c < static_cast<Index>(this->Mesh.GetComponents().size()); ++c)
  {
    this->DropSpurs(c);
    this->DropSmallGraphs(c, isSeen);
  }
}

void FeatureChains::Add(Index edge, Extent& extent) const
{
  const double length = std::sqrt(this->Lengths.SquaredLength[edge]);
  extent.Length += length;
  extent.Bend += length * std::abs(this->Dihedral[edge]);
}

bool FeatureChains::CountsAsFeature(const Extent& extent, Index component) const
{
  const double least =
    this->Wanted.MinimumLength * std::sqrt(this->Lengths.ComponentArea[component]);
  const double sharp = std::min(2.0 * this->Wanted.Angle, VerySharp);
  return extent.Length >= least || extent.Bend >= sharp * extent.Length;
}

Index FeatureChains::NextFeature(Index vertex, Index edge) const
{
  Index h = this->Mesh.Outgoing(vertex);
  do
  {
    if (this->Features[this->Mesh.Edge(h)] && this->Mesh.Edge(h) != edge)
    {
      return h;
    }
    h = this->Mesh.NextOutgoing(h);
  } while (h != None && h != this->Mesh.Outgoing(vertex));
  return None;
}

std::vector<Index> FeatureChains::ChainFrom(Index vertex) const
{
  std::vector<Index> edges;
  Index edge = None;
  do
  {
    const Index h = this->NextFeature(vertex, edge);
    edge = this->Mesh.Edge(h);
    edges.push_back(edge);
    vertex = this->Mesh.Head(h);
  } while (this->Valence[vertex] == 2 && !this->Mesh.IsBoundary(vertex));
  return edges;
}

void FeatureChains::Drop(const std::vector<Index>& edges)
{
  for (const Index e : edges)
  {
    // A chain is found from both of its free ends.
    if (this->Features[e])
    {
      this->Features[e] = 0;
      --this->Valence[this->Mesh.Tail(this->Mesh.HalfEdge(e))];
      --this->Valence[this->Mesh.Head(this->Mesh.HalfEdge(e))];
    }
  }
}

/// All chains of a round are measured before any is dropped, so that the order does not matter.
void FeatureChains::DropSpurs(Index component)
{
  const TriangleMesh::Component& range = this->Mesh.GetComponents()[component];
  std::vector<Index> ends;
  for (Index v = range.FirstVertex; v < range.EndVertex; ++v)
  {
    if (this->IsFreeEnd(v))
    {
      ends.push_back(v);
    }
  }
  while (!ends.empty())
  {
    std::vector<Index> dropped;
    for (const Index v : ends)
    {
      const std::vector<Index> chain = this->ChainFrom(v);
      Extent extent;
      for (const Index e : chain)
      {
        this->Add(e, extent);
      }
      if (!this->CountsAsFeature(extent, component))
      {
        dropped.insert(dropped.end(), chain.begin(), chain.end());
      }
    }
    this->Drop(dropped);
    ends.clear();
    for (const Index e : dropped)
    {
      for (const Index v :
        { this->Mesh.Tail(this->Mesh.HalfEdge(e)), this->Mesh.Head(this->Mesh.HalfEdge(e)) })
      {
        if (this->IsFreeEnd(v))
        {
          ends.push_back(v);
        }
      }
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  }
}

std::vector<Index> FeatureChains::GraphAt(
  Index vertex, std::vector<char>& isSeen, int& onBoundary) const
{
  std::vector<Index> edges;
  std::vector<Index> open = { vertex };
  isSeen[vertex] = 1;
  while (!open.empty())
  {
    const Index v = open.back();
    open.pop_back();
    onBoundary += this->Mesh.IsBoundary(v);
    Index h = this->Mesh.Outgoing(v);
    do
    {
      const Index e = this->Mesh.Edge(h);
      if (this->Features[e])
      {
        if (this->Mesh.GivesDirection(h))
        {
          edges.push_back(e);
        }
        if (!isSeen[this->Mesh.Head(h)])
        {
          isSeen[this->Mesh.Head(h)] = 1;
          open.push_back(this->Mesh.Head(h));
        }
      }
      h = this->Mesh.NextOutgoing(h);
    } while (h != None && h != this->Mesh.Outgoing(v));
  }
  return edges;
}

void FeatureChains::DropSmallGraphs(Index component, std::vector<char>& isSeen)
{
  const TriangleMesh::Component& range = this->Mesh.GetComponents()[component];
  for (Index v = range.FirstVertex; v < range.EndVertex; ++v)
  {
    if (this->Valence[v] == 0 || isSeen[v])
    {
      continue;
    }
    int onBoundary = 0;
    const std::vector<Index> graph = this->GraphAt(v, isSeen, onBoundary);
    Extent extent;
    bool isRim = static_cast<Index>(graph.size()) >= FewestRimEdges;
    for (const Index e : graph)
    {
      this->Add(e, extent);
      const Index h = this->Mesh.HalfEdge(e);
      isRim =
        isRim && this->Valence[this->Mesh.Tail(h)] == 2 && this->Valence[this->Mesh.Head(h)] == 2;
    }
    if (!isRim && onBoundary < 2 && !this->CountsAsFeature(extent, component))
    {
      this->Drop(graph);
    }
  }
}
}
