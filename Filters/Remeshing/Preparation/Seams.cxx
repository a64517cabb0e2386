// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Preparation/Seams.h"

#include "Extraction/BoundaryVertices.h"
#include "Soup/JoinedSets.h"

#include <algorithm>
#include <numeric>

namespace DirectionFields::Internal
{
/// Follows the edges that several sheets have in common.
class Seams::Finder
{
public:
  Finder(const TriangleMesh& mesh, const std::vector<Index>& original)
    : Mesh(mesh)
    , Original(original)
    , GroupOf(mesh.GetNumberOfHalfEdges(), None)
    , Incoming(mesh.GetNumberOfVertices(), None)
  {
    std::vector<std::array<Index, 3>> keys;
    for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      if (mesh.Twin(h) == None)
      {
        const Index p = this->TailPoint(h);
        const Index q = this->HeadPoint(h);
        keys.push_back({ std::min(p, q), std::max(p, q), h });
        this->Incoming[mesh.Head(h)] = h;
      }
    }
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 0; i < keys.size();)
    {
      std::size_t end = i + 1;
      while (end < keys.size() && keys[end][0] == keys[i][0] && keys[end][1] == keys[i][1])
      {
        ++end;
      }
      if (end - i > 1)
      {
        this->Groups.emplace_back();
        for (; i < end; ++i)
        {
          this->GroupOf[keys[i][2]] = static_cast<Index>(this->Groups.size()) - 1;
          this->Groups.back().push_back(keys[i][2]);
        }
      }
      i = end;
    }
  }

  std::vector<Seam> FindAll()
  {
    std::vector<char> isSeen(this->Groups.size(), 0);
    std::vector<Seam> seams;
    // From ends on, then closed ones.
    for (const bool fromEnds : { true, false })
    {
      for (std::size_t g = 0; g < this->Groups.size(); ++g)
      {
        for (const bool isReversed : { false, true })
        {
          std::vector<Run> sides = this->SidesOf(g, isReversed);
          if (isSeen[g] == 0 && (!fromEnds || this->Next(Turned(sides)).empty()))
          {
            seams.push_back(this->Follow(std::move(sides), isSeen));
          }
        }
      }
    }
    return seams;
  }

  int EulerCharacteristic() const
  {
    JoinedSets vertices(this->Mesh.GetNumberOfVertices());
    Index edges = this->Mesh.GetNumberOfEdges();
    Index joined = 0;
    const auto join = [&](Index v, Index w)
    {
      if (vertices.Find(v) != vertices.Find(w))
      {
        vertices.Join(v, w);
        ++joined;
      }
    };
    for (const std::vector<Index>& group : this->Groups)
    {
      edges -= static_cast<Index>(group.size()) - 1;
      for (const Index h : group)
      {
        const bool isAlong = this->TailPoint(h) == this->TailPoint(group.front());
        const Index first = group.front();
        join(this->Mesh.Tail(first), isAlong ? this->Mesh.Tail(h) : this->Mesh.Head(h));
        join(this->Mesh.Head(first), isAlong ? this->Mesh.Head(h) : this->Mesh.Tail(h));
      }
    }
    return static_cast<int>(
      this->Mesh.GetNumberOfVertices() - joined - edges + this->Mesh.GetNumberOfTriangles());
  }

private:
  /// A half-edge on the boundary, and whether a seam runs against it.
  struct Run
  {
    Index HalfEdge;
    bool IsReversed;
  };

  Index TailPoint(Index h) const { return this->Original[this->Mesh.Point(this->Mesh.Tail(h))]; }
  Index HeadPoint(Index h) const { return this->Original[this->Mesh.Point(this->Mesh.Head(h))]; }
  Index Start(const Run& run) const
  {
    return run.IsReversed ? this->Mesh.Head(run.HalfEdge) : this->Mesh.Tail(run.HalfEdge);
  }
  Index End(const Run& run) const
  {
    return run.IsReversed ? this->Mesh.Tail(run.HalfEdge) : this->Mesh.Head(run.HalfEdge);
  }

  static std::vector<Run> Turned(std::vector<Run> sides)
  {
    for (Run& run : sides)
    {
      run.IsReversed = !run.IsReversed;
    }
    return sides;
  }
  /// All sides of an edge, along its first one or against it.
  std::vector<Run> SidesOf(std::size_t group, bool isReversed) const
  {
    std::vector<Run> sides;
    const Index first = this->Groups[group].front();
    for (const Index h : this->Groups[group])
    {
      sides.push_back({ h, (this->TailPoint(h) != this->TailPoint(first)) != isReversed });
    }
    return sides;
  }
  /// The sides of the next edge in the same order; empty where they do not all go on to the same.
  std::vector<Run> Next(const std::vector<Run>& sides) const
  {
    std::vector<Run> next;
    Index group = None;
    for (const Run& run : sides)
    {
      const Index v = this->End(run);
      const Index h = run.IsReversed ? this->Incoming[v] : this->Mesh.Outgoing(v);
      if (h == None || this->GroupOf[h] == None || (group != None && this->GroupOf[h] != group) ||
        this->Groups[this->GroupOf[h]].size() != sides.size())
      {
        return {};
      }
      group = this->GroupOf[h];
      next.push_back({ h, run.IsReversed });
    }
    return next;
  }
  Seam Follow(std::vector<Run> sides, std::vector<char>& isSeen) const
  {
    Seam seam;
    for (const Run& run : sides)
    {
      seam.Sides.push_back({ this->Start(run), None, run.IsReversed });
    }
    while (true)
    {
      isSeen[this->GroupOf[sides.front().HalfEdge]] = 1;
      std::vector<Run> next = this->Next(sides);
      if (next.empty() || isSeen[this->GroupOf[next.front().HalfEdge]] != 0)
      {
        break;
      }
      sides = std::move(next);
    }
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      seam.Sides[i].End = this->End(sides[i]);
    }
    return seam;
  }

  const TriangleMesh& Mesh;
  const std::vector<Index>& Original;
  /// The sides of each edge of a seam.
  std::vector<std::vector<Index>> Groups;
  std::vector<Index> GroupOf;
  /// The half-edge on the boundary that leads to each vertex.
  std::vector<Index> Incoming;
};

/// The boundaries of all components' faces.
class Seams::Sheets
{
public:
  explicit Sheets(const std::vector<ExtractedMesh>& components)
    : First(components.size() + 1, 0)
  {
    for (std::size_t c = 0; c < components.size(); ++c)
    {
      this->First[c + 1] = this->First[c] + static_cast<Index>(components[c].Vertices.size());
    }
    this->Next.assign(this->First.back(), None);
    this->FaceAt.assign(this->First.back(), None);
    for (std::size_t c = 0; c < components.size(); ++c)
    {
      this->FindBoundary(components[c], this->First[c]);
    }
  }

  /// The vertices of the new mesh along a side, from its start on; empty if there is no such path.
  std::vector<Index> Along(const Side& side) const
  {
    const Index start = this->ImageOf(side.IsReversed ? side.End : side.Start);
    const Index end = this->ImageOf(side.IsReversed ? side.Start : side.End);
    if (start == None || end == None)
    {
      return {};
    }
    std::vector<Index> path = { start };
    do
    {
      path.push_back(this->Next[path.back()]);
      if (path.back() == None || path.size() > this->Next.size() + 1)
      {
        return {};
      }
    } while (path.back() != end);
    if (side.IsReversed)
    {
      std::reverse(path.begin(), path.end());
    }
    return path;
  }

  std::size_t ComponentOf(Index v) const
  {
    return std::upper_bound(this->First.begin(), this->First.end(), v) - this->First.begin() - 1;
  }
  Index ImageOf(Index meshVertex) const
  {
    return meshVertex < static_cast<Index>(this->Image.size()) ? this->Image[meshVertex] : None;
  }

  std::vector<Index> First;
  /// The next vertex on the boundary, the faces to the left, and the face there.
  std::vector<Index> Next;
  std::vector<Index> FaceAt;

private:
  void FindBoundary(const ExtractedMesh& cells, Index first)
  {
    for (std::size_t v = 0; v < cells.Vertices.size(); ++v)
    {
      const Index origin = cells.Vertices[v].Origin;
      if (origin != None)
      {
        this->Image.resize(
          std::max(this->Image.size(), static_cast<std::size_t>(origin) + 1), None);
        this->Image[origin] = first + static_cast<Index>(v);
      }
    }
    // Both ends ascending, then the direction, then the face.
    std::vector<std::array<Index, 4>> edges;
    for (std::size_t f = 0; f < cells.Cells.Corners.size(); ++f)
    {
      const Faces::Face& face = cells.Cells.Corners[f];
      for (int c = 0; c < Faces::Size(face); ++c)
      {
        const Index a = face[c];
        const Index b = face[(c + 1) % Faces::Size(face)];
        if (cells.Vertices[a].IsBoundary && cells.Vertices[b].IsBoundary)
        {
          edges.push_back({ std::min(a, b), std::max(a, b), a < b ? 0 : 1, static_cast<Index>(f) });
        }
      }
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      const auto isSame = [&](std::size_t j)
      { return edges[i][0] == edges[j][0] && edges[i][1] == edges[j][1]; };
      if ((i > 0 && isSame(i - 1)) || (i + 1 < edges.size() && isSame(i + 1)))
      {
        continue;
      }
      const Index tail = edges[i][2] == 0 ? edges[i][0] : edges[i][1];
      const Index head = edges[i][2] == 0 ? edges[i][1] : edges[i][0];
      this->Next[first + tail] = first + head;
      this->FaceAt[first + tail] = edges[i][3];
    }
  }

  std::vector<Index> Image;
};

namespace
{
/// The places along a path, from 0 to 1.
std::vector<double> PlacesAlong(const std::vector<Index>& path, const std::vector<Vector3>& points)
{
  std::vector<double> place(path.size(), 0.0);
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    place[i] = place[i - 1] + (points[path[i]] - points[path[i - 1]]).norm();
  }
  const double whole = place.back();
  for (double& s : place)
  {
    s = whole > 0.0 ? s / whole : 0.0;
  }
  return place;
}

/// The place, among more places, for each of fewer vertices: the nearest one that leaves enough
/// places for the others. The ends stay.
std::vector<std::size_t> Matched(const std::vector<double>& fewer, const std::vector<double>& more)
{
  std::vector<std::size_t> match(fewer.size(), 0);
  for (std::size_t i = 1; i + 1 < fewer.size(); ++i)
  {
    std::size_t k = match[i - 1] + 1;
    const std::size_t last = more.size() - (fewer.size() - i);
    while (k < last && std::abs(more[k + 1] - fewer[i]) < std::abs(more[k] - fewer[i]))
    {
      ++k;
    }
    match[i] = k;
  }
  match.back() = more.size() - 1;
  return match;
}
}

Seams::Seams(const TriangleMesh& mesh, const std::vector<Index>& original)
{
  Finder finder(mesh, original);
  this->All = finder.FindAll();
  this->EulerCharacteristic = finder.EulerCharacteristic();
}

std::vector<Index> Seams::GetEnds() const
{
  std::vector<Index> ends;
  for (const Seam& seam : this->All)
  {
    for (const Side& side : seam.Sides)
    {
      ends.push_back(side.Start);
      ends.push_back(side.End);
    }
  }
  return ends;
}

void Seams::Equalize(std::vector<ExtractedMesh>& components) const
{
  if (this->All.empty())
  {
    return;
  }
  const Sheets sheets(components);
  std::vector<Vector3> points;
  for (const ExtractedMesh& cells : components)
  {
    for (const ExtractedMesh::Vertex& vertex : cells.Vertices)
    {
      points.push_back(vertex.Position);
    }
  }
  std::vector<std::vector<BoundaryVertices>> inserted(components.size());
  for (const Seam& seam : this->All)
  {
    std::vector<std::vector<Index>> paths;
    for (const Side& side : seam.Sides)
    {
      paths.push_back(sheets.Along(side));
    }
    const auto isLess = [](const auto& a, const auto& b) { return a.size() < b.size(); };
    if (std::min_element(paths.begin(), paths.end(), isLess)->empty())
    {
      continue;
    }
    const std::vector<Index>& most = *std::max_element(paths.begin(), paths.end(), isLess);
    const std::vector<double> places = PlacesAlong(most, points);
    for (std::size_t k = 0; k < paths.size(); ++k)
    {
      const std::vector<Index>& path = paths[k];
      const std::size_t c = sheets.ComponentOf(path.front());
      const Index first = sheets.First[c];
      const std::vector<std::size_t> match = Matched(PlacesAlong(path, points), places);
      for (std::size_t i = 0; i < path.size(); ++i)
      {
        components[c].Vertices[path[i] - first].Position = points[most[match[i]]];
        if (i == 0 || match[i] == match[i - 1] + 1)
        {
          continue;
        }
        BoundaryVertices between{ None, path[i - 1] - first, path[i] - first, {} };
        for (std::size_t j = match[i - 1] + 1; j < match[i]; ++j)
        {
          between.Positions.push_back(points[most[j]]);
        }
        if (seam.Sides[k].IsReversed)
        {
          std::swap(between.Tail, between.Head);
          std::reverse(between.Positions.begin(), between.Positions.end());
        }
        between.Face = sheets.FaceAt[between.Tail + first];
        inserted[c].push_back(std::move(between));
      }
    }
  }
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    if (!inserted[c].empty())
    {
      InsertBoundaryVertices(components[c], inserted[c]);
    }
  }
}

std::vector<Index> Seams::Joined(const std::vector<ExtractedMesh>& components, Index& open) const
{
  open = 0;
  const Sheets sheets(components);
  const Index count = sheets.First.back();
  std::vector<Index> joined(count);
  std::iota(joined.begin(), joined.end(), 0);
  if (this->All.empty())
  {
    return joined;
  }
  std::vector<std::vector<std::vector<Index>>> paths;
  std::vector<char> isOpen(this->All.size(), 0);
  for (std::size_t s = 0; s < this->All.size(); ++s)
  {
    paths.emplace_back();
    for (const Side& side : this->All[s].Sides)
    {
      paths.back().push_back(sheets.Along(side));
      isOpen[s] = isOpen[s] != 0 || paths.back().back().empty() ||
          paths.back().back().size() != paths.back().front().size()
        ? 1
        : 0;
    }
  }
  for (bool hasChanged = true; hasChanged;)
  {
    hasChanged = false;
    JoinedSets sets(count);
    std::vector<Index> seamAt(count, None);
    for (std::size_t s = 0; s < paths.size(); ++s)
    {
      for (const std::vector<Index>& path : paths[s])
      {
        for (std::size_t i = 0; isOpen[s] == 0 && i < path.size(); ++i)
        {
          sets.Join(path[i], paths[s].front()[i]);
          seamAt[path[i]] = static_cast<Index>(s);
        }
      }
    }
    // A face two corners of which are one would be none.
    for (std::size_t c = 0; c < components.size(); ++c)
    {
      for (const Faces::Face& face : components[c].Cells.Corners)
      {
        const int size = Faces::Size(face);
        for (int i = 0; i < size * size; ++i)
        {
          const Index a = sheets.First[c] + face[i / size];
          const Index b = sheets.First[c] + face[i % size];
          if (a != b && sets.Find(a) == sets.Find(b) && isOpen[seamAt[a]] == 0)
          {
            isOpen[seamAt[a]] = 1;
            hasChanged = true;
          }
        }
      }
    }
    for (Index v = 0; v < count; ++v)
    {
      joined[v] = sets.Find(v);
    }
  }
  open = static_cast<Index>(std::count(isOpen.begin(), isOpen.end(), 1));
  return joined;
}
}
