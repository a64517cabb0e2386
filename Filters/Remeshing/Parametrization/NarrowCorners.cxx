// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/NarrowCorners.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// The room between two features where one of them begins, in wanted lengths of edges.
constexpr double LeastRoom = 0.75;

class Corners
{
public:
  Corners(const SurfaceGeometry& geometry, const FieldMatching& matching,
    const FeatureLines& features, const std::vector<char>& isFrameless,
    const std::vector<double>& perLength)
    : Geometry(geometry)
    , Mesh(geometry.Mesh)
    , Matching(matching)
    , Features(features)
    , IsFrameless(isFrameless)
    , PerLength(perLength)
  {
  }

  void Visit(Index v)
  {
    this->FindSpokes(v);
    const std::size_t count = this->Spokes.size();
    if (count < 2)
    {
      return;
    }
    for (std::size_t i = this->Mesh.IsBoundary(v) ? 1 : 0; i < count; ++i)
    {
      const Spoke& before = this->Spokes[(i + count - 1) % count];
      const Spoke& after = this->Spokes[i];
      const int degree = this->Matching.Degree;
      const double sector = after.Angle - before.Angle + (i == 0 ? this->WholeAngle : 0.0);
      const int turns = after.Direction - before.Direction + (i == 0 ? this->WholeTurn : 0);
      // The multiple of 2 pi / n that the charts allow and that is nearest to the angle.
      const double units = sector * degree / (2.0 * Pi);
      if (turns + degree * std::nearbyint((units - turns) / degree) < 0.5)
      {
        this->Shorten(v, before.Edge, after.Edge, sector);
      }
    }
  }

  std::vector<Index> Edges;

private:
  /// A feature at a vertex: its direction in units of 2 pi / n, and its angle on the surface, both
  /// counter-clockwise.
  struct Spoke
  {
    Index Edge;
    int Direction;
    double Angle;
  };

  double Length(Index e) const
  {
    const Index h = this->Mesh.HalfEdge(e);
    return (
      this->Geometry.Positions[this->Mesh.Head(h)] - this->Geometry.Positions[this->Mesh.Tail(h)])
      .norm();
  }
  bool IsBoundaryEdge(Index e) const { return this->Mesh.Twin(this->Mesh.HalfEdge(e)) == None; }

  /// The direction of a feature away from a vertex, in the chart of the edge's base.
  int DirectionAwayFrom(Index v, Index e) const
  {
    const bool isTail = this->Mesh.Tail(this->Mesh.HalfEdge(e)) == v;
    return this->Features.Axis[e] + (isTail ? 0 : this->Matching.Degree / 2);
  }

  void FindSpokes(Index v)
  {
    this->Spokes.clear();
    this->Mesh.GetFan(v, this->Fan);
    const bool hasFrame = this->IsFrameless[v] == 0;
    const double perAngle = 1.0 / this->Geometry.Transport.Scale[v];
    // Around a vertex without a frame directions are compared along the ring.
    int turned = 0;
    double angle = 0.0;
    const auto add = [&](Index e, int direction)
    {
      if (this->Features.IsFeature[e] != 0)
      {
        this->Spokes.push_back({ e, direction, angle });
      }
    };
    const auto inOwnChart = [&](Index h, bool isReversed)
    {
      const Index e = this->Mesh.Edge(h);
      const int matching = this->Matching.MatchingAlong(this->Mesh, h);
      const int toOwn = this->Features.Base[e] == v ? 0 : (isReversed ? -matching : matching);
      return this->DirectionAwayFrom(v, e) + toOwn;
    };
    for (const Index h : this->Fan)
    {
      const Index e = this->Mesh.Edge(h);
      add(e, hasFrame ? inOwnChart(h, false) : this->DirectionAwayFrom(v, e) + turned);
      turned += this->Matching.MatchingAlong(this->Mesh, TriangleMesh::Next(h));
      angle += perAngle * this->Geometry.Transport.CornerAngle(this->Mesh, h);
    }
    if (this->Mesh.IsBoundary(v))
    {
      const Index last = TriangleMesh::Previous(this->Fan.back());
      add(this->Mesh.Edge(last), inOwnChart(last, true));
    }
    this->WholeTurn = hasFrame ? 0 : turned;
    this->WholeAngle = angle;
  }

  void Shorten(Index v, Index e, Index f, double sector)
  {
    const auto lengthOf = [&](Index edge)
    {
      double length = 0.0;
      for (const FeatureLines::Step& step :
        this->Features.Chains[this->Features.Line[edge] - 1].Steps)
      {
        length += this->Length(this->Mesh.Edge(step.HalfEdge));
      }
      return length;
    };
    if (this->IsBoundaryEdge(e) && this->IsBoundaryEdge(f))
    {
      return;
    }
    const bool isFirst =
      this->IsBoundaryEdge(f) || (!this->IsBoundaryEdge(e) && lengthOf(e) < lengthOf(f));
    const Index edge = isFirst ? e : f;
    const std::vector<FeatureLines::Step>& steps =
      this->Features.Chains[this->Features.Line[edge] - 1].Steps;
    const double reach = LeastRoom / (this->PerLength[v] * std::max(0.1, std::sin(sector)));
    const auto shorten = [&](auto begin, auto end)
    {
      double length = 0.0;
      for (auto step = begin; step != end; ++step)
      {
        const Index next = this->Mesh.Edge(step->HalfEdge);
        const double middle = length + 0.5 * this->Length(next);
        if (step != begin && middle > reach)
        {
          break;
        }
        this->Edges.push_back(next);
        length += this->Length(next);
      }
    };
    if (this->Mesh.Edge(steps.front().HalfEdge) == edge &&
      FeatureLines::Start(this->Mesh, steps.front()) == v)
    {
      shorten(steps.begin(), steps.end());
    }
    else
    {
      shorten(steps.rbegin(), steps.rend());
    }
  }

  const SurfaceGeometry& Geometry;
  const TriangleMesh& Mesh;
  const FieldMatching& Matching;
  const FeatureLines& Features;
  const std::vector<char>& IsFrameless;
  const std::vector<double>& PerLength;
  std::vector<Index> Fan;
  std::vector<Spoke> Spokes;
  int WholeTurn = 0;
  double WholeAngle = 0.0;
};
}

std::vector<Index> EdgesInNarrowCorners(const SurfaceGeometry& geometry,
  const TriangleMesh::Component& component, const FieldMatching& matching,
  const FeatureLines& features, const std::vector<char>& isFrameless,
  const std::vector<double>& perLength)
{
  Corners corners(geometry, matching, features, isFrameless, perLength);
  for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
  {
    corners.Visit(v);
  }
  return std::move(corners.Edges);
}
}
