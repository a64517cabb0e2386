// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrivialConnection/TreeCotree.h"

#include "Soup/JoinedSets.h"

#include <algorithm>
#include <map>

namespace DirectionFields::Internal
{
TreeCotree::TreeCotree(const DiscreteForms& forms, const ConstrainedSets& constrained)
  : Forms(forms)
{
  this->GrowTrees(constrained);
  this->FindGenerators(constrained);
}

void TreeCotree::GrowTrees(const ConstrainedSets& constrained)
{
  const TriangleMesh& mesh = this->Forms.GetMesh();
  const TriangleMesh::Component& component = this->Forms.GetComponent();
  const Index triangles = component.Triangles();
  this->ToRoot.assign(triangles, None);
  this->Region.assign(triangles, None);
  this->Order.reserve(triangles);
  const auto isFree = [&](Index h) { return !constrained.IsFixed(this->Forms.LocalEdge(h)); };
  // Trees that begin outside come first, so that paths to the boundary are short. Several of them
  // may meet, so that all of these are one open region.
  for (Index t = 0; t < triangles; ++t)
  {
    const Index first = 3 * (component.FirstTriangle + t);
    for (Index h = first; h < first + 3 && this->ToRoot[t] == None; ++h)
    {
      if (mesh.Twin(h) == None && isFree(h))
      {
        this->ToRoot[t] = h;
        this->Region[t] = 0;
        this->Order.push_back(t);
      }
    }
  }
  if (!this->Order.empty())
  {
    this->Open.push_back(1);
  }
  std::size_t done = 0;
  Index nextSeed = 0;
  for (;;)
  {
    for (; done < this->Order.size(); ++done)
    {
      const Index t = this->Order[done];
      const Index first = 3 * (component.FirstTriangle + t);
      for (Index h = first; h < first + 3; ++h)
      {
        const Index twin = mesh.Twin(h);
        if (twin != None && isFree(h) && this->Region[twin / 3 - component.FirstTriangle] == None)
        {
          const Index other = twin / 3 - component.FirstTriangle;
          this->Region[other] = this->Region[t];
          this->ToRoot[other] = twin;
          this->Order.push_back(other);
        }
      }
    }
    while (nextSeed < triangles && this->Region[nextSeed] != None)
    {
      ++nextSeed;
    }
    if (nextSeed == triangles)
    {
      return;
    }
    this->Region[nextSeed] = static_cast<Index>(this->Open.size());
    this->Open.push_back(0);
    this->Order.push_back(nextSeed);
  }
}

void TreeCotree::FindGenerators(const ConstrainedSets& constrained)
{
  const TriangleMesh& mesh = this->Forms.GetMesh();
  const TriangleMesh::Component& component = this->Forms.GetComponent();
  std::vector<char> isCrossed(component.Edges(), 0);
  for (const Index h : this->ToRoot)
  {
    if (h != None)
    {
      isCrossed[this->Forms.LocalEdge(h)] = 1;
    }
  }
  JoinedSets sets(component.Vertices());
  const auto halfEdgeOf = [&](Index e) { return mesh.HalfEdge(component.FirstEdge + e); };
  std::vector<Index> treeEdges;
  for (const bool fixed : { true, false })
  {
    for (Index e = 0; e < component.Edges(); ++e)
    {
      if (constrained.IsFixed(e) != fixed || isCrossed[e])
      {
        continue;
      }
      const Index a = this->Forms.LocalTail(halfEdgeOf(e));
      const Index b = this->Forms.LocalHead(halfEdgeOf(e));
      if (sets.Find(a) != sets.Find(b))
      {
        sets.Join(a, b);
        treeEdges.push_back(e);
      }
      else if (!fixed)
      {
        this->Generators.push_back(e);
      }
    }
  }
  if (this->Generators.empty())
  {
    return;
  }
  // The tree of vertices, hung up at the first one.
  std::vector<Index> begin(component.Vertices() + 1, 0);
  for (const Index e : treeEdges)
  {
    ++begin[this->Forms.LocalTail(halfEdgeOf(e)) + 1];
    ++begin[this->Forms.LocalHead(halfEdgeOf(e)) + 1];
  }
  for (Index v = 0; v < component.Vertices(); ++v)
  {
    begin[v + 1] += begin[v];
  }
  std::vector<Index> at(begin.begin(), begin.end() - 1);
  std::vector<Index> incident(static_cast<std::size_t>(begin.back()));
  for (const Index e : treeEdges)
  {
    incident[at[this->Forms.LocalTail(halfEdgeOf(e))]++] = e;
    incident[at[this->Forms.LocalHead(halfEdgeOf(e))]++] = e;
  }
  this->Up.assign(component.Vertices(), None);
  this->Depth.assign(component.Vertices(), None);
  std::vector<Index> queue = { 0 };
  this->Depth[0] = 0;
  for (std::size_t k = 0; k < queue.size(); ++k)
  {
    const Index v = queue[k];
    for (Index i = begin[v]; i < begin[v + 1]; ++i)
    {
      const Index h = halfEdgeOf(incident[i]);
      const Index other =
        this->Forms.LocalTail(h) == v ? this->Forms.LocalHead(h) : this->Forms.LocalTail(h);
      if (this->Depth[other] == None)
      {
        this->Depth[other] = this->Depth[v] + 1;
        this->Up[other] = incident[i];
        queue.push_back(other);
      }
    }
  }
}

IntegerForm TreeCotree::Route(std::vector<int> around) const
{
  const TriangleMesh& mesh = this->Forms.GetMesh();
  const TriangleMesh::Component& component = this->Forms.GetComponent();
  IntegerForm form(component.Edges(), 0);
  for (auto k = this->Order.rbegin(); k != this->Order.rend(); ++k)
  {
    const Index h = this->ToRoot[*k];
    if (h == None || around[*k] == 0)
    {
      continue;
    }
    form[this->Forms.LocalEdge(h)] += this->Forms.Sign(h) * around[*k];
    const Index twin = mesh.Twin(h);
    if (twin != None)
    {
      around[twin / 3 - component.FirstTriangle] += around[*k];
    }
  }
  return form;
}

void TreeCotree::AddPath(Index localTriangle, int value, std::vector<Term>& terms) const
{
  const TriangleMesh& mesh = this->Forms.GetMesh();
  const Index first = this->Forms.GetComponent().FirstTriangle;
  for (Index t = localTriangle; this->ToRoot[t] != None;)
  {
    const Index h = this->ToRoot[t];
    terms.push_back({ this->Forms.LocalEdge(h), this->Forms.Sign(h) * value });
    if (mesh.Twin(h) == None)
    {
      return;
    }
    t = mesh.Twin(h) / 3 - first;
  }
}

std::vector<TreeCotree::Term> TreeCotree::FormOf(std::size_t generator) const
{
  const TriangleMesh& mesh = this->Forms.GetMesh();
  const TriangleMesh::Component& component = this->Forms.GetComponent();
  const Index edge = this->Generators[generator];
  const Index h = mesh.HalfEdge(component.FirstEdge + edge);
  std::vector<Term> terms = { { edge, 1 } };
  // The edge adds 1 around the triangle on its left and takes 1 on its right, which the paths take
  // back.
  this->AddPath(h / 3 - component.FirstTriangle, -1, terms);
  if (mesh.Twin(h) != None)
  {
    this->AddPath(mesh.Twin(h) / 3 - component.FirstTriangle, 1, terms);
  }
  std::map<Index, int> sums;
  for (const Term& term : terms)
  {
    sums[term.Edge] += term.Value;
  }
  terms.clear();
  for (const auto& [sumEdge, value] : sums)
  {
    if (value != 0)
    {
      terms.push_back({ sumEdge, value });
    }
  }
  return terms;
}

std::vector<Index> TreeCotree::LoopOf(std::size_t generator) const
{
  const TriangleMesh& mesh = this->Forms.GetMesh();
  const Index firstEdge = this->Forms.GetComponent().FirstEdge;
  const Index closing = mesh.HalfEdge(firstEdge + this->Generators[generator]);
  Index ahead = this->Forms.LocalHead(closing);
  Index behind = this->Forms.LocalTail(closing);
  std::vector<Index> loop = { this->Generators[generator] };
  std::vector<Index> back;
  const auto climb = [&](Index& v, std::vector<Index>& path)
  {
    const Index e = this->Up[v];
    path.push_back(e);
    const Index h = mesh.HalfEdge(firstEdge + e);
    v = this->Forms.LocalTail(h) == v ? this->Forms.LocalHead(h) : this->Forms.LocalTail(h);
  };
  while (ahead != behind)
  {
    if (this->Depth[ahead] >= this->Depth[behind])
    {
      climb(ahead, loop);
    }
    else
    {
      climb(behind, back);
    }
  }
  loop.insert(loop.end(), back.rbegin(), back.rend());
  return loop;
}
}
