// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Dislocations/EdgeLoops.h"

#include "Support/SortedEnds.h"

#include <algorithm>
#include <set>
#include <utility>

namespace DirectionFields::Internal
{
EdgeLoops::EdgeLoops(const FaceMesh& mesh)
  : Mesh(mesh)
  , Twins(4 * mesh.Cells.Corners.size(), None)
  , AreLines(4 * mesh.Cells.Corners.size(), 0)
  , Counts(mesh.Points.size(), 0)
  , AreRegular(mesh.Points.size(), 0)
  , AreMouths(mesh.Points.size(), 0)
  , AreInside(mesh.Points.size(), 0)
{
  this->FindTwins();
  this->FindVertices();
  this->FindChains();
}

Index EdgeLoops::Next(Index halfEdge) const
{
  const Index f = halfEdge / 4;
  const Index c = halfEdge % 4 + 1;
  return 4 * f + (c < Faces::Size(this->Mesh.Cells.Corners[f]) ? c : 0);
}

Index EdgeLoops::Previous(Index halfEdge) const
{
  const Index c = halfEdge % 4;
  return c > 0 ? halfEdge - 1 : halfEdge - 1 + Faces::Size(this->Mesh.Cells.Corners[halfEdge / 4]);
}

std::array<Index, 2> EdgeLoops::Beside(Index halfEdge, Index v) const
{
  const Index twin = this->Twins[halfEdge];
  return this->Head(halfEdge) == v
    ? std::array<Index, 2>{ this->Head(this->Next(halfEdge)), this->Tail(this->Previous(twin)) }
    : std::array<Index, 2>{ this->Tail(this->Previous(halfEdge)), this->Head(this->Next(twin)) };
}

void EdgeLoops::FindTwins()
{
  struct Side
  {
    std::array<Index, 2> Ends;
    Index HalfEdge;
    bool operator<(const Side& other) const
    {
      return this->Ends != other.Ends ? this->Ends < other.Ends : this->HalfEdge < other.HalfEdge;
    }
  };
  std::vector<Side> sides;
  const std::vector<Faces::Face>& faces = this->Mesh.Cells.Corners;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    for (int c = 0; c < Faces::Size(faces[f]); ++c)
    {
      const Index h = 4 * static_cast<Index>(f) + c;
      sides.push_back({ SortedEnds(this->Tail(h), this->Head(h)), h });
    }
  }
  std::sort(sides.begin(), sides.end());
  std::set<std::array<Index, 2>> lines;
  for (const FaceMesh::LineEdge& edge : this->Mesh.LineEdges)
  {
    lines.insert(SortedEnds(edge.Ends[0], edge.Ends[1]));
  }
  for (std::size_t k = 0; k < sides.size();)
  {
    std::size_t end = k + 1;
    while (end < sides.size() && sides[end].Ends == sides[k].Ends)
    {
      ++end;
    }
    const Index h = sides[k].HalfEdge;
    if (end == k + 2 && this->Tail(h) == this->Head(sides[k + 1].HalfEdge))
    {
      this->Twins[h] = sides[k + 1].HalfEdge;
      this->Twins[sides[k + 1].HalfEdge] = h;
    }
    const bool isLine = end != k + 2 || lines.count(sides[k].Ends) > 0;
    for (; k < end; ++k)
    {
      this->AreLines[sides[k].HalfEdge] = isLine ? 1 : 0;
    }
  }
}

void EdgeLoops::FindVertices()
{
  const std::vector<Faces::Face>& faces = this->Mesh.Cells.Corners;
  std::vector<Index> quads(this->Counts.size(), 0);
  std::vector<Index> into(this->Counts.size(), None);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const int size = Faces::Size(faces[f]);
    for (int c = 0; c < size; ++c)
    {
      const Index v = faces[f][c];
      ++this->Counts[v];
      quads[v] += size == 4 ? 1 : 0;
      into[v] = this->Previous(4 * static_cast<Index>(f) + c);
    }
  }
  for (std::size_t v = 0; v < into.size(); ++v)
  {
    const FaceMesh::Vertex& vertex = this->Mesh.Vertices[v];
    const Index count = this->Counts[v];
    if (into[v] == None || quads[v] != count || vertex.Line < 0)
    {
      continue;
    }
    // Around the vertex, as far as faces go.
    Index first = into[v];
    Index around = 0;
    bool isClosed = false;
    while (around < count && !isClosed && this->Twins[this->Next(first)] != None)
    {
      first = this->Twins[this->Next(first)];
      ++around;
      isClosed = first == into[v];
    }
    if (isClosed && around != count)
    {
      continue;
    }
    if (isClosed)
    {
      std::array<bool, 4> isLine{};
      Index lines = 0;
      for (Index k = 0; k < count; ++k)
      {
        isLine[k % 4] = this->IsLine(first);
        lines += this->IsLine(first) ? 1 : 0;
        first = this->Twins[this->Next(first)];
      }
      const bool isOnLine = vertex.Line > 0;
      const bool goesOn = lines == 2 && isLine[0] == isLine[2];
      this->AreRegular[v] = count == 4 && (isOnLine ? goesOn : lines == 0) ? 1 : 0;
      this->AreInside[v] = !isOnLine && lines == 0 && !vertex.IsBoundary ? 1 : 0;
      continue;
    }
    const Index before = this->Twins[first];
    this->AreMouths[v] = count == 2 && vertex.Line > 0 && this->Twins[this->Next(first)] == None &&
        before != None && !this->IsLine(first) && this->Twins[this->Previous(before)] == None
      ? 1
      : 0;
  }
}

/// From every edge on a chain goes both ways, until a vertex is not regular or on it already.
void EdgeLoops::FindChains()
{
  const auto halfEdges = static_cast<Index>(this->Twins.size());
  std::vector<char> isTaken(this->Twins.size(), 0);
  std::vector<Index> last(this->Counts.size(), None);
  const auto isFree = [&](Index h)
  { return h != None && this->Twins[h] != None && !this->IsLine(h) && isTaken[h] == 0; };
  const auto take = [&](Index h)
  {
    isTaken[h] = 1;
    isTaken[this->Twins[h]] = 1;
  };
  for (Index start = 0; start < halfEdges; ++start)
  {
    if (!isFree(start))
    {
      continue;
    }
    const auto number = static_cast<Index>(this->Chains.size());
    std::vector<Index> back;
    const auto walk = [&](Index h, std::vector<Index>& way)
    {
      for (; isFree(h); h = this->IsRegular(this->Head(h)) ? this->Ahead(h) : None)
      {
        take(h);
        way.push_back(h);
        if (std::exchange(last[this->Head(h)], number) == number)
        {
          break;
        }
      }
    };
    std::vector<Index> chain;
    last[this->Tail(start)] = number;
    walk(start, chain);
    const Index behind = this->Twins[start];
    if (this->IsRegular(this->Head(behind)))
    {
      walk(this->Ahead(behind), back);
    }
    std::reverse(back.begin(), back.end());
    std::transform(back.begin(), back.end(), back.begin(), [&](Index h) { return this->Twins[h]; });
    chain.insert(chain.begin(), back.begin(), back.end());
    this->Chains.push_back(std::move(chain));
  }
}
}
