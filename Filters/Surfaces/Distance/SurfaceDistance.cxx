// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/SurfaceDistance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// The distance of the third corner of a triangle laid flat, whose first two have distances a and b
/// from a source beyond the edge between them; infinite where the straight path there does not
/// cross that edge.
/// @param edge   squared length of that edge
/// @param toA, toB squared lengths of the edges from the two to the third corner
/// @param isCircle    whether fronts are circles where they can be
double Across(double a, double b, double edge, double toA, double toB, bool isCircle)
{
  const double length = std::sqrt(edge);
  // The first corner at 0, the second at (length, 0), the third above.
  const double x = 0.5 * (edge + toA - toB) / length;
  const double y = std::sqrt(std::max(0.0, toA - x * x));
  if (!(length > 0.0) || !(std::abs(a - b) < length))
  {
    return Infinity;
  }
  if (isCircle && a + b >= length)
  {
    const double sourceX = 0.5 * (edge + a * a - b * b) / length;
    const double sourceY = -std::sqrt(std::max(0.0, a * a - sourceX * sourceX));
    const double height = y - sourceY;
    if (!(height > 0.0))
    {
      return Infinity;
    }
    const double crossing = sourceX + (x - sourceX) * (-sourceY / height);
    return crossing >= 0.0 && crossing <= length ? std::hypot(x - sourceX, height) : Infinity;
  }
  // A straight front: distance grows by one a length along (slope, rise).
  const double slope = (b - a) / length;
  const double rise = std::sqrt(std::max(0.0, 1.0 - slope * slope));
  const double crossing = rise > 0.0 ? x - y * slope / rise : -1.0;
  return crossing >= 0.0 && crossing <= length ? a + slope * x + rise * y : Infinity;
}

/// A front that is on its way to a vertex.
struct Arrival
{
  double Distance;
  Index Vertex;
  Index Source;

  /// Sources and vertices decide between equal distances, so that the result does not depend on the
  /// queue.
  bool operator>(const Arrival& other) const
  {
    return std::tie(this->Distance, this->Vertex, this->Source) >
      std::tie(other.Distance, other.Vertex, other.Source);
  }
};
}

double SurfaceDistance::ToCorner(
  const IntrinsicGeometry& geometry, const MeshPlace& place, int corner)
{
  // The squared length of sum w_c P_c with weights that sum up to zero is -sum over pairs w_i w_j
  // |P_i - P_j|^2.
  std::array<double, 3> weights = place.Weights;
  weights[static_cast<std::size_t>(corner)] -= 1.0;
  double square = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const auto next = static_cast<std::size_t>((c + 1) % 3);
    const Index edge = geometry.Mesh.Edge(3 * place.Triangle + c);
    square -=
      weights[static_cast<std::size_t>(c)] * weights[next] * geometry.Lengths.SquaredLength[edge];
  }
  return std::sqrt(std::max(0.0, square));
}

void SurfaceDistance::AddSeeds(
  const IntrinsicGeometry& geometry, const MeshPlace& place, Index source, std::vector<Seed>& seeds)
{
  for (int c = 0; c < 3; ++c)
  {
    seeds.push_back(
      { geometry.Mesh.Tail(3 * place.Triangle + c), ToCorner(geometry, place, c), source });
  }
}

double SurfaceDistance::At(
  const IntrinsicGeometry& geometry, const MeshPlace& place, Index& source) const
{
  double nearest = Infinity;
  source = None;
  for (int c = 0; c < 3; ++c)
  {
    const Index vertex = geometry.Mesh.Tail(3 * place.Triangle + c);
    const double distance =
      this->Distance[static_cast<std::size_t>(vertex)] + ToCorner(geometry, place, c);
    if (distance < nearest)
    {
      nearest = distance;
      source = this->Source[static_cast<std::size_t>(vertex)];
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    // The front crosses the edge from this corner to the next one.
    const Index h = 3 * place.Triangle + c;
    const auto tail = static_cast<std::size_t>(geometry.Mesh.Tail(h));
    const auto head = static_cast<std::size_t>(geometry.Mesh.Head(h));
    if (this->Source[tail] == None || this->Source[tail] != this->Source[head])
    {
      continue;
    }
    const double toTail = ToCorner(geometry, place, c);
    const double toHead = ToCorner(geometry, place, (c + 1) % 3);
    const double distance = Across(this->Distance[tail], this->Distance[head],
      geometry.Lengths.SquaredLength[geometry.Mesh.Edge(h)], toTail * toTail, toHead * toHead,
      this->Kind == Sources::Points);
    if (distance < nearest)
    {
      nearest = distance;
      source = this->Source[tail];
    }
  }
  return nearest;
}

SurfaceDistance::SurfaceDistance(const IntrinsicGeometry& geometry, const std::vector<Seed>& seeds,
  double most, Sources sources, const std::vector<Index>& targets)
  : Distance(static_cast<std::size_t>(geometry.Mesh.GetNumberOfVertices()), Infinity)
  , Source(this->Distance.size(), None)
  , Kind(sources)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const LargeArray<double>& squares = geometry.Lengths.SquaredLength;
  std::vector<char> isFinal(this->Distance.size(), 0);
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> fronts;
  const auto arrive = [&](Index vertex, double distance, Index source)
  {
    const auto at = static_cast<std::size_t>(vertex);
    const bool isNearer = distance < this->Distance[at] ||
      (distance == this->Distance[at] && source < this->Source[at]);
    if (distance <= most && isNearer && isFinal[at] == 0)
    {
      this->Distance[at] = distance;
      this->Source[at] = source;
      fronts.push({ distance, vertex, source });
    }
  };
  for (const Seed& seed : seeds)
  {
    arrive(seed.Vertex, seed.Distance, seed.Source);
  }
  // Continues the front beyond the triangle at the tail of a half-edge, where the distance is
  // final.
  const auto spread = [&](Index tail, Index h)
  {
    const auto at = static_cast<std::size_t>(tail);
    const std::array<Index, 2> ends = { mesh.Head(h), mesh.Tail(TriangleMesh::Previous(h)) };
    const std::array<double, 2> sides = { squares[mesh.Edge(h)],
      squares[mesh.Edge(TriangleMesh::Previous(h))] };
    const double opposite = squares[mesh.Edge(TriangleMesh::Next(h))];
    for (std::size_t k = 0; k < 2; ++k)
    {
      const Index far = ends[k];
      const auto other = static_cast<std::size_t>(ends[1 - k]);
      arrive(far, this->Distance[at] + std::sqrt(sides[k]), this->Source[at]);
      if (isFinal[other] != 0 && this->Source[other] == this->Source[at])
      {
        arrive(far,
          Across(this->Distance[at], this->Distance[other], sides[1 - k], sides[k], opposite,
            this->Kind == Sources::Points),
          this->Source[at]);
      }
    }
  };
  std::vector<char> isTarget(targets.empty() ? 0 : this->Distance.size(), 0);
  std::size_t left = 0;
  for (const Index vertex : targets)
  {
    left += isTarget[static_cast<std::size_t>(vertex)] == 0 ? 1 : 0;
    isTarget[static_cast<std::size_t>(vertex)] = 1;
  }
  std::vector<Index> fan;
  while (!fronts.empty() && (targets.empty() || left > 0))
  {
    const Arrival arrival = fronts.top();
    fronts.pop();
    const auto at = static_cast<std::size_t>(arrival.Vertex);
    if (isFinal[at] != 0 || arrival.Distance != this->Distance[at])
    {
      continue;
    }
    isFinal[at] = 1;
    left -= !isTarget.empty() && isTarget[at] != 0 ? 1 : 0;
    this->Order.push_back(arrival.Vertex);
    mesh.GetFan(arrival.Vertex, fan);
    for (const Index h : fan)
    {
      spread(arrival.Vertex, h);
    }
  }
}
}
