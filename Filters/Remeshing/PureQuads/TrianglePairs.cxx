// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PureQuads/TrianglePairs.h"

#include "FaceMesh/FaceRules.h"
#include "PureQuads/FaceStrip.h"

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
/// The wanted scaled Jacobian of the faces: first all triangles search for strips that leave it,
/// then the others take any strip.
constexpr double Wanted[] = { 0.3, 0.1, -1.0 };
/// Number of strips to other triangles that are tried for each.
constexpr int MostWays = 6;
constexpr int Moves = 6;
/// Number of vertices that may be moved in trials: a constant, and a number for each face.
constexpr std::size_t MostMovedAnyway = 5000;
constexpr std::size_t MostMovedPerFace = 10;

constexpr Faces::Face Nothing = { None, None, None, None };

class Pairs
{
public:
  Pairs(VertexStars& faces, MovableFaces& places, std::vector<FaceEdits::Rule> rules, int mostGrown)
    : Cells(faces)
    , Places(places)
    , Edits(faces, std::move(rules))
    , MostGrown(mostGrown)
    , MovesLeft(MostMovedAnyway + MostMovedPerFace * faces.GetNumberOfFaces())
    , Seen(faces.GetNumberOfFaces(), None)
    , From(faces.GetNumberOfFaces(), None)
    , Cost(faces.GetNumberOfFaces(), 0)
  {
  }

  /// Lets a triangle first change places with parts of a quad beside it: from there strips may be
  /// better.
  bool JoinAfterMove(Index triangle, Index farthest, double wanted)
  {
    const std::size_t start = this->Cells.GetChanges().size();
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
          if (this->JoinAsItIs(moved, farthest, wanted))
          {
            return true;
          }
          this->Cells.UndoTo(start);
        }
      }
    }
    return false;
  }

  /// Joins a triangle with another one over a strip of at most this cost; returns whether it did.
  /// The cheapest strips are tried first (Dijkstra), entering faces over each of their edges.
  bool JoinAsItIs(Index triangle, Index farthest, double wanted)
  {
    int partners = 0;
    using Arrival = std::pair<Index, Index>;
    std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> front;
    this->Seen[triangle] = ++this->Stamp;
    this->Cost[triangle] = 0;
    front.emplace(0, triangle);
    while (!front.empty() && front.top().first <= farthest)
    {
      const auto [cost, f] = front.top();
      front.pop();
      const Faces::Face face = this->Cells.Face(f);
      const int size = Faces::Size(face);
      for (int c = 0; cost == this->Cost[f] && c < size; ++c)
      {
        const Index g = this->Beyond(f, face[c], face[(c + 1) % size]);
        const bool isQuad = g != None && Faces::Size(this->Cells.Face(g)) == 4;
        const Index there = cost + (isQuad ? this->CostOfPassing(g) : 1);
        if (g == None || g == triangle ||
          (isQuad && this->Seen[g] == this->Stamp && this->Cost[g] <= there))
        {
          continue;
        }
        this->From[g] = f;
        this->Cost[g] = there;
        if (isQuad)
        {
          this->Seen[g] = this->Stamp;
          front.emplace(there, g);
        }
        else if (this->Try(this->WayTo(g), wanted))
        {
          return true;
        }
        else if (++partners == MostWays)
        {
          return false;
        }
      }
    }
    return false;
  }

private:
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

  std::vector<Index> WayTo(Index f) const
  {
    std::vector<Index> path = { f };
    while (this->Cost[path.back()] > 0)
    {
      path.push_back(this->From[path.back()]);
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  /// Chords of a strip that cut it into quads. Or, where two triangles share an edge, the end of
  /// that edge that is merged with the other one.
  struct Cut
  {
    std::vector<FaceStrip::Chord> Chords;
    int Grown = 0;
    Index Goes = None;
    Index Stays = None;
  };

  /// By how much the irregularity grows.
  int Growth(const FaceStrip& strip, const std::vector<FaceStrip::Chord>& chords) const
  {
    std::vector<Index> more(strip.GetPolygon().size(), 0);
    for (const FaceStrip::Chord& edge : strip.GetEdges())
    {
      --more[edge[0]];
      --more[edge[1]];
    }
    for (const FaceStrip::Chord& chord : chords)
    {
      ++more[chord[0]];
      ++more[chord[1]];
    }
    int grown = 0;
    for (std::size_t k = 0; k < more.size(); ++k)
    {
      const Index v = strip.GetPolygon()[k];
      grown += this->Edits.Irregularity(v, more[k]) - this->Edits.Irregularity(v);
    }
    return grown;
  }

  std::vector<Cut> CutsOf(const FaceStrip& strip) const
  {
    std::vector<Cut> cuts;
    for (const std::vector<FaceStrip::Chord>& chords :
      { strip.Cheapest(this->Places.GetPoints()), strip.Shifted(true), strip.Shifted(false) })
    {
      const bool isNew = std::none_of(
        cuts.begin(), cuts.end(), [&](const Cut& other) { return other.Chords == chords; });
      if (isNew && chords.size() + 1 == strip.GetEdges().size())
      {
        cuts.push_back({ chords, this->Growth(strip, chords) });
      }
    }
    if (strip.GetEdges().size() == 1)
    {
      const Index right = strip.GetPolygon()[strip.GetEdges()[0][0]];
      const Index left = strip.GetPolygon()[strip.GetEdges()[0][1]];
      for (const FaceEdits::Edit& edit :
        { FaceEdits::Edit{ left, right, None }, FaceEdits::Edit{ right, left, None } })
      {
        const int grown = this->Edits.GrowthBy(edit) + 2 * FaceEdits::PerTriangle;
        cuts.push_back({ {}, grown, edit.First, edit.Second });
      }
    }
    std::stable_sort(
      cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.Grown < b.Grown; });
    return cuts;
  }

  /// Joins the triangles at the ends of a strip by the first cut that leaves good faces, or else,
  /// if any is allowed, by the one that leaves the best ones.
  bool Try(const std::vector<Index>& path, double wanted)
  {
    const FaceStrip strip(this->Cells, path);
    if (!strip.IsSimple())
    {
      return false;
    }
    const std::size_t start = this->Cells.GetChanges().size();
    const std::vector<Vector3> before = this->PlacesOf(strip);
    const bool isAnyGood = wanted <= 0.0;
    const double least = isAnyGood ? Wanted[0] : wanted;
    const Cut* best = nullptr;
    double most = -1.0;
    const std::vector<Cut> cuts = this->CutsOf(strip);
    for (const Cut& cut : cuts)
    {
      const std::size_t size = strip.GetPolygon().size();
      if (cut.Grown <= this->MostGrown && size <= this->MovesLeft && this->Do(path, strip, cut))
      {
        this->MovesLeft -= size;
        this->Places.Relax(strip.GetPolygon(), Moves);
        const double quality = this->LeastQuality(strip);
        if (quality >= least)
        {
          return true;
        }
        if (best == nullptr || quality > most)
        {
          best = &cut;
          most = quality;
        }
        this->PutBack(strip, before);
      }
      this->Cells.UndoTo(start);
    }
    if (!isAnyGood || best == nullptr)
    {
      return false;
    }
    this->Do(path, strip, *best);
    this->Places.Relax(strip.GetPolygon(), Moves);
    return true;
  }

  std::vector<Vector3> PlacesOf(const FaceStrip& strip) const
  {
    std::vector<Vector3> places;
    for (const Index v : strip.GetPolygon())
    {
      places.push_back(this->Places.GetPoints()[v]);
    }
    return places;
  }

  void PutBack(const FaceStrip& strip, const std::vector<Vector3>& places)
  {
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      this->Places.GetPoints()[strip.GetPolygon()[k]] = places[k];
    }
  }

  double LeastQuality(const FaceStrip& strip) const
  {
    double least = 1.0;
    for (const Index v : strip.GetPolygon())
    {
      least = std::min(least, this->Places.LeastQuality(v));
    }
    return least;
  }

  /// Replaces the faces of a strip by quads; returns false if the mesh would not stay manifold.
  bool Do(const std::vector<Index>& path, const FaceStrip& strip, const Cut& cut)
  {
    if (cut.Goes != None)
    {
      return this->Edits.Do({ cut.Goes, cut.Stays, None }) && this->TakeOutDoublets(strip);
    }
    for (const Index f : path)
    {
      this->Cells.Set(f, Nothing);
    }
    const std::vector<Index>& polygon = strip.GetPolygon();
    FaceStrip::Chord before = strip.Whole();
    for (std::size_t k = 0; k < cut.Chords.size(); ++k)
    {
      const FaceStrip::Chord& chord = cut.Chords[k];
      if (this->Cells.AreJoined(polygon[chord[0]], polygon[chord[1]]))
      {
        return false;
      }
      this->Cells.Set(path[k], strip.Between(before, chord));
      before = chord;
    }
    this->Cells.Set(path[cut.Chords.size()], strip.Beyond(before));
    return this->TakeOutDoublets(strip);
  }

  /// Merges two quads that share two edges into one; returns false if a vertex has too few faces
  /// nevertheless.
  bool TakeOutDoublets(const FaceStrip& strip)
  {
    std::vector<Index> vertices = strip.GetPolygon();
    for (std::size_t k = 0; k < vertices.size(); ++k)
    {
      const Index v = vertices[k];
      const std::vector<Index> star = this->Cells.At(v);
      if (star.empty() || this->Edits.HasEnoughFaces(v))
      {
        continue;
      }
      if (star.size() != 2 || !this->Places.IsOnSurface(v) ||
        Faces::Size(this->Cells.Face(star[0])) + Faces::Size(this->Cells.Face(star[1])) < 8)
      {
        return false;
      }
      // From v on.
      std::array<Faces::Face, 2> faces{};
      for (int i = 0; i < 2; ++i)
      {
        faces[i] = this->Cells.Face(star[i]);
        std::rotate(
          faces[i].begin(), std::find(faces[i].begin(), faces[i].end(), v), faces[i].end());
      }
      if (faces[0][1] != faces[1][3] || faces[0][3] != faces[1][1] || faces[0][2] == faces[1][2])
      {
        return false;
      }
      this->Cells.Set(star[0], { faces[1][2], faces[0][1], faces[0][2], faces[0][3] });
      this->Cells.Set(star[1], Nothing);
      vertices.insert(vertices.end(), { faces[0][1], faces[0][3] });
    }
    return true;
  }

  VertexStars& Cells;
  MovableFaces& Places;
  FaceEdits Edits;
  /// By how much irregularity may grow at most.
  int MostGrown;
  /// The number of vertices that may still be moved. Where faces are bad everywhere no strip is
  /// found.
  std::size_t MovesLeft;
  /// The last search that reached a face, the face before it on the strip, and the cost of the
  /// strip.
  std::vector<Index> Seen;
  std::vector<Index> From;
  std::vector<Index> Cost;
  Index Stamp = 0;
};
}

void JoinTriangles(VertexStars& faces, MovableFaces& places,
  const std::vector<FaceMesh::Vertex>& vertices, bool atAnyPrice, const Progress& progress)
{
  Pairs pairs(faces, places, WithoutLocks(RulesFor(faces, places, vertices)),
    atAnyPrice ? std::numeric_limits<int>::max() : 0);
  ;
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
  for (const double wanted : Wanted)
  {
    if (wanted < Wanted[0] && !atAnyPrice)
    {
      break;
    }
    for (Index farthest = 1; !left.empty() && farthest < anywhere; farthest *= 4)
    {
      joinEach([&](Index f) { pairs.JoinAsItIs(f, farthest, wanted); });
    }
    if (wanted < Wanted[0])
    {
      joinEach([&](Index f) { pairs.JoinAfterMove(f, anywhere, wanted); });
    }
  }
  progress.Report(1.0);
}
}
