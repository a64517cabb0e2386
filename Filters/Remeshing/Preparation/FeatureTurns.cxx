// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Preparation/FeatureTurns.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// A feature that turns by more than this has a corner.
constexpr double LeastTurn = Pi / 6.0;

/// The vertices of a chain, the first one again at the end of a closed one; and whether the edge
/// after each is still a feature.
struct Polyline
{
  std::vector<Index> Vertices;
  std::vector<char> IsFeature;
  bool IsClosed;

  Polyline(const TriangleMesh& mesh, const FeatureLines& features, const FeatureLines::Chain& chain)
    : IsClosed(chain.IsClosed)
  {
    for (const FeatureLines::Step& step : chain.Steps)
    {
      this->Vertices.push_back(FeatureLines::Start(mesh, step));
      this->IsFeature.push_back(features.IsFeature[mesh.Edge(step.HalfEdge)]);
    }
    this->Vertices.push_back(FeatureLines::End(mesh, chain.Steps.back()));
  }

  /// Features end at a vertex, or meet.
  bool IsEnd(std::size_t at) const
  {
    const std::size_t steps = this->IsFeature.size();
    return (!this->IsClosed && (at == 0 || at == steps)) ||
      this->IsFeature[(at + steps - 1) % steps] == 0 || this->IsFeature[at % steps] == 0;
  }

  /// Calls visit(i) for the vertices within a length from one, in one direction, as far as the
  /// feature goes, and returns the place at that length.
  template <typename Visit>
  Vector3 Walk(const std::vector<Vector3>& positions, std::size_t at, bool isForward, double length,
    const Visit& visit) const
  {
    const std::size_t steps = this->IsFeature.size();
    Vector3 place = positions[this->Vertices[at]];
    for (std::size_t k = 0; k < steps; ++k)
    {
      if (!this->IsClosed && at == (isForward ? steps : 0))
      {
        break;
      }
      const std::size_t edge = isForward ? at % steps : (at + steps - 1) % steps;
      if (this->IsFeature[edge] == 0)
      {
        break;
      }
      at = isForward ? edge + 1 : edge;
      const Vector3 next = positions[this->Vertices[at]];
      const double step = (next - place).norm();
      if (step >= length)
      {
        return place + (length / step) * (next - place);
      }
      length -= step;
      place = next;
      visit(at);
    }
    return place;
  }

  /// The angle between the directions before and after each vertex, averaged over a length.
  std::vector<double> TurnsOf(
    const std::vector<Vector3>& positions, const std::vector<double>& length) const
  {
    std::vector<double> turn;
    for (std::size_t i = 0; i < this->Vertices.size(); ++i)
    {
      const Index v = this->Vertices[i];
      const auto nothing = [](std::size_t) {};
      const Vector3 before = positions[v] - this->Walk(positions, i, false, length[v], nothing);
      const Vector3 after = this->Walk(positions, i, true, length[v], nothing) - positions[v];
      turn.push_back(std::atan2(before.cross(after).norm(), before.dot(after)));
    }
    return turn;
  }

  /// Whether no vertex within the length turns by more: the neighbours of a corner seem to turn,
  /// too.
  bool IsLargest(const std::vector<Vector3>& positions, const std::vector<double>& turn,
    std::size_t at, double length) const
  {
    constexpr double rounding = 1e-9;
    bool isLargest = true;
    for (const bool isForward : { false, true })
    {
      this->Walk(positions, at, isForward, length,
        [&](std::size_t i) { isLargest = isLargest && turn[i] <= turn[at] + rounding; });
    }
    return isLargest;
  }
};
}

std::vector<char> FindTurns(
  const SurfaceGeometry& geometry, const FeatureLines& features, const std::vector<double>& length)
{
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<char> isTurn = features.IsEnd;
  isTurn.resize(mesh.GetNumberOfVertices(), 0);
  for (const FeatureLines::Chain& chain : features.Chains)
  {
    const Polyline line(mesh, features, chain);
    const std::vector<double> turn = line.TurnsOf(geometry.Positions, length);
    for (std::size_t i = 0; i < turn.size(); ++i)
    {
      const Index v = line.Vertices[i];
      const bool isCorner = line.IsEnd(i) ||
        (turn[i] > LeastTurn && line.IsLargest(geometry.Positions, turn, i, length[v]));
      isTurn[v] = isTurn[v] != 0 || isCorner ? 1 : 0;
    }
  }
  return isTurn;
}
}
