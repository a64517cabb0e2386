// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PureQuads/InsertedRows.h"

#include "PureQuads/FaceStrip.h"
#include "Support/SortedEnds.h"

#include <algorithm>
#include <functional>
#include <map>
#include <queue>
#include <set>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Cost of a turn of the way, in faces: two vertices become irregular there.
constexpr Index PerTurn = 6;
/// The steps of all searches are this number for each face.
constexpr Index MostStepsPerFace = 100;

using Ends = std::array<Index, 2>;

class Rows
{
public:
  explicit Rows(FaceMesh& mesh)
    : Mesh(mesh)
    , StepsLeft(MostStepsPerFace * static_cast<Index>(mesh.Cells.Corners.size()))
  {
    for (const FaceMesh::LineEdge& edge : mesh.LineEdges)
    {
      this->Lines.insert(SortedEnds(edge.Ends[0], edge.Ends[1]));
    }
    for (std::size_t f = 0; f < mesh.Cells.Corners.size(); ++f)
    {
      this->Enter(static_cast<Index>(f));
    }
  }

  /// Returns whether a triangle was joined with another one.
  bool Join(Index triangle)
  {
    const std::vector<Index> way = this->WayFrom(triangle);
    if (way.empty())
    {
      return false;
    }
    std::vector<Ends> edges;
    for (std::size_t k = 0; k + 1 < way.size(); ++k)
    {
      edges.push_back(this->EdgeBetween(way[k], way[k + 1]));
    }
    std::vector<Index> middles;
    for (const Ends& ends : edges)
    {
      middles.push_back(this->Add(0.5 * (this->Mesh.Points[ends[0]] + this->Mesh.Points[ends[1]])));
    }
    for (const Index f : way)
    {
      this->Leave(f);
    }
    this->Open(way.front(), edges.front(), middles.front());
    for (std::size_t k = 1; k + 1 < way.size(); ++k)
    {
      this->Halve(way[k], edges[k - 1], middles[k - 1], edges[k], middles[k]);
    }
    this->Open(way.back(), edges.back(), middles.back());
    return true;
  }

private:
  const Faces::Face& Face(Index f) const { return this->Mesh.Cells.Corners[f]; }
  bool IsTriangle(Index f) const { return Faces::Size(this->Face(f)) == 3; }

  template <typename Visit>
  void ForEdges(Index f, const Visit& visit) const
  {
    const Faces::Face& face = this->Face(f);
    const int size = Faces::Size(face);
    for (int c = 0; c < size; ++c)
    {
      visit(face[c], face[(c + 1) % size]);
    }
  }

  void Enter(Index f)
  {
    this->ForEdges(f, [&](Index v, Index w) { this->At[SortedEnds(v, w)].push_back(f); });
  }

  void Leave(Index f)
  {
    this->ForEdges(f,
      [&](Index v, Index w)
      {
        std::vector<Index>& at = this->At[SortedEnds(v, w)];
        at.erase(std::remove(at.begin(), at.end(), f), at.end());
      });
  }

  /// The face over an edge of no line, if it is wound alike, or None.
  Index Beyond(Index f, Index v, Index w) const
  {
    const Ends ends = SortedEnds(v, w);
    const std::vector<Index>& at = this->At.at(ends);
    if (at.size() != 2 || this->Lines.count(ends) > 0)
    {
      return None;
    }
    const Index g = at[0] == f ? at[1] : at[0];
    return HasEdge(this->Face(g), w, v) ? g : None;
  }

  Ends EdgeBetween(Index f, Index g) const
  {
    Ends between = { None, None };
    this->ForEdges(f,
      [&](Index v, Index w)
      {
        if (between[0] == None && this->Beyond(f, v, w) == g)
        {
          between = { v, w };
        }
      });
    return between;
  }

  /// Whether the edges of a quad have no end in common.
  static bool AreOpposite(const Ends& a, const Ends& b)
  {
    return a[0] != b[0] && a[0] != b[1] && a[1] != b[0] && a[1] != b[1];
  }

  /// The cheapest way to another triangle over quads (Dijkstra); empty for none.
  std::vector<Index> WayFrom(Index triangle)
  {
    std::map<Index, Index> from;
    std::map<Index, Index> cost;
    using Arrival = std::pair<Index, Index>;
    std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> front;
    front.emplace(0, triangle);
    from[triangle] = None;
    cost[triangle] = 0;
    while (!front.empty() && this->StepsLeft > 0)
    {
      const Index there = front.top().first;
      const Index f = front.top().second;
      front.pop();
      if (there > cost[f])
      {
        continue;
      }
      --this->StepsLeft;
      if (f != triangle && this->IsTriangle(f))
      {
        std::vector<Index> way;
        for (Index g = f; g != None; g = from[g])
        {
          way.push_back(g);
        }
        return way;
      }
      this->ForEdges(f,
        [&](Index v, Index w)
        {
          const Index g = this->Beyond(f, v, w);
          // Triangles side by side would have a vertex of two faces between them.
          if (g == None || g == from[f] || (f == triangle && this->IsTriangle(g)))
          {
            return;
          }
          const bool isStraight =
            f == triangle || AreOpposite(this->EdgeBetween(from[f], f), { v, w });
          const Index next = there + 1 + (isStraight ? 0 : PerTurn);
          const auto known = cost.find(g);
          if (known == cost.end() || next < known->second)
          {
            cost[g] = next;
            from[g] = f;
            front.emplace(next, g);
          }
        });
    }
    return {};
  }

  Index Add(const Vector3& place)
  {
    this->Mesh.Points.push_back(place);
    this->Mesh.Vertices.emplace_back();
    return static_cast<Index>(this->Mesh.Points.size()) - 1;
  }

  void Replace(Index f, const std::vector<Faces::Face>& parts)
  {
    Faces& cells = this->Mesh.Cells;
    for (std::size_t k = 0; k < parts.size(); ++k)
    {
      if (k == 0)
      {
        cells.Corners[f] = parts[0];
        cells.IsRegular[f] = 0;
        this->Enter(f);
        continue;
      }
      cells.Corners.push_back(parts[k]);
      cells.IsRegular.push_back(0);
      this->Enter(static_cast<Index>(cells.Corners.size()) - 1);
    }
  }

  /// The corners of a face from that on with which one of its edges begins.
  std::vector<Index> CornersFrom(Index f, const Ends& edge) const
  {
    const Faces::Face& face = this->Face(f);
    const int size = Faces::Size(face);
    std::vector<Index> corners;
    for (int c = 0; c < size; ++c)
    {
      if (SortedEnds(face[c], face[(c + 1) % size]) == SortedEnds(edge[0], edge[1]))
      {
        for (int k = 0; k < size; ++k)
        {
          corners.push_back(face[(c + k) % size]);
        }
        break;
      }
    }
    return corners;
  }

  void Open(Index f, const Ends& edge, Index middle)
  {
    const std::vector<Index> c = this->CornersFrom(f, edge);
    this->Replace(f, { { c[0], middle, c[1], c[2] } });
  }

  void Halve(Index f, Ends first, Index atFirst, Ends second, Index atSecond)
  {
    std::vector<Index> c = this->CornersFrom(f, first);
    if (AreOpposite(first, second))
    {
      this->Replace(f, { { c[0], atFirst, atSecond, c[3] }, { atFirst, c[1], c[2], atSecond } });
      return;
    }
    // The second edge is to be the one after the first.
    if (c[1] != second[0] && c[1] != second[1])
    {
      std::swap(first, second);
      std::swap(atFirst, atSecond);
      c = this->CornersFrom(f, first);
    }
    const Index inner = this->Add(MiddleOf(this->Mesh.Points, this->Face(f)));
    this->Replace(f,
      { { atFirst, c[1], atSecond, inner }, { inner, atSecond, c[2], c[3] },
        { c[0], atFirst, inner, c[3] } });
  }

  FaceMesh& Mesh;
  std::set<Ends> Lines;
  /// The faces at each edge.
  std::map<Ends, std::vector<Index>> At;
  Index StepsLeft;
};
}

Index InsertRows(FaceMesh& mesh)
{
  Rows rows(mesh);
  Index left = 0;
  for (std::size_t f = 0; f < mesh.Cells.Corners.size(); ++f)
  {
    const bool isTriangle = Faces::Size(mesh.Cells.Corners[f]) == 3;
    left += isTriangle && !rows.Join(static_cast<Index>(f)) ? 1 : 0;
  }
  return left;
}
}
