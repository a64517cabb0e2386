// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "UnitLength/SingularityMoves.h"

#include "Sections/Singularities.h"
#include "Support/Threads.h"

#include <algorithm>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Singularities try to cross this many edges first, and twice as many as they did where that went
/// well.
constexpr Index FirstLength = 4;
constexpr Index LongestLength = 64;
/// The patch reaches this many edges from the path at least, a narrow one that compares directions
/// and a wide one.
constexpr Index NarrowRings = 2;
constexpr Index WideRings = 5;
/// In a wide patch the energy falls by up to this more than in a narrow one.
constexpr double MostGainOfWidth = 10.0;
constexpr double LeastGain = 1e-3;
/// Where there are more singularities than this part of the vertices, as noise makes them, they
/// stay: trying them all would take longer than the rest of the computation.
constexpr double MostSingularities = 0.04;
}

SingularityMoves::SingularityMoves(const UnitLengthProblem& problem)
  : Problem(problem)
  , Numbers(problem.Rows())
  , Changed(problem.Rows(), 0)
{
}

void SingularityMoves::FindAll(const ComplexVector& u)
{
  const TriangleMesh::Component& component = this->Problem.Component;
  const std::vector<int> indices =
    SingularityIndices(this->Problem.Geometry, component, this->Problem.Degree, u.data());
  for (Index t = 0; t < component.Triangles() && !component.IsCover; ++t)
  {
    if (indices[t] != 0)
    {
      this->Waiting.push_back(
        { component.FirstTriangle + t, indices[t] > 0 ? 1 : -1, FirstLength });
    }
  }
  if (static_cast<double>(this->Waiting.size()) > MostSingularities * component.Vertices())
  {
    this->Waiting.clear();
  }
}

SingularityPair SingularityMoves::Walk(const Singularity& singularity, int side, bool left) const
{
  const TriangleMesh& mesh = this->Problem.Geometry.Mesh;
  const Index first = this->Problem.Component.FirstVertex;
  const Index from = singularity.Triangle;
  SingularityPair path{ from, from, -singularity.Sign, 0.0, {} };
  Index h = 3 * from + side;
  while (static_cast<Index>(path.Crossed.size()) < singularity.Length)
  {
    const Index twin = mesh.Twin(h);
    const bool canCross =
      this->Problem.IsFree(mesh.Tail(h) - first) || this->Problem.IsFree(mesh.Head(h) - first);
    if (twin == None || !canCross || mesh.Tail(h) == mesh.Head(h))
    {
      break;
    }
    path.Crossed.push_back(h);
    path.To = twin / 3;
    h = left ? TriangleMesh::Next(twin) : TriangleMesh::Previous(twin);
    left = !left;
  }
  return path;
}

void SingularityMoves::FindBest(const Singularity& singularity, const ComplexVector& u, Move& move)
{
  double least = MostGainOfWidth;
  for (const int side : { 0, 1, 2 })
  {
    for (const bool left : { false, true })
    {
      SingularityPair path = this->Walk(singularity, side, left);
      if (path.To != singularity.Triangle)
      {
        PairPatch narrow(this->Problem, path, NarrowRings, this->Numbers);
        narrow.Try(u);
        if (narrow.GetEnergyChange() < least)
        {
          least = narrow.GetEnergyChange();
          move.Path = std::move(path);
        }
      }
    }
  }
  if (!move.Path.Crossed.empty())
  {
    move.Patch = std::make_unique<PairPatch>(
      this->Problem, move.Path, std::max(WideRings, singularity.Length), this->Numbers);
    move.Patch->Try(u);
    if (!(move.Patch->GetEnergyChange() < -LeastGain))
    {
      move.Patch = nullptr;
    }
  }
}

bool SingularityMoves::Go(const Move& move, ComplexVector& u)
{
  const auto isChanged = [&](Index v) { return this->Changed[v] != 0; };
  const std::vector<Index>& vertices = move.Patch->GetVertices();
  const std::vector<Index>& neighbours = move.Patch->GetNeighbours();
  if (std::any_of(vertices.begin(), vertices.end(), isChanged) ||
    std::any_of(neighbours.begin(), neighbours.end(), isChanged))
  {
    return false;
  }
  for (std::size_t k = 0; k < vertices.size(); ++k)
  {
    u[vertices[k]] = move.Patch->GetValues()[k];
    this->Changed[vertices[k]] = 1;
  }
  return true;
}

int SingularityMoves::Sweep(ComplexVector& u)
{
  if (this->IsFirstSweep)
  {
    this->FindAll(u);
    this->IsFirstSweep = false;
  }
  const std::vector<Singularity> now = std::move(this->Waiting);
  std::vector<Move> moves(now.size());
  ParallelFor(static_cast<Index>(now.size()), 1,
    [&](Index k, Index) { this->FindBest(now[k], u, moves[k]); });
  this->Waiting.clear();
  std::fill(this->Changed.begin(), this->Changed.end(), 0);
  int moved = 0;
  for (std::size_t k = 0; k < now.size(); ++k)
  {
    Singularity singularity = now[k];
    if (!moves[k].Patch)
    {
      singularity.Length /= 2;
    }
    else if (this->Go(moves[k], u))
    {
      singularity.Triangle = moves[k].Path.To;
      singularity.Length = std::min(LongestLength, 2 * singularity.Length);
      ++moved;
    }
    if (singularity.Length > 0)
    {
      this->Waiting.push_back(singularity);
    }
  }
  return moved;
}
}
