// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PureQuads/TriangleParity.h"

#include "FaceMesh/LineCuts.h"
#include "Support/SortedEnds.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Cost of splitting an edge, in faces of distance from a triangle, and the additional cost for
/// each face whose parts are below a scaled Jacobian, or whose region has few faces and so little
/// room for triangles.
constexpr double PerWall = 40.0;
constexpr double Good = 0.3;
constexpr Index FewFaces = 8;
constexpr double PerBadFace = 20.0;
/// The parts of a triangle could be joined only with each other: the new vertex would be flat.
constexpr double PerTriangle = 60.0;
/// Corners of lines leave the faces no room to move.
constexpr double PerCorner = 20.0;

using Wall = LineCuts::Wall;

class Parity
{
public:
  Parity(FaceMesh& mesh, bool mayCutBoundary)
    : Mesh(mesh)
    , MayCutBoundary(mayCutBoundary)
    , Cuts(mesh)
    , Neighbours(mesh.Cells.Corners.size(), { None, None, None, None })
    , UncutEdges(mesh.Cells.Corners.size(), 0)
    , Region(mesh.Cells.Corners.size(), None)
    , Distance(mesh.Cells.Corners.size(), None)
  {
  }

  void EvenOut()
  {
    this->FindWalls();
    this->FindRegions();
    this->FindDistances();
    std::vector<Index> chosen;
    if (!this->ChooseWalls(chosen))
    {
      // If all edges of lines were cut, all regions would be even. So they are if those where
      // sheets meet are cut, and then some of the others.
      for (const Wall& wall : this->Walls)
      {
        if (wall.Faces.size() > 2)
        {
          this->Cuts.Cut(wall, this->MiddleOf(wall));
          for (const Index f : wall.Faces)
          {
            this->IsOdd[this->Region[f]] ^= 1;
          }
        }
      }
      chosen.clear();
      this->ChooseWalls(chosen);
    }
    for (const Index w : chosen)
    {
      this->Cuts.Cut(this->Walls[w], this->MiddleOf(this->Walls[w]));
    }
  }

private:
  const Faces::Face& Face(Index f) const { return this->Mesh.Cells.Corners[f]; }

  /// Finds the faces on the other side of each edge that belongs to no line, and the edges of
  /// lines.
  void FindWalls()
  {
    struct Side
    {
      std::array<Index, 2> Ends;
      Index Face;
      int Corner;
    };
    const auto isLess = [](const auto& a, const auto& b) { return a.Ends < b.Ends; };
    std::vector<Side> sides;
    const auto count = static_cast<Index>(this->Mesh.Cells.Corners.size());
    for (Index f = 0; f < count; ++f)
    {
      const int size = Faces::Size(this->Face(f));
      for (int c = 0; c < size; ++c)
      {
        sides.push_back({ SortedEnds(this->Face(f)[c], this->Face(f)[(c + 1) % size]), f, c });
      }
    }
    std::stable_sort(sides.begin(), sides.end(), isLess);
    std::vector<FaceMesh::LineEdge> lines = this->Mesh.LineEdges;
    for (FaceMesh::LineEdge& edge : lines)
    {
      edge.Ends = SortedEnds(edge.Ends[0], edge.Ends[1]);
    }
    std::stable_sort(lines.begin(), lines.end(), isLess);
    for (std::size_t k = 0, end = 0; k < sides.size(); k = end)
    {
      while (end < sides.size() && sides[end].Ends == sides[k].Ends)
      {
        ++end;
      }
      const Side& one = sides[k];
      const FaceMesh::LineEdge wanted{ one.Ends, 0 };
      const auto [line, last] = std::equal_range(lines.begin(), lines.end(), wanted, isLess);
      if (line != last)
      {
        Wall wall{ one.Ends, {}, line->Line };
        for (std::size_t i = k; i < end; ++i)
        {
          wall.Faces.push_back(sides[i].Face);
        }
        this->AddWall(wall,
          (!this->MayCutBoundary && wall.Faces.size() == 1) ||
            std::any_of(line, last, [](const FaceMesh::LineEdge& e) { return e.Line == 0; }));
      }
      else if (end - k == 2 &&
        this->Face(one.Face)[one.Corner] != this->Face(sides[k + 1].Face)[sides[k + 1].Corner])
      {
        this->Neighbours[one.Face][one.Corner] = sides[k + 1].Face;
        this->Neighbours[sides[k + 1].Face][sides[k + 1].Corner] = one.Face;
      }
    }
  }

  /// @param isKept whether it is not to be cut, as those of a component that could not be remeshed
  void AddWall(const Wall& wall, bool isKept)
  {
    if (!isKept)
    {
      this->Walls.push_back(wall);
      return;
    }
    for (const Index f : wall.Faces)
    {
      ++this->UncutEdges[f];
    }
  }

  /// Calls body for faces and for the faces reached from them over edges of no line, breadth first.
  template <typename Body>
  void Spread(std::vector<Index>&& front, const Body& body) const
  {
    for (std::size_t k = 0; k < front.size(); ++k)
    {
      const Index f = front[k];
      for (const Index g : this->Neighbours[f])
      {
        if (g != None && body(f, g))
        {
          front.push_back(g);
        }
      }
    }
  }

  void FindRegions()
  {
    const auto count = static_cast<Index>(this->Region.size());
    for (Index f = 0; f < count; ++f)
    {
      if (this->Region[f] == None)
      {
        const auto region = static_cast<Index>(this->IsOdd.size());
        this->IsOdd.push_back(0);
        this->Size.push_back(0);
        this->Region[f] = region;
        this->Spread(
          { f }, [&](Index, Index g) { return std::exchange(this->Region[g], region) == None; });
      }
      ++this->Size[this->Region[f]];
      const bool isLeft = Faces::Size(this->Face(f)) == 3 && this->UncutEdges[f] < 3;
      this->IsOdd[this->Region[f]] ^= isLeft ? 1 : 0;
    }
  }

  /// How far the faces are from triangles of their region.
  void FindDistances()
  {
    std::vector<Index> triangles;
    for (std::size_t f = 0; f < this->Distance.size(); ++f)
    {
      if (Faces::Size(this->Face(static_cast<Index>(f))) == 3)
      {
        this->Distance[f] = 0;
        triangles.push_back(static_cast<Index>(f));
      }
    }
    this->Spread(std::move(triangles),
      [&](Index f, Index g)
      {
        const bool isNew = this->Distance[g] == None;
        this->Distance[g] = isNew ? this->Distance[f] + 1 : this->Distance[g];
        return isNew;
      });
  }

  /// The regions on both sides of a wall; the last number is the outside.
  std::array<Index, 2> RegionsOf(const Wall& wall) const
  {
    return { this->Region[wall.Faces[0]],
      wall.Faces.size() > 1 ? this->Region[wall.Faces[1]]
                            : static_cast<Index>(this->IsOdd.size()) };
  }

  /// A step over a wall to a region, or from it.
  struct Crossing
  {
    double Cost;
    Index Region;
    Index Wall;
  };

  /// Connects odd regions along a tree of the cheapest paths to each from the outside, or from the
  /// last region if there is no path outside. False where some stay odd.
  bool ChooseWalls(std::vector<Index>& chosen) const
  {
    if (std::find(this->IsOdd.begin(), this->IsOdd.end(), 1) == this->IsOdd.end())
    {
      return true;
    }
    const auto outside = static_cast<Index>(this->IsOdd.size());
    std::vector<std::vector<Crossing>> crossings(outside + 1);
    for (std::size_t w = 0; w < this->Walls.size(); ++w)
    {
      const std::array<Index, 2> regions = this->RegionsOf(this->Walls[w]);
      if (this->Walls[w].Faces.size() <= 2 && regions[0] != regions[1])
      {
        const double cost = this->CostOf(this->Walls[w]);
        crossings[regions[0]].push_back({ cost, regions[1], static_cast<Index>(w) });
        crossings[regions[1]].push_back({ cost, regions[0], static_cast<Index>(w) });
      }
    }
    std::vector<Crossing> entrance(outside + 1, { 0.0, None, None });
    const std::vector<Index> order = CheapestFirst(crossings, entrance);
    std::vector<char> isOdd = this->IsOdd;
    isOdd.push_back(0);
    bool areEven = true;
    for (std::size_t k = order.size(); k-- > 0;)
    {
      const Index region = order[k];
      if (region != outside && isOdd[region] != 0)
      {
        if (entrance[region].Wall == None)
        {
          areEven = false;
          continue;
        }
        chosen.push_back(entrance[region].Wall);
        isOdd[entrance[region].Region] ^= 1;
      }
    }
    return areEven;
  }

  /// The regions by the cost of the cheapest path to them, from the last one of a connected set
  /// (Dijkstra), and the wall over which each is entered.
  static std::vector<Index> CheapestFirst(
    const std::vector<std::vector<Crossing>>& crossings, std::vector<Crossing>& entrance)
  {
    std::vector<Index> order;
    std::vector<char> isReached(crossings.size(), 0);
    for (std::size_t root = crossings.size(); root-- > 0;)
    {
      // The next step: its cost, the region it leads to, and its entry.
      using Arrival = std::tuple<double, Index, Index, Index>;
      std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> queue;
      queue.emplace(0.0, None, None, static_cast<Index>(root));
      while (!queue.empty())
      {
        const auto [cost, wall, from, region] = queue.top();
        queue.pop();
        if (isReached[region] != 0)
        {
          continue;
        }
        isReached[region] = 1;
        order.push_back(region);
        entrance[region] = { cost, from, wall };
        for (const Crossing& next : crossings[region])
        {
          queue.emplace(cost + next.Cost, next.Wall, region, next.Region);
        }
      }
    }
    return order;
  }

  Vector3 MiddleOf(const Wall& wall) const
  {
    return 0.5 * (this->Mesh.Points[wall.Ends[0]] + this->Mesh.Points[wall.Ends[1]]);
  }

  /// The nearer to triangles the better, and where good faces are left.
  double CostOf(const Wall& wall) const
  {
    double cost = PerWall;
    for (const Index v : wall.Ends)
    {
      cost += this->Mesh.Vertices[v].Line < 0 ? PerCorner : 0.0;
    }
    const Vector3 middle = this->MiddleOf(wall);
    for (const Index f : wall.Faces)
    {
      cost += std::max<Index>(this->Distance[f], 0) +
        (this->Cuts.QualityOf(f, wall.Ends, middle) < Good ? PerBadFace : 0.0) +
        (this->Size[this->Region[f]] < FewFaces ? PerBadFace : 0.0) +
        (Faces::Size(this->Face(f)) == 3 ? PerTriangle : 0.0);
    }
    return cost;
  }

  FaceMesh& Mesh;
  bool MayCutBoundary;
  LineCuts Cuts;
  /// The face over each edge that is part of no line.
  std::vector<std::array<Index, 4>> Neighbours;
  /// The number of edges of each face that are not cut, since they are kept as they are.
  std::vector<int> UncutEdges;
  std::vector<Wall> Walls;
  std::vector<Index> Region;
  std::vector<Index> Distance;
  /// Of the number of each region's triangles.
  std::vector<char> IsOdd;
  /// The number of each region's faces.
  std::vector<Index> Size;
};
}

void EvenOutTriangles(FaceMesh& mesh, bool mayCutBoundary)
{
  Parity(mesh, mayCutBoundary).EvenOut();
}
}
