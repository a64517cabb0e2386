// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SoftFeatures/FeaturesInNoise.h"

#include "Features/EdgeChains.h"
#include "Features/FeatureChains.h"
#include "Geometry/DihedralAngles.h"
#include "SoftFeatures/WideBends.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// How many times as much as beside it a feature is bent across.
constexpr double LeastContrast = 3.0;
/// The same for lines that are connected with such ones, and for single edges in gaps of lines.
constexpr double WeakContrast = 2.0;
constexpr double GapContrast = 1.0;
/// The part of the length of connected lines that has the full contrast.
constexpr double LeastPart = 0.5;
/// Chains that end freely, or are closed, have as many edges.
constexpr std::size_t FewestEdges = 6;
/// As long as gaps are open.
constexpr std::size_t FewestWithGaps = 4;
/// The direction in which a line ends is that of this number of edges.
constexpr std::size_t DirectionEdges = 3;
/// Chains that are dropped let others grow together, which are looked at again.
constexpr int MostRounds = 16;

/// Finds the features of a surface, from bends of its edges and what is around them.
class Finder
{
public:
  Finder(const SurfaceGeometry& geometry, double least)
    : Geometry(geometry)
    , Mesh(geometry.Mesh)
    , Least(least)
    , Wide(geometry)
    , IsFeature(geometry.Mesh.GetNumberOfEdges(), 0)
  {
  }

  std::vector<char> Run(double minimumLength)
  {
    std::vector<double> dihedral = DihedralAngles(this->Geometry);
    for (Index e = 0; e < this->Mesh.GetNumberOfEdges(); ++e)
    {
      if (std::abs(dihedral[e]) > this->Least && !(this->Wide.At(e).Across > this->Least))
      {
        dihedral[e] = 0.0;
      }
    }
    const FeatureChains chains(this->Geometry, dihedral, { this->Least, minimumLength });
    for (Index e = 0; e < this->Mesh.GetNumberOfEdges(); ++e)
    {
      this->IsFeature[e] = chains.IsFeature(e) ? 1 : 0;
    }
    this->DropNoise(FewestWithGaps);
    this->CountAtVertices();
    this->Bridge(true);
    this->Bridge(false);
    this->DropNoise(FewestEdges);
    this->DropWeakParts();
    return std::move(this->IsFeature);
  }

private:
  double LengthOf(Index e) const
  {
    const Index h = this->Mesh.HalfEdge(e);
    return (
      this->Geometry.Positions[this->Mesh.Head(h)] - this->Geometry.Positions[this->Mesh.Tail(h)])
      .norm();
  }

  /// The mean along a chain.
  WideBend WideOf(const EdgeChain& chain)
  {
    WideBend sum;
    double all = 0.0;
    for (const Index e : chain.Edges)
    {
      const double length = this->LengthOf(e);
      sum.Across += length * this->Wide.At(e).Across;
      sum.Beside += length * this->Wide.At(e).Beside;
      all += length;
    }
    return all > 0.0 ? WideBend{ sum.Across / all, sum.Beside / all } : WideBend();
  }

  bool IsClear(const WideBend& wide, double contrast) const
  {
    return wide.Across > this->Least && wide.Across >= contrast * wide.Beside;
  }

  /// Drops chains that are not clear, and those that lead nowhere and have fewer edges.
  void DropNoise(std::size_t fewest)
  {
    bool hasDropped = true;
    for (int k = 0; k < MostRounds && hasDropped; ++k)
    {
      hasDropped = false;
      for (const EdgeChain& chain : ChainsOf(this->Mesh, this->IsFeature))
      {
        const bool isShort = (chain.EndsFreely || chain.IsClosed) && chain.Edges.size() < fewest;
        if (isShort || !this->IsClear(this->WideOf(chain), WeakContrast))
        {
          hasDropped = true;
          this->Mark(chain, 0);
        }
      }
    }
  }

  void Mark(const EdgeChain& chain, char isFeature)
  {
    for (const Index e : chain.Edges)
    {
      this->IsFeature[e] = isFeature;
    }
  }

  /// Drops connected lines that are not clear for the most part.
  void DropWeakParts()
  {
    const std::vector<EdgeChain> chains = ChainsOf(this->Mesh, this->IsFeature);
    std::vector<Index> parent(this->Mesh.GetNumberOfVertices());
    std::iota(parent.begin(), parent.end(), 0);
    const auto rootOf = [&](Index v)
    {
      while (parent[v] != v)
      {
        parent[v] = parent[parent[v]];
        v = parent[v];
      }
      return v;
    };
    for (const EdgeChain& chain : chains)
    {
      parent[rootOf(chain.Vertices.back())] = rootOf(chain.Vertices.front());
    }
    std::vector<double> all(parent.size(), 0.0);
    std::vector<double> clear(parent.size(), 0.0);
    for (const EdgeChain& chain : chains)
    {
      const Index root = rootOf(chain.Vertices.front());
      const double length = chain.Length(this->Geometry);
      const bool isClear =
        chain.Edges.size() >= FewestEdges && this->IsClear(this->WideOf(chain), LeastContrast);
      all[root] += length;
      clear[root] += isClear ? length : 0.0;
    }
    for (const EdgeChain& chain : chains)
    {
      const Index root = rootOf(chain.Vertices.front());
      if (clear[root] < LeastPart * all[root])
      {
        this->Mark(chain, 0);
      }
    }
  }

  void CountAtVertices()
  {
    this->Lines.assign(this->Mesh.GetNumberOfVertices(), 0);
    for (Index e = 0; e < this->Mesh.GetNumberOfEdges(); ++e)
    {
      this->Lines[this->Mesh.Tail(this->Mesh.HalfEdge(e))] += this->IsFeature[e];
      this->Lines[this->Mesh.Head(this->Mesh.HalfEdge(e))] += this->IsFeature[e];
    }
  }

  bool IsFreeEnd(Index v) const { return this->Lines[v] == 1 && !this->Mesh.IsBoundary(v); }

  /// Noise makes gaps in lines, where single edges are flat. Lines go on from their free ends by a
  /// few edges, if another one is there.
  /// @param toEnds only to free ends of others
  void Bridge(bool toEnds)
  {
    for (const EdgeChain& chain : ChainsOf(this->Mesh, this->IsFeature))
    {
      if (!chain.EndsFreely)
      {
        continue;
      }
      const std::size_t last = chain.Vertices.size() - 1;
      const std::size_t back = std::min(last, DirectionEdges);
      this->BridgeFrom(chain.Vertices[last], chain.Vertices[last - back], toEnds);
      this->BridgeFrom(chain.Vertices[0], chain.Vertices[back], toEnds);
    }
  }

  /// A vertex on the shortest way ahead.
  struct Step
  {
    double Length;
    Index Vertex;
    Index Edge;
    /// The number of the step before, and of all.
    std::size_t From;
    std::size_t Edges;
    bool operator<(const Step& other) const
    {
      return std::make_tuple(this->Length, this->Vertex) <
        std::make_tuple(other.Length, other.Vertex);
    }
  };

  void BridgeFrom(Index end, Index before, bool toEnds)
  {
    const Vector3 ahead = this->Geometry.Positions[end] - this->Geometry.Positions[before];
    // Few vertices are ahead within some edges.
    std::vector<Step> open;
    std::vector<Step> done;
    if (this->IsFreeEnd(end))
    {
      open.push_back({ 0.0, end, None, 0, 0 });
    }
    while (!open.empty())
    {
      const auto next = std::min_element(open.begin(), open.end());
      const Step step = *next;
      open.erase(next);
      const bool isSeen = std::any_of(
        done.begin(), done.end(), [&](const Step& other) { return other.Vertex == step.Vertex; });
      if (isSeen)
      {
        continue;
      }
      done.push_back(step);
      const bool isAtLine = step.Vertex != end && this->Lines[step.Vertex] > 0;
      if (isAtLine && (!toEnds || this->IsFreeEnd(step.Vertex)))
      {
        this->Take(done);
        return;
      }
      if (!isAtLine && step.Edges < FewestEdges)
      {
        this->GoOn(step, done.size() - 1, ahead, open);
      }
    }
  }

  /// Makes features of the way to the last step.
  void Take(const std::vector<Step>& steps)
  {
    for (std::size_t k = steps.size() - 1; steps[k].Edge != None; k = steps[k].From)
    {
      this->IsFeature[steps[k].Edge] = 1;
      ++this->Lines[steps[k].Vertex];
      ++this->Lines[steps[steps[k].From].Vertex];
    }
  }

  void GoOn(const Step& step, std::size_t number, const Vector3& ahead, std::vector<Step>& open)
  {
    Index h = this->Mesh.Outgoing(step.Vertex);
    do
    {
      const Index e = this->Mesh.Edge(h);
      const Vector3 way =
        this->Geometry.Positions[this->Mesh.Head(h)] - this->Geometry.Positions[this->Mesh.Tail(h)];
      if (this->IsFeature[e] == 0 && way.dot(ahead) > 0.0 &&
        this->IsClear(this->Wide.At(e), GapContrast))
      {
        open.push_back({ step.Length + way.norm(), this->Mesh.Head(h), e, number, step.Edges + 1 });
      }
      h = this->Mesh.NextOutgoing(h);
    } while (h != None && h != this->Mesh.Outgoing(step.Vertex));
  }

  const SurfaceGeometry& Geometry;
  const TriangleMesh& Mesh;
  double Least;
  WideBends Wide;
  std::vector<char> IsFeature;
  /// The number of features at each vertex.
  std::vector<int> Lines;
};
}

std::vector<char> FeaturesInNoise(const SurfaceGeometry& geometry, const FeatureSettings& settings)
{
  return Finder(geometry, settings.Angle * Pi / 180.0).Run(settings.MinimumLength);
}
}
