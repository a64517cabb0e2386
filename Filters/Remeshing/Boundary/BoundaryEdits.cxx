// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Boundary/BoundaryEdits.h"

#include "Boundary/BoundaryMatch.h"
#include "FaceMesh/EditedMesh.h"
#include "FaceMesh/FaceCut.h"
#include "FaceMesh/FaceEdits.h"
#include "FaceMesh/VertexStars.h"
#include "Support/SortedEnds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
using Ends = std::array<Index, 2>;
using Place = std::array<double, 3>;

Place PlaceOf(const Vector3& p)
{
  return { p.x(), p.y(), p.z() };
}

/// A side whose vertices are to be points of its line.
struct Matched
{
  Index Line = None;
  std::vector<Index> Vertices;
  /// The points that they become, or None.
  std::vector<Index> Points;
};

std::vector<Matched> MatchedSides(
  const FaceMesh& mesh, const Surface& surface, const std::vector<BoundaryLine>& lines)
{
  std::vector<Matched> all;
  for (const BoundarySide& side : BoundarySidesOf(mesh, surface, lines))
  {
    std::vector<char> stays;
    for (std::size_t k = 0; k < side.Vertices.size(); ++k)
    {
      const double place = side.Places[k];
      const Vector3& at = mesh.Points[side.Vertices[k]];
      const BoundaryLine& line = lines[side.Line];
      // A corner of lines that is no point of the boundary moves to one.
      stays.push_back(mesh.Vertices[side.Vertices[k]].Line < 0 &&
            line.PositionAt(static_cast<Index>(std::lround(place))) == at
          ? 1
          : 0);
    }
    std::vector<Index> match = MatchBoundary(side, lines[side.Line], stays);
    if (!match.empty())
    {
      all.push_back({ side.Line, side.Vertices, std::move(match) });
    }
  }
  return all;
}

/// Merges the vertices that become no point with others of their sides.
void RemoveOthers(FaceMesh& mesh, std::vector<Matched>& sides)
{
  VertexStars stars(mesh.Cells, static_cast<Index>(mesh.Points.size()), mesh.LineEdges);
  std::vector<FaceEdits::Rule> rules(mesh.Points.size());
  for (std::size_t v = 0; v < rules.size(); ++v)
  {
    rules[v].IsBoundary = mesh.Vertices[v].IsBoundary;
    rules[v].IsOnLine = rules[v].IsBoundary || mesh.Vertices[v].Line != 0;
    rules[v].IsFree = false;
    rules[v].MayLeaveLine = mesh.Vertices[v].Line > 0;
  }
  FaceEdits edits(stars, std::move(rules));
  for (const Matched& side : sides)
  {
    for (std::size_t k = 0; k < side.Vertices.size(); ++k)
    {
      const Index v = side.Vertices[k];
      if (side.Points[k] != None)
      {
        continue;
      }
      std::vector<Index> next = stars.LineEnds(v);
      std::stable_sort(next.begin(), next.end(),
        [&](Index a, Index b)
        {
          return (mesh.Points[a] - mesh.Points[v]).squaredNorm() <
            (mesh.Points[b] - mesh.Points[v]).squaredNorm();
        });
      for (const Index stays : next)
      {
        if (edits.Do({ v, stays, None }))
        {
          break;
        }
      }
    }
  }
  if (stars.GetChanges().empty())
  {
    return;
  }
  const std::vector<Index> number = TakeOver(stars, mesh);
  for (Matched& side : sides)
  {
    Matched left;
    left.Line = side.Line;
    for (std::size_t k = 0; k < side.Vertices.size(); ++k)
    {
      if (number[side.Vertices[k]] != None)
      {
        left.Vertices.push_back(number[side.Vertices[k]]);
        left.Points.push_back(side.Points[k]);
      }
    }
    side = std::move(left);
  }
}

/// Splits edges of the boundary.
class Splitter
{
public:
  explicit Splitter(FaceMesh& mesh)
    : Mesh(mesh)
  {
    for (std::size_t f = 0; f < mesh.Cells.Corners.size(); ++f)
    {
      this->ForEdges(static_cast<Index>(f),
        [&](const Ends& ends)
        {
          const auto [found, isNew] = this->FaceAt.emplace(ends, static_cast<Index>(f));
          found->second = isNew ? found->second : None;
        });
    }
    for (std::size_t k = 0; k < mesh.LineEdges.size(); ++k)
    {
      const Ends& ends = mesh.LineEdges[k].Ends;
      this->LineAt.emplace(SortedEnds(ends[0], ends[1]), k);
    }
  }

  /// Returns the new vertex, or None where the edge is no edge of one face.
  Index Split(Index a, Index b, const Vector3& place)
  {
    const Ends ends = SortedEnds(a, b);
    const auto at = this->FaceAt.find(ends);
    const auto line = this->LineAt.find(ends);
    if (at == this->FaceAt.end() || at->second == None || line == this->LineAt.end())
    {
      return None;
    }
    const auto fresh = static_cast<Index>(this->Mesh.Points.size());
    const Index f = at->second;
    const FaceParts parts = CutAtEdge(this->Mesh.Points, this->Mesh.Cells.Corners[f], ends, place);
    const auto other = static_cast<Index>(this->Mesh.Cells.Corners.size());
    this->Mesh.Cells.Corners[f] = parts.First;
    this->Mesh.Cells.IsRegular[f] = 0;
    this->Mesh.Cells.Corners.push_back(parts.Second);
    this->Mesh.Cells.IsRegular.push_back(0);
    this->Mesh.Points.push_back(place);
    FaceMesh::Vertex vertex;
    vertex.IsBoundary = true;
    vertex.Line = this->Mesh.LineEdges[line->second].Line;
    this->Mesh.Vertices.push_back(vertex);
    this->FaceAt.erase(at);
    for (const Index part : { f, other })
    {
      this->ForEdges(part,
        [&](const Ends& edge)
        {
          const auto found = this->FaceAt.find(edge);
          const bool isNew = edge[1] == fresh && (edge[0] == a || edge[0] == b);
          if (isNew || (found != this->FaceAt.end() && found->second == f))
          {
            this->FaceAt[edge] = part;
          }
        });
    }
    const std::size_t number = line->second;
    this->LineAt.erase(line);
    this->Mesh.LineEdges[number].Ends = { a, fresh };
    this->LineAt.emplace(SortedEnds(a, fresh), number);
    this->LineAt.emplace(SortedEnds(fresh, b), this->Mesh.LineEdges.size());
    this->Mesh.LineEdges.push_back({ { fresh, b }, vertex.Line });
    return fresh;
  }

private:
  template <typename Body>
  void ForEdges(Index f, const Body& body) const
  {
    const Faces::Face face = this->Mesh.Cells.Corners[f];
    const int size = Faces::Size(face);
    for (int c = 0; c < size; ++c)
    {
      body(SortedEnds(face[c], face[(c + 1) % size]));
    }
  }

  FaceMesh& Mesh;
  /// The face at each edge that only one has, None for others.
  std::map<Ends, Index> FaceAt;
  std::map<Ends, std::size_t> LineAt;
};

/// The vertex stays where it is until Release.
void Hold(FaceMesh::Vertex& vertex)
{
  if (vertex.Line > 0)
  {
    vertex.Held = vertex.Line;
    vertex.Line = -1;
  }
}

/// The parts of a side between vertices that stay, as ranges of its vertices. A closed side without
/// any is one part.
std::vector<std::array<std::size_t, 2>> PartsOf(const FaceMesh& mesh, const BoundarySide& side)
{
  std::vector<std::array<std::size_t, 2>> parts;
  std::size_t first = 0;
  for (std::size_t k = 1; k < side.Vertices.size(); ++k)
  {
    if (mesh.Vertices[side.Vertices[k]].Line < 0 || k + 1 == side.Vertices.size())
    {
      parts.push_back({ first, k });
      first = k;
    }
  }
  return parts;
}

/// Lengths of edges relative to the sizes in their middles.
class RelativeLength
{
public:
  RelativeLength(const BoundaryLine& line, const std::vector<double>& sizes)
    : Line(line)
    , Sizes(sizes)
  {
  }
  double Between(double from, double to) const
  {
    const double length = (this->Line.PositionAt(to) - this->Line.PositionAt(from)).norm();
    return this->Sizes.empty() ? length
                               : length / this->Line.ValueAt(0.5 * (from + to), this->Sizes);
  }

private:
  const BoundaryLine& Line;
  const std::vector<double>& Sizes;
};

/// Moves lengths along a line all alike, so that they are at those given in the mean.
void ShiftTo(const std::vector<double>& given, std::vector<double>& arcs)
{
  double shift = 0.0;
  for (std::size_t k = 1; k < arcs.size(); ++k)
  {
    shift += (given[k] - arcs[k]) / static_cast<double>(arcs.size() - 1);
  }
  for (double& arc : arcs)
  {
    arc += shift;
  }
}

/// Makes the distances of places, one after the other, the same.
/// @param isAround the last place is the first one, which need not stay where it is: vertices that
///                 came closer to each other by chance there would turn all others else
void EvenOut(const BoundaryLine& line, const RelativeLength& length, bool isAround,
  std::vector<double>& places)
{
  constexpr int rounds = 30;
  constexpr int shifts = 3;
  const std::size_t edges = places.size() - 1;
  std::vector<double> arcs;
  for (const double place : places)
  {
    arcs.push_back(line.LengthTo(place));
  }
  std::sort(arcs.begin(), arcs.end());
  const std::vector<double> given = arcs;
  for (int round = 0; round < rounds; ++round)
  {
    // Distances along a line that bends are not those in space, and differ by the shift.
    if (isAround && round > 0 && round % (rounds / shifts) == 0)
    {
      ShiftTo(given, arcs);
    }
    std::vector<double> sums = { 0.0 };
    for (std::size_t k = 0; k < edges; ++k)
    {
      sums.push_back(
        sums.back() + length.Between(line.PlaceAt(arcs[k]), line.PlaceAt(arcs[k + 1])));
    }
    std::vector<double> even = arcs;
    for (std::size_t k = 1, at = 0; k < edges; ++k)
    {
      const double wanted = sums.back() * static_cast<double>(k) / static_cast<double>(edges);
      while (at + 1 < edges && sums[at + 1] < wanted)
      {
        ++at;
      }
      const double step = sums[at + 1] - sums[at];
      even[k] =
        arcs[at] + (step > 0.0 ? (wanted - sums[at]) / step : 0.5) * (arcs[at + 1] - arcs[at]);
    }
    arcs = std::move(even);
  }
  for (std::size_t k = 0; k <= edges; ++k)
  {
    places[k] = line.PlaceAt(arcs[k]);
  }
}
}

void TakeBoundary(FaceMesh& mesh, const Surface& surface, const std::vector<BoundaryLine>& lines)
{
  std::vector<Matched> sides = MatchedSides(mesh, surface, lines);
  RemoveOthers(mesh, sides);
  Splitter splitter(mesh);
  for (const Matched& side : sides)
  {
    const BoundaryLine& line = lines[side.Line];
    Index before = None;
    Index last = None;
    for (std::size_t k = 0; k < side.Vertices.size(); ++k)
    {
      const Index v = side.Vertices[k];
      const Index point = side.Points[k];
      for (Index i = last + 1; last != None && point != None && i < point; ++i)
      {
        const Index fresh = splitter.Split(before, v, line.PositionAt(i));
        if (fresh != None)
        {
          Hold(mesh.Vertices[fresh]);
          before = fresh;
        }
      }
      if (point != None)
      {
        mesh.Points[v] = line.PositionAt(point);
        Hold(mesh.Vertices[v]);
        last = point;
      }
      before = v;
    }
  }
}

void SpaceBoundary(FaceMesh& mesh, const Surface& surface, const std::vector<BoundaryLine>& lines,
  const std::vector<double>& sizes, bool stay)
{
  for (const BoundarySide& side : BoundarySidesOf(mesh, surface, lines))
  {
    const BoundaryLine& line = lines[side.Line];
    const RelativeLength length(line, sizes);
    for (const auto& [first, last] : PartsOf(mesh, side))
    {
      std::vector<double> places(side.Places.begin() + static_cast<std::ptrdiff_t>(first),
        side.Places.begin() + static_cast<std::ptrdiff_t>(last) + 1);
      const Index start = side.Vertices[first];
      const bool isAround = start == side.Vertices[last] && mesh.Vertices[start].Line > 0;
      EvenOut(line, length, isAround, places);
      for (std::size_t k = isAround ? first : first + 1; k < last; ++k)
      {
        mesh.Points[side.Vertices[k]] = line.PositionAt(places[k - first]);
      }
    }
    for (const Index v : side.Vertices)
    {
      if (stay)
      {
        Hold(mesh.Vertices[v]);
      }
    }
  }
}

void Release(FaceMesh& mesh)
{
  for (FaceMesh::Vertex& vertex : mesh.Vertices)
  {
    vertex.Line = vertex.Held > 0 ? std::exchange(vertex.Held, 0) : vertex.Line;
  }
}

BoundaryCount::BoundaryCount(
  const FaceMesh& mesh, const Surface& surface, const std::vector<BoundaryLine>& lines)
{
  std::set<Place> points;
  for (const BoundaryLine& line : lines)
  {
    for (const Index p : line.GetPoints())
    {
      points.insert(PlaceOf(surface.Points[p]));
    }
  }
  std::map<Ends, int> times;
  for (const Faces::Face& face : mesh.Cells.Corners)
  {
    const int size = Faces::Size(face);
    for (int c = 0; c < size; ++c)
    {
      ++times[SortedEnds(face[c], face[(c + 1) % size])];
    }
  }
  std::set<Place> vertices;
  for (const auto& [ends, faces] : times)
  {
    for (const Index v : ends)
    {
      if (faces == 1)
      {
        vertices.insert(PlaceOf(mesh.Points[v]));
      }
    }
  }
  this->Points = static_cast<Index>(points.size());
  for (const Place& place : vertices)
  {
    const bool isPoint = points.count(place) > 0;
    this->Kept += isPoint ? 1 : 0;
    this->Others += isPoint ? 0 : 1;
  }
}

double UnevennessOf(const FaceMesh& mesh, const Surface& surface,
  const std::vector<BoundaryLine>& lines, const std::vector<double>& sizes)
{
  double worst = 0.0;
  for (const BoundarySide& side : BoundarySidesOf(mesh, surface, lines))
  {
    const BoundaryLine& line = lines[side.Line];
    const RelativeLength length(line, sizes);
    for (const auto& [first, last] : PartsOf(mesh, side))
    {
      double sum = 0.0;
      double squares = 0.0;
      for (std::size_t k = first; k < last; ++k)
      {
        const double own = length.Between(side.Places[k], side.Places[k + 1]);
        sum += own;
        squares += own * own;
      }
      const auto count = static_cast<double>(last - first);
      const double mean = sum / count;
      const double variance = std::max(0.0, squares / count - mean * mean);
      worst = mean > 0.0 ? std::max(worst, std::sqrt(variance) / mean) : worst;
    }
  }
  return worst;
}
}
