// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PureQuads/TrianglePairs.h"

#include "FaceMesh/FaceRules.h"
#include "PureQuads/FaceStrip.h"
#include "PureQuads/StripCuts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// The changes that joins may make: first all triangles search for those that make no vertex
/// irregular, then for those that cost two irregular vertices, and so on.
struct Price
{
  /// By how much the irregularity may grow.
  int Grown;
  /// The least scaled Jacobian of the faces around.
  double Quality;
};
constexpr int AnyGrowth = std::numeric_limits<int>::max();
constexpr Price Prices[] = { { 0, 0.3 }, { 20, 0.3 }, { AnyGrowth, 0.3 }, { AnyGrowth, 0.2 },
  { AnyGrowth, -1.0 } };
/// Number of strips to other triangles that are tried for each, and looked at.
constexpr int MostWays = 6;
constexpr int MostLooks = 60;
/// Cost of a strip that turns, in faces: two vertices become irregular there.
constexpr Index PerTurn = 8;
constexpr int Moves = 6;
/// Number of vertices that may be moved in trials: a constant, and a number for each face.
constexpr std::size_t MostMovedAnyway = 5000;
constexpr std::size_t MostMovedPerFace = 10;
/// All rows that are taken out have at most this number of quads: a constant, and a part of all
/// faces. The steps on strips beside them are this number for each face.
constexpr Index MostTakenAnyway = 8;
constexpr Index OneTakenOf = 40;
constexpr Index MostStepsPerFace = 100;
/// Rows and the strips beside them are this long at most.
constexpr Index LongestRow = 256;

constexpr Faces::Face Nothing = { None, None, None, None };

class Pairs
{
public:
  Pairs(
    VertexStars& faces, MovableFaces& places, std::vector<FaceEdits::Rule> rules, JoinPolicy policy)
    : Cells(faces)
    , Places(places)
    , Edits(faces, std::move(rules), &places)
    , Cuts(faces, places, this->Edits)
    , Policy(policy)
    , MovesLeft(MostMovedAnyway + MostMovedPerFace * faces.GetNumberOfFaces())
    , RowsLeft(MostTakenAnyway + faces.GetNumberOfFaces() / OneTakenOf)
    , StepsLeft(MostStepsPerFace * faces.GetNumberOfFaces())
    , Seen(4 * faces.GetNumberOfFaces(), None)
    , From(4 * faces.GetNumberOfFaces(), None)
    , Cost(4 * faces.GetNumberOfFaces(), 0)
  {
  }

  /// Joins a triangle with another one over a strip of at most this cost; returns whether it did.
  bool Join(Index triangle, Index farthest, const Price& price)
  {
    this->Wanted = price;
    this->Start = this->Cells.GetChanges().size();
    return this->JoinAsItIs(triangle, farthest, PerTurn);
  }

  /// Lets a triangle first change places with parts of a quad beside it: from there strips may be
  /// better.
  bool JoinAfterMove(Index triangle, Index farthest, const Price& price)
  {
    const std::size_t start = this->Cells.GetChanges().size();
    this->Wanted = price;
    this->Start = start;
    const Faces::Face face = this->Cells.Face(triangle);
    for (int c = 0; c < 3; ++c)
    {
      const Index quad = this->Beyond(triangle, face[c], face[(c + 1) % 3]);
      for (Index diagonal = 0; quad != None && diagonal < 5; ++diagonal)
      {
        if (Faces::Size(this->Cells.Face(quad)) == 4 &&
          this->Edits.Do({ triangle, quad, diagonal }))
        {
          const Index moved = Faces::Size(this->Cells.Face(quad)) == 3 ? quad : triangle;
          if (this->JoinAsItIs(moved, farthest, PerTurn))
          {
            return true;
          }
          this->Cells.UndoTo(start);
        }
      }
    }
    return false;
  }

  /// Takes out the row of quads beyond an edge of a triangle, up to the boundary, to a triangle at
  /// its other end, or to a face from where a straight strip leads to another triangle.
  bool JoinAfterRow(Index triangle, Index farthest, const Price& price)
  {
    this->Start = this->Cells.GetChanges().size();
    const Faces::Face face = this->Cells.Face(triangle);
    for (int c = 0; c < 3; ++c)
    {
      if (this->TakeOutRow(triangle, face[c], face[(c + 1) % 3], farthest, price))
      {
        return true;
      }
      this->Cells.UndoTo(this->Start);
    }
    return false;
  }

private:
  bool TakeOutRow(Index f, Index tail, Index head, Index farthest, const Price& price)
  {
    this->Wanted = price;
    const Index longest = std::min({ farthest, LongestRow, this->RowsLeft });
    for (Index k = 1; k <= longest && this->StepsLeft > 0; ++k)
    {
      const Index next = this->Cells.Across(f, tail, head);
      const Faces::Face face = next != None ? this->Cells.Face(next) : Nothing;
      const bool isEnd = next == None || Faces::Size(face) == 3;
      const bool isHub = this->Places.IsHub(tail) || this->Places.IsHub(head);
      const bool isWall = next == None || this->Cells.IsLineEdge(tail, head);
      if (isHub || (isWall && this->Policy != JoinPolicy::Cheap) ||
        (next != None && !HasEdge(face, head, tail)) || !this->Merge(tail, head))
      {
        return false;
      }
      if (isEnd)
      {
        const std::vector<Index> touched = this->Cells.TouchedSince(this->Start);
        const bool isGood = this->Wanted.Grown >= 0 && this->Settle(touched, price.Quality);
        this->RowsLeft -= isGood ? k : 0;
        return isGood;
      }
      const Index left = std::min(farthest, LongestRow) - k;
      if (this->JoinAsItIs(next, left, left + 1))
      {
        this->RowsLeft -= k;
        return true;
      }
      const auto at = std::find(face.begin(), face.end(), tail) - face.begin();
      f = next;
      tail = face[(at + 1) % 4];
      head = face[(at + 2) % 4];
    }
    return false;
  }

  /// Merges the ends of an edge of a triangle; its growth counts.
  bool Merge(Index tail, Index head)
  {
    for (const FaceEdits::Edit& edit :
      { FaceEdits::Edit{ tail, head, None }, FaceEdits::Edit{ head, tail, None } })
    {
      const int grown = this->Edits.GrowthBy(edit);
      if (this->Edits.Do(edit))
      {
        this->Wanted.Grown -= this->Wanted.Grown == AnyGrowth ? 0 : grown;
        return true;
      }
    }
    return false;
  }

  /// Moves vertices to better places. Returns false, and puts them back, if faces are not good
  /// then.
  bool Settle(const std::vector<Index>& vertices, double quality)
  {
    if (vertices.size() > this->MovesLeft)
    {
      return false;
    }
    this->MovesLeft -= vertices.size();
    const std::vector<Vector3> before = this->PlacesOf(vertices);
    this->Places.Relax(vertices, Moves);
    if (this->LeastQuality(vertices) >= quality)
    {
      return true;
    }
    this->PutBack(vertices, before);
    return false;
  }

  /// The cheapest strips are tried first (Dijkstra), entering faces over each of their edges.
  bool JoinAsItIs(Index triangle, Index farthest, Index perTurn)
  {
    int ways = MostWays;
    // Triangles that may stay are not worth a long search.
    int looks = this->Policy == JoinPolicy::Free ? MostWays : MostLooks;
    using Arrival = std::pair<Index, Index>;
    std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> front;
    // A face and the edge over which it is entered; the last one of a triangle is none.
    const Index start = 4 * triangle + 3;
    this->Seen[start] = ++this->Stamp;
    this->Cost[start] = 0;
    front.emplace(0, start);
    while (!front.empty() && front.top().first <= farthest)
    {
      const auto [cost, entry] = front.top();
      front.pop();
      this->StepsLeft -= this->StepsLeft > 0 && perTurn != PerTurn ? 1 : 0;
      const Index f = entry / 4;
      const Faces::Face face = this->Cells.Face(f);
      const int size = Faces::Size(face);
      for (int c = 0; cost == this->Cost[entry] && c < size; ++c)
      {
        const Index tail = face[c];
        const Index head = face[(c + 1) % size];
        const Index g = c != entry % 4 ? this->Beyond(f, tail, head) : None;
        if (g == None || g == triangle)
        {
          continue;
        }
        const Faces::Face& other = this->Cells.Face(g);
        const auto at =
          static_cast<Index>(std::find(other.begin(), other.end(), head) - other.begin());
        const bool isQuad = Faces::Size(other) == 4;
        const bool isStraight = size == 3 || (c + 2) % 4 == entry % 4;
        const Index there =
          cost + (isQuad ? this->CostOfPassing(g) : 1) + (isStraight ? 0 : perTurn);
        const Index next = 4 * g + at;
        if (isQuad && this->Seen[next] == this->Stamp && this->Cost[next] <= there)
        {
          continue;
        }
        this->From[next] = entry;
        this->Cost[next] = there;
        if (isQuad)
        {
          this->Seen[next] = this->Stamp;
          front.emplace(there, next);
        }
        else if (this->Try(this->WayTo(next), ways))
        {
          return true;
        }
        else if (ways <= 0 || --looks == 0)
        {
          return false;
        }
      }
    }
    return false;
  }

  /// Next to lines there is less room for other quads.
  Index CostOfPassing(Index f) const
  {
    Index cost = 1;
    for (const Index v : this->Cells.Face(f))
    {
      cost += this->Cells.LineEnds(v).empty() ? 0 : 1;
    }
    return cost;
  }

  /// The face over an edge of no line, if it is wound alike; none at hubs, where the search takes
  /// long.
  Index Beyond(Index f, Index tail, Index head) const
  {
    const bool isWall =
      this->Cells.IsLineEdge(tail, head) || this->Places.IsHub(tail) || this->Places.IsHub(head);
    const Index g = isWall ? None : this->Cells.Across(f, tail, head);
    return g != None && HasEdge(this->Cells.Face(g), head, tail) ? g : None;
  }

  std::vector<Index> WayTo(Index entry) const
  {
    std::vector<Index> path = { entry / 4 };
    while (this->Cost[entry] > 0)
    {
      entry = this->From[entry];
      path.push_back(entry / 4);
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  /// Joins the triangles at the ends of a strip by the first cut that leaves good faces, or else,
  /// if any is allowed, by the one that leaves the best ones.
  bool Try(const std::vector<Index>& path, int& ways)
  {
    const FaceStrip strip(this->Cells, path);
    if (!strip.IsSimple())
    {
      return false;
    }
    const std::size_t start = this->Cells.GetChanges().size();
    const bool isAnyGood = this->Wanted.Quality <= 0.0;
    const double least = isAnyGood ? Prices[0].Quality : this->Wanted.Quality;
    const StripCuts::Cut* best = nullptr;
    double most = -1.0;
    const std::vector<StripCuts::Cut> cuts = this->Cuts.Find(strip);
    bool isTried = false;
    for (const StripCuts::Cut& cut : cuts)
    {
      if (cut.Grown <= this->Wanted.Grown && this->Cuts.Do(path, strip, cut))
      {
        isTried = true;
        const std::vector<Index> touched = this->Cells.TouchedSince(this->Start);
        if (touched.size() <= this->MovesLeft || isAnyGood)
        {
          this->MovesLeft -= std::min(this->MovesLeft, touched.size());
          const std::vector<Vector3> before = this->PlacesOf(touched);
          this->Places.Relax(touched, Moves);
          const double quality = this->LeastQuality(touched);
          if (quality >= least)
          {
            return true;
          }
          if (best == nullptr || quality > most)
          {
            best = &cut;
            most = quality;
          }
          this->PutBack(touched, before);
        }
      }
      this->Cells.UndoTo(start);
    }
    ways -= isTried ? 1 : 0;
    if (!isAnyGood || best == nullptr)
    {
      return false;
    }
    this->Cuts.Do(path, strip, *best);
    this->Places.Relax(this->Cells.TouchedSince(this->Start), Moves);
    return true;
  }

  std::vector<Vector3> PlacesOf(const std::vector<Index>& vertices) const
  {
    std::vector<Vector3> places;
    for (const Index v : vertices)
    {
      places.push_back(this->Places.GetPoints()[v]);
    }
    return places;
  }

  void PutBack(const std::vector<Index>& vertices, const std::vector<Vector3>& places)
  {
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      this->Places.GetPoints()[vertices[k]] = places[k];
    }
  }

  double LeastQuality(const std::vector<Index>& vertices) const
  {
    double least = 1.0;
    for (const Index v : vertices)
    {
      least = std::min(least, this->Cells.At(v).empty() ? 1.0 : this->Places.LeastQuality(v));
    }
    return least;
  }

  VertexStars& Cells;
  MovableFaces& Places;
  FaceEdits Edits;
  StripCuts Cuts;
  /// Rows may change the number of triangles between lines only before that is evened out.
  JoinPolicy Policy;
  Price Wanted = Prices[0];
  /// The number of changes before the edits that are tried.
  std::size_t Start = 0;
  /// The number of vertices that may still be moved. Where faces are bad everywhere no strip is
  /// found.
  std::size_t MovesLeft;
  /// The number of quads that may still be taken out in rows, and of faces on strips beside them.
  Index RowsLeft;
  Index StepsLeft;
  /// The last search that reached a face, the face before it on the strip, and the cost of the
  /// strip.
  std::vector<Index> Seen;
  std::vector<Index> From;
  std::vector<Index> Cost;
  Index Stamp = 0;
};
}

void JoinTriangles(VertexStars& faces, MovableFaces& places,
  const std::vector<FaceMesh::Vertex>& vertices, JoinPolicy policy, const Progress& progress)
{
  Pairs pairs(faces, places, WithoutLocks(RulesFor(faces, places, vertices)), policy);
  std::vector<Index> left;
  for (Index f = 0; f < faces.GetNumberOfFaces(); ++f)
  {
    if (faces.IsFace(f) && Faces::Size(faces.Face(f)) == 3)
    {
      left.push_back(f);
    }
  }
  const auto isJoined = [&](Index f)
  { return !faces.IsFace(f) || Faces::Size(faces.Face(f)) == 4; };
  const auto joinEach = [&](const auto& join)
  {
    for (const Index f : left)
    {
      progress.RequireToGoOn();
      if (!isJoined(f))
      {
        join(f);
      }
    }
    left.erase(std::remove_if(left.begin(), left.end(), isJoined), left.end());
  };
  const Index anywhere = 4 * faces.GetNumberOfFaces();
  const std::size_t count = policy == JoinPolicy::Free ? 1
    : policy == JoinPolicy::Cheap                      ? 3
    : policy == JoinPolicy::Good                       ? 4
                                                       : std::size(Prices);
  for (std::size_t k = 0; k < count; ++k)
  {
    const Price& price = Prices[k];
    for (Index farthest = 1; !left.empty() && farthest < anywhere; farthest *= 4)
    {
      // Dear joins are left to strips for which the triangles have been evened out.
      if (policy != JoinPolicy::Cheap || price.Grown < AnyGrowth)
      {
        joinEach([&](Index f) { pairs.Join(f, farthest, price); });
      }
      if (policy != JoinPolicy::Free)
      {
        joinEach([&](Index f) { pairs.JoinAfterRow(f, farthest, price); });
      }
    }
    if (price.Quality < Prices[0].Quality)
    {
      joinEach([&](Index f) { pairs.JoinAfterMove(f, anywhere, price); });
    }
  }
  progress.Report(1.0);
}
}
