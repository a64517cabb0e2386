// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Preparation/FeaturePaths.h"

#include "Support/SortedEnds.h"

#include <algorithm>

namespace DirectionFields::Internal
{
namespace
{
/// Whether the flags, empty for none, have one at an edge.
bool IsAt(const std::vector<char>& flags, Index e)
{
  return !flags.empty() && flags[e] != 0;
}
}

FeaturePaths::FeaturePaths(const TriangleMesh& mesh, const std::vector<char>& isFeature,
  const std::vector<char>& isHard, const std::vector<char>& isSoft)
{
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    if (IsAt(isFeature, e) || IsAt(isHard, e) || IsAt(isSoft, e))
    {
      const Index a = mesh.Point(mesh.Tail(mesh.HalfEdge(e)));
      const Index b = mesh.Point(mesh.Head(mesh.HalfEdge(e)));
      const std::array<Index, 2> ends = SortedEnds(a, b);
      this->Paths.push_back({ ends, { ends[0], ends[1] }, IsAt(isHard, e), IsAt(isSoft, e) });
    }
  }
  this->Sort();
}

FeaturePaths::FeaturePaths(const TriangleMesh& mesh, const std::vector<char>& isFeature,
  const Decimation& decimation, const std::vector<char>& isHard, const std::vector<char>& isSoft)
{
  // The neighbours along the features; where there are more than two the vertex is still there.
  std::vector<std::array<Index, 2>> neighbours(mesh.GetNumberOfVertices(), { None, None });
  const auto isOn = [&](Index e)
  { return isFeature[e] != 0 || mesh.Twin(mesh.HalfEdge(e)) == None; };
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    if (isOn(e))
    {
      const Index a = mesh.Tail(mesh.HalfEdge(e));
      const Index b = mesh.Head(mesh.HalfEdge(e));
      neighbours[a][neighbours[a][0] == None ? 0 : 1] = b;
      neighbours[b][neighbours[b][0] == None ? 0 : 1] = a;
    }
  }
  const auto follow = [&](Index start, Index next, Index first)
  {
    Path path;
    // Where only two features meet, both are hard or none is.
    path.IsHard = IsAt(isHard, first);
    path.IsSoft = IsAt(isSoft, first);
    path.Points.push_back(mesh.Point(start));
    Index before = start;
    Index v = next;
    while (!decimation.IsVertex(v))
    {
      path.Points.push_back(mesh.Point(v));
      const Index after = neighbours[v][neighbours[v][0] == before ? 1 : 0];
      before = v;
      v = after;
    }
    path.Points.push_back(mesh.Point(v));
    path.Ends = { path.Points.front(), path.Points.back() };
    // It is found from both ends.
    if (path.Ends[0] < path.Ends[1])
    {
      this->Paths.push_back(std::move(path));
    }
  };
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index a = mesh.Tail(mesh.HalfEdge(e));
    const Index b = mesh.Head(mesh.HalfEdge(e));
    if (isOn(e) && decimation.IsVertex(a))
    {
      follow(a, b, e);
    }
    if (isOn(e) && decimation.IsVertex(b))
    {
      follow(b, a, e);
    }
  }
  this->Sort();
}

void FeaturePaths::Sort()
{
  std::stable_sort(this->Paths.begin(), this->Paths.end(),
    [](const Path& a, const Path& b) { return a.Ends < b.Ends; });
}

const FeaturePaths::Path* FeaturePaths::Find(Index p, Index q) const
{
  const std::array<Index, 2> ends = SortedEnds(p, q);
  const auto found = std::lower_bound(this->Paths.begin(), this->Paths.end(), ends,
    [](const Path& path, const std::array<Index, 2>& wanted) { return path.Ends < wanted; });
  return found != this->Paths.end() && found->Ends == ends ? &*found : nullptr;
}

template <typename Condition>
std::vector<char> FeaturePaths::FindEdges(
  const TriangleMesh& mesh, const Condition& condition) const
{
  std::vector<char> isFound(mesh.GetNumberOfEdges(), 0);
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = mesh.HalfEdge(e);
    const Path* path = this->Find(mesh.Point(mesh.Tail(h)), mesh.Point(mesh.Head(h)));
    isFound[e] = mesh.Twin(h) != None && path != nullptr && condition(*path) ? 1 : 0;
  }
  return isFound;
}

std::vector<char> FeaturePaths::FindHard(const TriangleMesh& mesh) const
{
  return this->FindEdges(mesh, [](const Path& path) { return path.IsHard; });
}

std::vector<char> FeaturePaths::FindHardAndSoft(const TriangleMesh& mesh) const
{
  return this->FindEdges(mesh, [](const Path& path) { return path.IsHard || path.IsSoft; });
}

Index FeaturePaths::MiddleOf(Index p, Index q) const
{
  const Path* path = this->Find(p, q);
  return path != nullptr && path->Points.size() > 2 ? path->Points[path->Points.size() / 2] : None;
}

void FeaturePaths::Halve(const std::vector<Split>& splits)
{
  std::vector<Path> halves;
  for (const Split& split : splits)
  {
    const Path* path = this->Find(split.Ends[0], split.Ends[1]);
    if (path == nullptr)
    {
      continue;
    }
    // The middle is the highest number, and so the second end of both.
    const auto middle = static_cast<std::ptrdiff_t>(path->Points.size() / 2);
    const bool isInner = path->Points.size() > 2;
    Path first{ { path->Ends[0], split.Middle },
      { path->Points.begin(), path->Points.begin() + middle }, path->IsHard, path->IsSoft };
    Path second{ { path->Ends[1], split.Middle },
      { path->Points.rbegin(), path->Points.rend() - (isInner ? middle + 1 : middle) },
      path->IsHard, path->IsSoft };
    for (Path* half : { &first, &second })
    {
      half->Points.push_back(split.Middle);
      halves.push_back(std::move(*half));
    }
  }
  this->Paths.insert(this->Paths.end(), std::make_move_iterator(halves.begin()),
    std::make_move_iterator(halves.end()));
  this->Sort();
}
}
