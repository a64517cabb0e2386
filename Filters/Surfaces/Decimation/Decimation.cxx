// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Decimation/Decimation.h"

#include "Support/Threads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace DirectionFields::Internal
{
namespace
{
/// A triangle takes that of more edges too long to be worth it.
constexpr std::size_t MostNeighbours = 24;
/// The cosine of the largest angle by which new triangles may be turned.
constexpr double LeastCosine = 0.5;
/// The cosine of the sharpest turn of a feature that may vanish: corners stay.
constexpr double LeastTurn = 0.85;
/// The least quality, area over the sum of squared sides: slivers are worse.
constexpr double LeastQuality = 0.14;
/// Edges become longer by and by, so that triangles of the same size come about everywhere.
constexpr double Growth = 1.2;
}

struct Decimation::Star
{
  /// The outgoing half-edges counter-clockwise, and the vertices around; one more of these on the
  /// boundary.
  std::vector<Index> Edges;
  std::vector<Index> Ring;
  std::vector<Vector3> Places;
  /// Area vectors of the triangles, and how good the worst of them is.
  std::vector<Vector3> Normals;
  double WorstQuality = 1.0;
  bool IsOpen = false;
  /// Which of its edges may be collapsed, the best first; the negative quality of each.
  std::vector<std::pair<double, std::size_t>> Candidates;
};

Decimation::Decimation(const TriangleMesh& mesh, const std::vector<Vector3>& positions,
  const std::vector<char>& isFeature, const Limits& limits)
  : Positions(positions)
  , Limit(limits)
  , Corners(mesh.GetNumberOfHalfEdges())
  , Twins(mesh.GetNumberOfHalfEdges())
  , Outgoing(mesh.GetNumberOfVertices())
  , IsFeature(mesh.GetNumberOfHalfEdges())
  , Kinds(mesh.GetNumberOfVertices(), Kind::Free)
  , IsNew(mesh.GetNumberOfVertices(), 1)
  , Moved(mesh.GetNumberOfTriangles(), 0.0F)
  , FeatureMoved(mesh.GetNumberOfHalfEdges(), 0.0F)
{
  ParallelFor(mesh.GetNumberOfHalfEdges(), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index h = begin; h < end; ++h)
      {
        this->Corners[h] = mesh.Tail(h);
        this->Twins[h] = mesh.Twin(h);
        this->IsFeature[h] = mesh.Twin(h) == None || isFeature[mesh.Edge(h)] != 0 ? 1 : 0;
      }
    });
  ParallelFor(mesh.GetNumberOfVertices(), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        this->Outgoing[v] = mesh.Outgoing(v);
      }
    });
  const Index edges = mesh.GetNumberOfEdges();
  this->MeanLength = ParallelSum(edges, MediumPiece, 0.0,
                       [&](Index begin, Index end)
                       {
                         double sum = 0.0;
                         for (Index e = begin; e < end; ++e)
                         {
                           const Index h = mesh.HalfEdge(e);
                           sum += (positions[mesh.Head(h)] - positions[mesh.Tail(h)]).norm() /
                             this->Longest(mesh.Tail(h));
                         }
                         return sum;
                       }) /
    std::max<Index>(1, edges);
  this->FindKinds(mesh);
  this->FindApart(mesh);
}

void Decimation::Run(const Progress& progress)
{
  const auto vertices = static_cast<Index>(this->Outgoing.size());
  const double start = std::min(1.0, Growth * this->MeanLength);
  const auto stages =
    1 + static_cast<int>(std::ceil(std::log(1.0 / start) / std::log(Growth) - 1e-9));
  // Two sweeps of each length, the blocks of which overlap, and some more of the last.
  constexpr int more = 4;
  const int sweeps = 2 * stages + more;
  Index left = vertices;
  for (int k = 0; k < sweeps; ++k)
  {
    const double part = std::pow(Growth, std::min(0, k / 2 - stages + 1));
    const Index shift = k % 2 == 0 ? 0 : BlockSize / 2;
    const Index blocks = NumberOfPieces(vertices + shift, BlockSize);
    if (k % 2 == 0 && k < 2 * stages)
    {
      // Edges that were too long may be allowed now.
      std::fill(this->IsNew.begin(), this->IsNew.end(), 1);
    }
    std::vector<Index> collapses(blocks, 0);
    Threads::Run(blocks,
      [&](Index block)
      {
        collapses[block] = this->Sweep(std::max(0, block * BlockSize - shift),
          std::min(vertices, (block + 1) * BlockSize - shift), part);
      });
    Index sum = 0;
    for (const Index c : collapses)
    {
      sum += c;
    }
    sum += this->SweepApart(part);
    left -= sum;
    progress.Report(static_cast<double>(k + 1) / sweeps);
    if (k >= 2 * stages && sum < left / 100)
    {
      break;
    }
  }
}

bool Decimation::FindStar(Index v, Index begin, Index end, Star& star) const
{
  star.Edges.clear();
  star.Ring.clear();
  star.Places.clear();
  star.Normals.clear();
  star.WorstQuality = 1.0;
  const Index any = this->Outgoing[v];
  Index first = any;
  std::size_t steps = 0;
  while (this->Twins[first] != None)
  {
    first = Next(this->Twins[first]);
    if (first == any || ++steps > MostNeighbours)
    {
      break;
    }
  }
  star.IsOpen = this->Twins[first] == None;
  Index h = first;
  do
  {
    const Index w = this->Corners[Next(h)];
    if (w < begin || w >= end || star.Edges.size() == MostNeighbours)
    {
      return false;
    }
    star.Edges.push_back(h);
    star.Ring.push_back(w);
    h = this->Twins[Previous(h)];
  } while (h != None && h != first);
  if (star.IsOpen)
  {
    const Index w = this->Corners[Previous(star.Edges.back())];
    if (w < begin || w >= end)
    {
      return false;
    }
    star.Ring.push_back(w);
  }
  for (const Index w : star.Ring)
  {
    star.Places.push_back(this->Positions[w]);
  }
  const Vector3& p = this->Positions[v];
  for (std::size_t k = 0; k < star.Edges.size(); ++k)
  {
    const Vector3 a = star.Places[k] - p;
    const Vector3 b = star.Places[(k + 1) % star.Places.size()] - p;
    star.Normals.emplace_back(a.cross(b));
    const double squares = a.squaredNorm() + b.squaredNorm() + (b - a).squaredNorm();
    star.WorstQuality = std::min(star.WorstQuality, star.Normals.back().norm() / squares);
  }
  return true;
}

double Decimation::Quality(Index v, const Star& star, std::size_t i, double part) const
{
  constexpr double refused = -1.0;
  const std::size_t size = star.Ring.size();
  const Index w = star.Ring[i];
  const Vector3& q = star.Places[i];
  const double length = part * std::min(this->Longest(v), this->Longest(w));
  for (std::size_t k = 0; k < size; ++k)
  {
    if ((star.Places[k] - q).squaredNorm() > length * length)
    {
      return refused;
    }
  }
  const Vector3 step = this->Positions[v] - q;
  const double most = this->Limit.Deviation * this->Limit.EdgeLength[v];
  double least = 1.0;
  for (std::size_t k = 0; k < star.Edges.size(); ++k)
  {
    const std::size_t next = (k + 1) % size;
    if (k == i || next == i)
    {
      continue;
    }
    const Vector3 a = star.Places[k] - q;
    const Vector3 b = star.Places[next] - q;
    const Vector3 normal = a.cross(b);
    const double area = normal.norm();
    const double squares = a.squaredNorm() + b.squaredNorm() + (b - a).squaredNorm();
    if (!(area > 0.0) ||
      normal.dot(star.Normals[k]) < LeastCosine * area * star.Normals[k].norm() ||
      std::abs(normal.dot(step)) > area * (most - this->Moved[star.Edges[k] / 3]))
    {
      return refused;
    }
    least = std::min(least, area / squares);
  }
  return least < std::min(LeastQuality, star.WorstQuality) ? refused : least;
}

std::size_t Decimation::MarkNeighbours(Index w, const Star& star, char* isNeighbour) const
{
  std::size_t count = 0;
  const auto meet = [&](Index x)
  {
    for (std::size_t k = 0; k < star.Ring.size(); ++k)
    {
      if (star.Ring[k] == x)
      {
        isNeighbour[k] = 1;
        ++count;
      }
    }
  };
  const Index any = this->Outgoing[w];
  Index h = any;
  bool isOpen = false;
  do
  {
    meet(this->Corners[Next(h)]);
    isOpen = this->Twins[h] == None;
    h = isOpen ? None : Next(this->Twins[h]);
  } while (h != None && h != any);
  if (isOpen)
  {
    // The walk went clockwise as far as it could; the rest lies counter-clockwise.
    h = any;
    while (h != None)
    {
      const Index last = this->Corners[Previous(h)];
      h = this->Twins[Previous(h)];
      // The first half-edge was met already; where the fan ends there is one vertex more.
      meet(last);
    }
  }
  return count;
}

bool Decimation::KeepsTopology(Index v, const Star& star, std::size_t i) const
{
  const std::size_t size = star.Ring.size();
  const Index w = star.Ring[i];
  const bool isOuter = star.IsOpen && (i == 0 || i + 1 == size);
  if (star.IsOpen && (!isOuter || star.Edges.size() < 2))
  {
    return false;
  }
  // Of three triangles one is left, which may be there already.
  if (!star.IsOpen && size == 3)
  {
    for (const Index h : star.Edges)
    {
      const Index outer = this->Twins[Next(h)];
      if (outer != None && this->Corners[Previous(outer)] == w)
      {
        return false;
      }
    }
  }
  if (this->Kinds[v] == Kind::OnFeature &&
    !(this->FeatureMovedTo(v, star, i) <= this->Limit.Deviation * this->Limit.EdgeLength[v]))
  {
    return false;
  }
  // The common neighbours of v and w have to be corners of their triangles (T. Dey et al. 1999),
  // and w may only get neighbours that the kinds of the two allow.
  std::array<char, MostNeighbours + 1> isCommon{};
  const std::size_t common = this->MarkNeighbours(w, star, isCommon.data());
  if (common != (isOuter ? 1U : 2U))
  {
    return false;
  }
  for (std::size_t k = 0; k < size; ++k)
  {
    const Kind kind = this->Kinds[star.Ring[k]];
    const bool isAlong = this->Kinds[v] == Kind::OnFeature && this->IsOnFeature(star, k);
    // The two edges of a feature at v become one, which must not be there before.
    const bool isDoubled = isCommon[k] != 0 && isAlong;
    const bool joinsFixed = this->Kinds[w] == Kind::Fixed && kind == Kind::Fixed;
    // Where v is on a feature, too, its edge joins the two already.
    const bool joinsFeatures = !isAlong && this->Kinds[v] == Kind::Free &&
      this->Kinds[w] != Kind::Free && kind != Kind::Free;
    if (k != i && (isDoubled || (isCommon[k] == 0 && (joinsFixed || joinsFeatures))))
    {
      return false;
    }
  }
  return true;
}

bool Decimation::IsOnFeature(const Star& star, std::size_t k) const
{
  return k < star.Edges.size() ? this->IsFeature[star.Edges[k]] != 0 : star.IsOpen;
}

Index Decimation::EdgeTo(const Star& star, std::size_t k)
{
  return k < star.Edges.size() ? star.Edges[k] : Previous(star.Edges.back());
}

double Decimation::FeatureMovedTo(Index v, const Star& star, std::size_t i) const
{
  float before = 0.0F;
  for (std::size_t k = 0; k < star.Ring.size(); ++k)
  {
    if (this->IsOnFeature(star, k))
    {
      before = std::max(before, this->FeatureMoved[EdgeTo(star, k)]);
    }
  }
  return before + this->FeatureStep(v, star, i);
}

double Decimation::FeatureStep(Index v, const Star& star, std::size_t i) const
{
  for (std::size_t k = 0; k < star.Ring.size(); ++k)
  {
    if (k != i && this->IsOnFeature(star, k))
    {
      const Vector3 along = star.Places[i] - star.Places[k];
      const Vector3 own = this->Positions[v] - star.Places[k];
      const double s = own.dot(along) / along.squaredNorm();
      const Vector3 rest = along - own;
      if (s > 0.0 && s < 1.0 && own.dot(rest) >= LeastTurn * own.norm() * rest.norm())
      {
        return (own - s * along).norm();
      }
    }
  }
  return std::numeric_limits<double>::infinity();
}

Index Decimation::Sweep(Index begin, Index end, double part)
{
  Star star;
  Index collapses = 0;
  for (Index v = begin; v < end; ++v)
  {
    collapses += this->TryCollapse(v, begin, end, part, star) ? 1 : 0;
  }
  return collapses;
}

Index Decimation::SweepApart(double part)
{
  Star star;
  Index collapses = 0;
  for (const Index v : this->Apart)
  {
    const auto vertices = static_cast<Index>(this->Outgoing.size());
    collapses += this->TryCollapse(v, 0, vertices, part, star) ? 1 : 0;
  }
  return collapses;
}

bool Decimation::TryCollapse(Index v, Index begin, Index end, double part, Star& star)
{
  if (this->IsNew[v] == 0 || this->Outgoing[v] == None || this->Kinds[v] == Kind::Fixed ||
    !this->FindStar(v, begin, end, star))
  {
    return false;
  }
  this->IsNew[v] = 0;
  star.Candidates.clear();
  for (std::size_t i = 0; i < star.Ring.size(); ++i)
  {
    if (this->Kinds[v] == Kind::Free || this->IsOnFeature(star, i))
    {
      const double quality = this->Quality(v, star, i, part);
      if (quality > 0.0)
      {
        star.Candidates.emplace_back(-quality, i);
      }
    }
  }
  std::sort(star.Candidates.begin(), star.Candidates.end());
  for (const auto& [quality, i] : star.Candidates)
  {
    if (this->KeepsTopology(v, star, i))
    {
      this->Collapse(v, star, i);
      return true;
    }
  }
  return false;
}

void Decimation::Collapse(Index v, const Star& star, std::size_t i)
{
  const std::size_t size = star.Ring.size();
  const Index w = star.Ring[i];
  const Vector3 step = this->Positions[v] - star.Places[i];
  if (this->Kinds[v] == Kind::OnFeature)
  {
    const auto moved = static_cast<float>(this->FeatureMovedTo(v, star, i));
    for (std::size_t k = 0; k < size; ++k)
    {
      if (this->IsOnFeature(star, k))
      {
        const Index h = EdgeTo(star, k);
        this->FeatureMoved[h] = moved;
        if (this->Twins[h] != None)
        {
          this->FeatureMoved[this->Twins[h]] = moved;
        }
      }
    }
  }
  for (std::size_t k = 0; k < star.Edges.size(); ++k)
  {
    const Index h = star.Edges[k];
    if (k == i || (k + 1) % size == i)
    {
      continue;
    }
    this->Corners[h] = w;
    const Vector3 a = star.Places[k] - star.Places[i];
    const Vector3 b = star.Places[(k + 1) % size] - star.Places[i];
    const Vector3 normal = a.cross(b);
    this->Moved[h / 3] += static_cast<float>(std::abs(normal.dot(step)) / normal.norm());
    this->Outgoing[w] = h;
  }
  for (std::size_t k = 0; k < star.Edges.size(); ++k)
  {
    if (k != i && (k + 1) % size != i)
    {
      continue;
    }
    // The two other edges of a triangle that vanishes become one.
    const Index h = star.Edges[k];
    const Index inner = k == i ? Previous(h) : h;
    const Index outer = Next(h);
    // There is a triangle beyond the edge at v, since v is left with more than this one.
    const Index a = this->Twins[inner];
    const Index b = this->Twins[outer];
    const char isOn = this->IsFeature[inner] != 0 || this->IsFeature[outer] != 0 ? 1 : 0;
    const float moved = std::max(this->FeatureMoved[inner], this->FeatureMoved[outer]);
    this->Twins[a] = b;
    this->IsFeature[a] = isOn;
    this->FeatureMoved[a] = moved;
    this->Outgoing[this->Corners[a]] = a;
    this->Outgoing[this->Corners[Next(a)]] = Next(a);
    if (b != None)
    {
      this->Twins[b] = a;
      this->IsFeature[b] = isOn;
      this->FeatureMoved[b] = moved;
    }
    this->Corners[3 * (h / 3)] = None;
  }
  this->Outgoing[v] = None;
  for (const Index x : star.Ring)
  {
    this->IsNew[x] = 1;
  }
}
}
