// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/FeatureChains.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Rounds of dropping, of which strong noise takes nine.
constexpr int MostRounds = 16;
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
  this->IsSeen.assign(this->Features.size(), 0);
  for (Index e = 0; e < this->Mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = this->Mesh.HalfEdge(e);
    this->Valence[this->Mesh.Tail(h)] += this->Features[e];
    this->Valence[this->Mesh.Head(h)] += this->Features[e];
  }
  for (Index c = 0; c < static_cast<Index>(this->Mesh.GetComponents().size()); ++c)
  {
    this->DropNoise(c);
  }
}

FeatureChains::Chain FeatureChains::Follow(Index h) const
{
  Chain chain;
  chain.From = this->Mesh.Tail(h);
  for (;;)
  {
    const Index edge = this->Mesh.Edge(h);
    chain.Edges.push_back(edge);
    chain.To = this->Mesh.Head(h);
    // A loop ends where it began.
    if (chain.To == chain.From || this->IsNode(chain.To))
    {
      return chain;
    }
    h = this->Mesh.Outgoing(chain.To);
    while (!this->Features[this->Mesh.Edge(h)] || this->Mesh.Edge(h) == edge)
    {
      h = this->Mesh.NextOutgoing(h);
    }
  }
}

double FeatureChains::LengthOf(const Chain& chain) const
{
  double length = 0.0;
  for (const Index e : chain.Edges)
  {
    length += std::sqrt(this->Lengths.SquaredLength[e]);
  }
  return length;
}

bool FeatureChains::StandsOut(const Chain& chain) const
{
  double bend = 0.0;
  double around = 0.0;
  Index others = 0;
  for (const Index e : chain.Edges)
  {
    bend += std::sqrt(this->Lengths.SquaredLength[e]) * std::abs(this->Dihedral[e]);
    for (const Index v :
      { this->Mesh.Tail(this->Mesh.HalfEdge(e)), this->Mesh.Head(this->Mesh.HalfEdge(e)) })
    {
      Index h = this->Mesh.Outgoing(v);
      do
      {
        if (!this->Features[this->Mesh.Edge(h)] && this->Mesh.Twin(h) != None)
        {
          around += std::abs(this->Dihedral[this->Mesh.Edge(h)]);
          ++others;
        }
        h = this->Mesh.NextOutgoing(h);
      } while (h != None && h != this->Mesh.Outgoing(v));
    }
  }
  const double mean = bend / this->LengthOf(chain);
  const double contrast =
    this->EndsFreely(chain) && mean < VerySharp ? FreeContrast : ClearContrast;
  return mean * std::max<Index>(1, others) >= contrast * around;
}

bool FeatureChains::IsNoise(const Chain& chain, const Doubt& doubt) const
{
  if (doubt.FreeEndsOnly && !this->EndsFreely(chain))
  {
    return false;
  }
  const bool crosses = this->Mesh.IsBoundary(chain.From) && this->Mesh.IsBoundary(chain.To);
  return !crosses && this->LengthOf(chain) < doubt.Length && !this->StandsOut(chain);
}

void FeatureChains::CollectNoise(Index vertex, const Doubt& doubt, std::vector<Index>& noise)
{
  Index h = this->Mesh.Outgoing(vertex);
  do
  {
    if (this->Features[this->Mesh.Edge(h)] && !this->IsSeen[this->Mesh.Edge(h)])
    {
      const Chain chain = this->Follow(h);
      for (const Index e : chain.Edges)
      {
        this->IsSeen[e] = 1;
      }
      if (this->IsNoise(chain, doubt))
      {
        noise.insert(noise.end(), chain.Edges.begin(), chain.Edges.end());
      }
    }
    h = this->Mesh.NextOutgoing(h);
  } while (h != None && h != this->Mesh.Outgoing(vertex));
}

void FeatureChains::Drop(const std::vector<Index>& edges)
{
  for (const Index e : edges)
  {
    this->Features[e] = 0;
    --this->Valence[this->Mesh.Tail(this->Mesh.HalfEdge(e))];
    --this->Valence[this->Mesh.Head(this->Mesh.HalfEdge(e))];
  }
}

void FeatureChains::DropNoise(Index component)
{
  const double length =
    this->Wanted.MinimumLength * std::sqrt(this->Lengths.ComponentArea[component]);
  for (const bool freeEndsOnly : { true, false })
  {
    int rounds = 0;
    while (rounds < MostRounds && this->DropRound(component, { length, freeEndsOnly }))
    {
      ++rounds;
    }
  }
}

/// All chains are looked at before any is dropped, so that the order does not matter.
bool FeatureChains::DropRound(Index component, const Doubt& doubt)
{
  const TriangleMesh::Component& range = this->Mesh.GetComponents()[component];
  std::fill(this->IsSeen.begin() + range.FirstEdge, this->IsSeen.begin() + range.EndEdge, 0);
  std::vector<Index> noise;
  // Chains without a node are loops.
  for (const bool nodes : { true, false })
  {
    for (Index v = range.FirstVertex; v < range.EndVertex; ++v)
    {
      if (this->Valence[v] > 0 && this->IsNode(v) == nodes)
      {
        this->CollectNoise(v, doubt, noise);
      }
    }
  }
  this->Drop(noise);
  return !noise.empty();
}
}
