// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PureQuads/FaceStrip.h"

#include <algorithm>
#include <limits>

namespace DirectionFields::Internal
{
namespace
{
/// Penalty for a flat corner: its edges are parts of lines, and the cosine between them is above
/// this. A quad whose scaled Jacobian is 0 has a penalty of 1.
constexpr double Flat = 0.9;
constexpr double PerFlatCorner = 50.0;
}

bool HasEdge(const Faces::Face& face, Index tail, Index head)
{
  const int size = Faces::Size(face);
  bool has = false;
  for (int c = 0; c < size; ++c)
  {
    has = has || (face[c] == tail && face[(c + 1) % size] == head);
  }
  return has;
}

FaceStrip::FaceStrip(const VertexStars& faces, const std::vector<Index>& path)
  : Cells(faces)
{
  std::vector<std::array<Index, 2>> ends;
  for (std::size_t k = 0; k + 1 < path.size(); ++k)
  {
    ends.push_back(this->EdgeBetween(path[k], path[k + 1]));
  }
  const std::size_t count = ends.size();
  this->Walk(path[0], ends[0][1], ends[0][0]);
  // The left end of the first edge is to be the last one.
  this->Polygon.erase(this->Polygon.begin());
  this->Edges.resize(count);
  for (std::size_t k = 0; k < count; ++k)
  {
    this->Edges[k][0] = this->Polygon.size();
    this->Walk(path[k + 1], ends[k][0], k + 1 < count ? ends[k + 1][0] : ends[k][1]);
  }
  for (std::size_t k = count - 1; k > 0; --k)
  {
    this->Edges[k][1] = this->Polygon.size();
    this->Walk(path[k], ends[k][1], ends[k - 1][1]);
  }
  this->Edges[0][1] = this->Polygon.size();
  this->Polygon.push_back(ends[0][1]);
}

/// The edge from a face to the next one, as the former has it.
std::array<Index, 2> FaceStrip::EdgeBetween(Index f, Index g) const
{
  const Faces::Face& face = this->Cells.Face(f);
  const int size = Faces::Size(face);
  for (int c = 0; c < size; ++c)
  {
    const Index tail = face[c];
    const Index head = face[(c + 1) % size];
    if (!this->Cells.IsLineEdge(tail, head) && HasEdge(this->Cells.Face(g), head, tail))
    {
      return { tail, head };
    }
  }
  return { face[0], face[1] };
}

/// Appends the corners of a face from one on to another one, without the latter.
void FaceStrip::Walk(Index f, Index from, Index to)
{
  const Faces::Face& face = this->Cells.Face(f);
  const int size = Faces::Size(face);
  auto c = static_cast<int>(std::find(face.begin(), face.end(), from) - face.begin());
  for (; face[c] != to; c = (c + 1) % size)
  {
    this->Polygon.push_back(face[c]);
  }
}

bool FaceStrip::IsSimple() const
{
  std::vector<Index> sorted = this->Polygon;
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
}

Faces::Face FaceStrip::Between(const Chord& one, const Chord& other) const
{
  Faces::Face quad{};
  int size = 0;
  for (std::size_t k = one[0]; k <= other[0]; ++k)
  {
    quad[size++] = this->Polygon[k];
  }
  for (std::size_t k = other[1]; k <= one[1]; ++k)
  {
    quad[size++] = this->Polygon[k];
  }
  return quad;
}

Faces::Face FaceStrip::Beyond(const Chord& last) const
{
  Faces::Face quad{};
  std::copy_n(
    this->Polygon.begin() + static_cast<std::ptrdiff_t>(last[0]), quad.size(), quad.begin());
  return quad;
}

std::vector<FaceStrip::Chord> FaceStrip::Shifted(bool isRight) const
{
  std::vector<Chord> chords;
  for (std::size_t k = 0; k + 1 < this->Edges.size(); ++k)
  {
    chords.push_back(
      { this->Edges[k][0] + (isRight ? 1 : 0), this->Edges[k][1] - (isRight ? 0 : 1) });
  }
  return chords;
}

/// Small for a quad that already is nearly a rectangle, large for a corner that would stay flat.
double FaceStrip::CostOf(const Faces::Face& quad, const std::vector<Vector3>& points) const
{
  const double lacking = 1.0 - ScaledJacobian(points, quad);
  double cost = lacking * lacking;
  for (int c = 0; c < 4; ++c)
  {
    const Index before = quad[(c + 3) % 4];
    const Index after = quad[(c + 1) % 4];
    const Vector3 from = points[quad[c]] - points[before];
    const Vector3 to = points[after] - points[quad[c]];
    const bool isFlat = to.dot(from) > Flat * to.norm() * from.norm();
    const bool isOnLine =
      this->Cells.IsLineEdge(before, quad[c]) && this->Cells.IsLineEdge(quad[c], after);
    cost += isFlat && isOnLine ? PerFlatCorner : 0.0;
  }
  return cost;
}

/// By dynamic programming: each chord is two corners further than the one before it, on one side or
/// one on both.
std::vector<FaceStrip::Chord> FaceStrip::Cheapest(const std::vector<Vector3>& points) const
{
  struct State
  {
    double Cost;
    Chord At;
    std::size_t Before;
  };
  std::vector<std::vector<State>> states = { { { 0.0, this->Whole(), 0 } } };
  for (std::size_t k = 0; k + 1 < this->Edges.size(); ++k)
  {
    const Chord& here = this->Edges[k];
    const Chord& there = this->Edges[k + 1];
    std::vector<State> next;
    for (std::size_t before = 0; before < states[k].size(); ++before)
    {
      const State& state = states[k][before];
      for (std::size_t right = 0; right <= 2; ++right)
      {
        const Chord at = { state.At[0] + right, state.At[1] - (2 - right) };
        if (at[0] + 1 < here[0] || at[0] > there[0] + 1 || at[1] > here[1] + 1 ||
          at[1] + 1 < there[1])
        {
          continue;
        }
        const double cost = state.Cost + this->CostOf(this->Between(state.At, at), points);
        const auto same = std::find_if(
          next.begin(), next.end(), [&](const State& other) { return other.At == at; });
        if (same == next.end())
        {
          next.push_back({ cost, at, before });
        }
        else if (cost < same->Cost)
        {
          *same = { cost, at, before };
        }
      }
    }
    states.push_back(std::move(next));
  }
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < states.back().size(); ++k)
  {
    const State& state = states.back()[k];
    const double cost = state.Cost + this->CostOf(this->Beyond(state.At), points);
    if (cost < least)
    {
      best = k;
      least = cost;
    }
  }
  std::vector<Chord> chords;
  for (std::size_t k = states.size() - 1; k > 0 && !states[k].empty(); --k)
  {
    chords.push_back(states[k][best].At);
    best = states[k][best].Before;
  }
  std::reverse(chords.begin(), chords.end());
  return chords;
}
}
