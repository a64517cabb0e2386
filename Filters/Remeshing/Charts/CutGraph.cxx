// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Charts/CutGraph.h"

#include "Soup/JoinedSets.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

namespace DirectionFields::Internal
{
namespace
{
/// Joins the sets of two numbers. Returns whether they were two sets.
bool Joins(JoinedSets& sets, Index a, Index b)
{
  const bool wereTwo = sets.Find(a) != sets.Find(b);
  sets.Join(a, b);
  return wereTwo;
}
}

/// The shortest paths over the triangles of a component from the nearest source: cones, stars of
/// frameless vertices, loops of the boundary.
struct CutGraph::Search
{
  Search(const IntrinsicGeometry& geometry, const TriangleMesh::Component& component,
    const FieldMatching& matching, const std::vector<char>& isFrameless);

  bool IsSpoke(Index edge) const
  {
    const Index h = this->Mesh.HalfEdge(edge);
    return this->IsFrameless[this->Mesh.Tail(h)] != 0 || this->IsFrameless[this->Mesh.Head(h)] != 0;
  }
  /// The middle of an edge to the middle of a triangle.
  double Step(Index h) const
  {
    const std::array<double, 3> squares = { this->Square(h), this->Square(TriangleMesh::Next(h)),
      this->Square(TriangleMesh::Previous(h)) };
    return std::sqrt(std::max(0.0, 2.0 * (squares[1] + squares[2]) - squares[0])) / 6.0;
  }
  double Square(Index h) const { return this->Lengths.SquaredLength[this->Mesh.Edge(h)]; }
  double& DistanceOf(Index t) { return this->Distance[t - this->First]; }
  double DistanceOf(Index t) const { return this->Distance[t - this->First]; }
  Index RegionOf(Index t) const { return this->Region[t - this->First]; }
  Index ParentOf(Index t) const { return this->Parent[t - this->First]; }

  const TriangleMesh& Mesh;
  const Metric& Lengths;
  const std::vector<char>& IsFrameless;
  Index First;
  std::vector<double> Distance;
  /// The source that each triangle is nearest to.
  std::vector<Index> Region;
  /// The half-edge of each triangle that leads towards its source; None at it.
  std::vector<Index> Parent;
  /// The source that a loop of the boundary is, at its half-edges by their edges; None elsewhere.
  std::vector<Index> Loop;
  Index Sources = 0;
  Index Seed = None;

private:
  void AddSources(const TriangleMesh::Component& component, const FieldMatching& matching);
  void Spread();
  void Reach(Index triangle, double distance, Index region, Index parent);

  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> Front;
};

CutGraph::Search::Search(const IntrinsicGeometry& geometry,
  const TriangleMesh::Component& component, const FieldMatching& matching,
  const std::vector<char>& isFrameless)
  : Mesh(geometry.Mesh)
  , Lengths(geometry.Lengths)
  , IsFrameless(isFrameless)
  , First(component.FirstTriangle)
  , Distance(component.Triangles(), -1.0)
  , Region(component.Triangles(), None)
  , Parent(component.Triangles(), None)
  , Loop(component.Edges(), None)
{
  this->AddSources(component, matching);
  this->Spread();
}

void CutGraph::Search::Reach(Index triangle, double distance, Index region, Index parent)
{
  double& known = this->DistanceOf(triangle);
  if (known < 0.0 || distance < known)
  {
    known = distance;
    this->Region[triangle - this->First] = region;
    this->Parent[triangle - this->First] = parent;
    this->Front.emplace(distance, triangle);
  }
}

void CutGraph::Search::AddSources(
  const TriangleMesh::Component& component, const FieldMatching& matching)
{
  std::vector<Index> fan;
  for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
  {
    if (this->IsFrameless[v] != 0)
    {
      this->Mesh.GetFan(v, fan);
      for (const Index h : fan)
      {
        this->Reach(h / 3, 0.0, this->Sources, None);
      }
      ++this->Sources;
    }
  }
  for (Index t = component.FirstTriangle; t < component.EndTriangle; ++t)
  {
    if (matching.SingularityIndex[t] != 0 && this->DistanceOf(t) < 0.0)
    {
      this->Reach(t, 0.0, this->Sources++, None);
    }
  }
  for (Index e = component.FirstEdge; e < component.EndEdge; ++e)
  {
    const Index first = this->Mesh.HalfEdge(e);
    if (this->Mesh.Twin(first) == None && this->Loop[e - component.FirstEdge] == None)
    {
      Index h = first;
      do
      {
        this->Loop[this->Mesh.Edge(h) - component.FirstEdge] = this->Sources;
        this->Reach(h / 3, this->Step(h), this->Sources, h);
        h = this->Mesh.Outgoing(this->Mesh.Head(h));
      } while (h != first);
      ++this->Sources;
    }
  }
  if (this->Sources == 0)
  {
    this->Seed = component.FirstTriangle;
    this->Reach(this->Seed, 0.0, this->Sources++, None);
  }
}

void CutGraph::Search::Spread()
{
  while (!this->Front.empty())
  {
    const auto [distance, t] = this->Front.top();
    this->Front.pop();
    if (distance > this->DistanceOf(t))
    {
      continue;
    }
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      const Index twin = this->Mesh.Twin(h);
      if (twin != None && !this->IsSpoke(this->Mesh.Edge(h)))
      {
        this->Reach(twin / 3, distance + this->Step(h) + this->Step(twin), this->RegionOf(t), twin);
      }
    }
  }
}

CutGraph::CutGraph(const IntrinsicGeometry& geometry, const TriangleMesh::Component& component,
  const FieldMatching& matching, const FeatureLines& features, const std::vector<char>& isFrameless)
  : Geometry(geometry)
  , Matching(matching)
  , FirstEdge(component.FirstEdge)
  , Jumps(component.Edges())
{
  const TriangleMesh& mesh = geometry.Mesh;
  const Search search(geometry, component, matching, isFrameless);
  this->Seed = search.Seed;
  std::vector<char> isCrossed(component.Edges(), 0);
  std::vector<std::tuple<double, Index>> links;
  for (Index e = component.FirstEdge; e < component.EndEdge; ++e)
  {
    const Index h = mesh.HalfEdge(e);
    const Index twin = mesh.Twin(h);
    if (search.IsSpoke(e))
    {
      continue;
    }
    if (search.ParentOf(h / 3) == h || (twin != None && search.ParentOf(twin / 3) == twin))
    {
      isCrossed[e - this->FirstEdge] = 1;
      continue;
    }
    const Index other = twin != None ? search.RegionOf(twin / 3) : search.Loop[e - this->FirstEdge];
    if (other != search.RegionOf(h / 3))
    {
      const double beyond = twin != None ? search.DistanceOf(twin / 3) + search.Step(twin) : 0.0;
      links.emplace_back(search.DistanceOf(h / 3) + search.Step(h) + beyond, e);
    }
  }
  std::sort(links.begin(), links.end());
  JoinedSets regions(search.Sources);
  for (const auto& [length, e] : links)
  {
    const Index h = mesh.HalfEdge(e);
    const Index twin = mesh.Twin(h);
    const Index other = twin != None ? search.RegionOf(twin / 3) : search.Loop[e - this->FirstEdge];
    if (Joins(regions, search.RegionOf(h / 3), other))
    {
      isCrossed[e - this->FirstEdge] = 1;
      this->AddPath(search, e);
    }
  }
  JoinedSets vertices(component.Vertices());
  std::vector<Index> loops;
  for (const bool areFeatures : { true, false })
  {
    for (Index e = component.FirstEdge; e < component.EndEdge; ++e)
    {
      if ((features.IsFeature[e] != 0) != areFeatures || isCrossed[e - this->FirstEdge] != 0 ||
        search.IsSpoke(e))
      {
        continue;
      }
      const Index h = mesh.HalfEdge(e);
      if (!Joins(
            vertices, mesh.Tail(h) - component.FirstVertex, mesh.Head(h) - component.FirstVertex))
      {
        loops.push_back(e);
      }
    }
  }
  this->NumberOfLoops = static_cast<Index>(loops.size());
  for (const Index e : loops)
  {
    this->AddPath(search, e);
  }
}

void CutGraph::AddPath(const Search& search, Index edge)
{
  const TriangleMesh& mesh = this->Geometry.Mesh;
  const int degree = this->Matching.Degree;
  // The path crosses these half-edges; inwards, that is, into their triangles, or outwards.
  struct Crossing
  {
    Index HalfEdge;
    bool IsInwards;
  };
  std::vector<Crossing> path;
  const Index h = mesh.HalfEdge(edge);
  const auto leadToSource = [&](Index t)
  {
    std::vector<Index> parents;
    Index parent = search.ParentOf(t);
    while (parent != None)
    {
      parents.push_back(parent);
      parent = mesh.Twin(parent) != None ? search.ParentOf(mesh.Twin(parent) / 3) : None;
    }
    return parents;
  };
  const std::vector<Index> before = leadToSource(h / 3);
  for (auto parent = before.rbegin(); parent != before.rend(); ++parent)
  {
    path.push_back({ *parent, true });
  }
  path.push_back({ h, false });
  if (mesh.Twin(h) != None)
  {
    for (const Index parent : leadToSource(mesh.Twin(h) / 3))
    {
      path.push_back({ parent, false });
    }
  }
  int turn = 0;
  Index left = None;
  for (const Crossing& crossing : path)
  {
    const Index tail = mesh.Tail(crossing.HalfEdge);
    const Index head = mesh.Head(crossing.HalfEdge);
    const Index nextLeft = crossing.IsInwards ? tail : head;
    if (left != None && nextLeft != left)
    {
      // Both crossings belong to one triangle, whose third edge joins the two left ends.
      const Index inside = crossing.IsInwards ? mesh.Twin(crossing.HalfEdge) : crossing.HalfEdge;
      const Index third = mesh.Tail(TriangleMesh::Next(inside)) == nextLeft
        ? TriangleMesh::Next(inside)
        : TriangleMesh::Previous(inside);
      const int m = this->Matching.MatchingAlong(mesh, third);
      turn -= mesh.Tail(third) == left ? m : -m;
    }
    left = nextLeft;
    // T_{left right} is that of the half-edge inwards, that of its reverse outwards.
    const Index canonical = mesh.HalfEdge(mesh.Edge(crossing.HalfEdge));
    int exponent = turn;
    if (mesh.Tail(canonical) != left)
    {
      exponent += this->Matching.MatchingAlong(mesh, canonical) + degree / 2;
    }
    this->Jumps[mesh.Edge(crossing.HalfEdge) - this->FirstEdge].push_back(
      { this->NumberOfVariables, ((exponent % degree) + degree) % degree });
  }
  ++this->NumberOfVariables;
}
}
