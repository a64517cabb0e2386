// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "OwnField/HoleBands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <tuple>

namespace DirectionFields::Internal
{
namespace
{
/// The width of a band, in radii of the hole and in lengths of edges.
constexpr double PartOfRadius = 0.7;
constexpr double LeastWidth = 2.0;
constexpr double MostWidth = 5.0;
/// The part of the distance between two lines that a band takes, and how far away from a vertex of
/// the widest band the second line is looked for, in widths.
constexpr double PartOfGap = 1.0 / 3.0;
constexpr double Reach = 1.0 / PartOfGap - 1.0;
/// Lines beside each other hinder no band if they ask for the same directions, but for this angle.
constexpr double Alike = 15.0 / 180.0 * Pi;
/// What is in one plane, but for this angle.
constexpr double Flat = 1.0 / 180.0 * Pi;

/// The features and the boundary of a surface.
class Lines
{
public:
  /// Closed, and without corners.
  struct Rim
  {
    Vector3 Middle = Vector3::Zero();
    double Radius = 0.0;
  };

  /// The closest point of an edge of a line.
  struct Foot
  {
    Index Edge = None;
    double Distance = 0.0;
    Vector3 Place = Vector3::Zero();
    /// The vertex that the point is, or None inside of the edge.
    Index Vertex = None;
  };

  Lines(const SurfaceGeometry& geometry, int degree, const std::vector<char>& isFeature)
    : Geometry(geometry)
    , Mesh(geometry.Mesh)
    , LeastForward(std::cos(Pi / degree))
    , IsLine(isFeature)
    , EdgesAt(geometry.Mesh.GetNumberOfVertices(), { None, None })
    , Count(geometry.Mesh.GetNumberOfVertices(), 0)
    , RimOf(geometry.Mesh.GetNumberOfEdges(), None)
  {
    for (Index e = 0; e < this->Mesh.GetNumberOfEdges(); ++e)
    {
      const Index h = this->Mesh.HalfEdge(e);
      this->IsLine[e] = this->IsLine[e] != 0 || this->Mesh.Twin(h) == None ? 1 : 0;
      for (const Index v : { this->Mesh.Tail(h), this->Mesh.Head(h) })
      {
        if (this->IsLine[e] != 0 && this->Count[v]++ < 2)
        {
          this->EdgesAt[v][this->Count[v] - 1] = e;
        }
      }
    }
    this->FindRims();
  }

  bool IsLineEdge(Index e) const { return this->IsLine[e] != 0; }
  bool IsOnLine(Index v) const { return this->Count[v] != 0; }
  bool HaveRims() const { return !this->Rims.empty(); }
  /// The rim that an edge belongs to, or null.
  const Rim* RimAt(Index e) const
  {
    return this->RimOf[e] != None ? &this->Rims[this->RimOf[e]] : nullptr;
  }

  /// The closest point to a place of a line that is followed from an edge of it.
  Foot FootNear(Index e, const Vector3& place) const
  {
    constexpr int mostSteps = 100;
    Foot foot = this->FootOn(e, place);
    for (int step = 0; step < mostSteps && foot.Vertex != None; ++step)
    {
      if (this->Count[foot.Vertex] != 2)
      {
        break;
      }
      const Foot next = this->FootOn(this->After(foot.Edge, foot.Vertex), place);
      if (!(next.Distance < foot.Distance))
      {
        break;
      }
      foot = next;
    }
    return foot;
  }

private:
  const Vector3& PlaceOf(Index v) const { return this->Geometry.Positions[v]; }
  Index OtherEnd(Index e, Index v) const
  {
    const Index h = this->Mesh.HalfEdge(e);
    return this->Mesh.Tail(h) == v ? this->Mesh.Head(h) : this->Mesh.Tail(h);
  }
  /// The other one of two edges at a vertex.
  Index After(Index e, Index v) const { return this->EdgesAt[v][this->EdgesAt[v][0] == e ? 1 : 0]; }

  Foot FootOn(Index e, const Vector3& place) const
  {
    const Index h = this->Mesh.HalfEdge(e);
    const Vector3& tail = this->PlaceOf(this->Mesh.Tail(h));
    const Vector3 along = this->PlaceOf(this->Mesh.Head(h)) - tail;
    const double squared = along.squaredNorm();
    const double part =
      squared > 0.0 ? std::clamp((place - tail).dot(along) / squared, 0.0, 1.0) : 0.0;
    const Vector3 foot = tail + part * along;
    const Index vertex = part == 0.0 ? this->Mesh.Tail(h) : part == 1.0 ? this->Mesh.Head(h) : None;
    return { e, (place - foot).norm(), foot, vertex };
  }

  /// Whether exactly one line goes on at a vertex, without a corner.
  bool IsSmooth(Index v) const
  {
    if (this->Count[v] != 2)
    {
      return false;
    }
    const auto& [first, second] = this->EdgesAt[v];
    const Vector3 in = this->PlaceOf(v) - this->PlaceOf(this->OtherEnd(first, v));
    const Vector3 out = this->PlaceOf(this->OtherEnd(second, v)) - this->PlaceOf(v);
    return in.normalized().dot(out.normalized()) > this->LeastForward;
  }

  /// The chains of Features/EdgeChains end at each vertex of the boundary, which may be a rim, too.
  void FindRims()
  {
    std::vector<char> isSeen(this->IsLine.size(), 0);
    for (Index first = 0; first < this->Mesh.GetNumberOfEdges(); ++first)
    {
      if (this->IsLine[first] == 0 || isSeen[first] != 0)
      {
        continue;
      }
      std::vector<Index> edges;
      Index v = this->Mesh.Head(this->Mesh.HalfEdge(first));
      Index e = first;
      while (isSeen[e] == 0)
      {
        isSeen[e] = 1;
        edges.push_back(e);
        if (!this->IsSmooth(v))
        {
          break;
        }
        e = this->After(e, v);
        v = this->OtherEnd(e, v);
      }
      if (e == first && edges.size() > 1)
      {
        this->AddRim(edges);
      }
    }
  }

  void AddRim(const std::vector<Index>& edges)
  {
    Rim rim;
    double length = 0.0;
    for (const Index e : edges)
    {
      const Index h = this->Mesh.HalfEdge(e);
      const Vector3& tail = this->PlaceOf(this->Mesh.Tail(h));
      const Vector3& head = this->PlaceOf(this->Mesh.Head(h));
      rim.Middle += (head - tail).norm() * 0.5 * (tail + head);
      length += (head - tail).norm();
      this->RimOf[e] = static_cast<Index>(this->Rims.size());
    }
    rim.Middle /= length;
    rim.Radius = length / (2.0 * Pi);
    this->Rims.push_back(rim);
  }

  const SurfaceGeometry& Geometry;
  const TriangleMesh& Mesh;
  double LeastForward;
  std::vector<char> IsLine;
  /// The first two edges of lines at each vertex, and how many there are.
  std::vector<std::array<Index, 2>> EdgesAt;
  std::vector<Index> Count;
  std::vector<Rim> Rims;
  std::vector<Index> RimOf;
};

/// Takes the feet of vertices on lines from neighbour to neighbour, the nearest first.
class Bands
{
public:
  Bands(const SurfaceGeometry& geometry, int degree, const Lines& lines, double edgeLength)
    : Geometry(geometry)
    , Mesh(geometry.Mesh)
    , Degree(degree)
    , AllLines(lines)
    , EdgeLength(edgeLength)
    , Feet(geometry.Mesh.GetNumberOfVertices())
  {
    for (Index e = 0; e < this->Mesh.GetNumberOfEdges(); ++e)
    {
      const Index h = this->Mesh.HalfEdge(e);
      if (lines.IsLineEdge(e))
      {
        this->Queue.emplace(0.0, this->Mesh.Tail(h), e);
        this->Queue.emplace(0.0, this->Mesh.Head(h), e);
      }
    }
    while (!this->Queue.empty())
    {
      const auto [distance, v, e] = this->Queue.top();
      this->Queue.pop();
      this->Visit(v, lines.FootNear(e, this->PlaceOf(v)));
    }
  }

  /// The direction at a vertex, or zero.
  Vector3 At(Index v)
  {
    const bool isInside = !this->AllLines.IsOnLine(v) && this->IsInside(v);
    return isInside ? this->Around(v, this->Feet[v][0]) : Vector3(Vector3::Zero());
  }

private:
  using Foot = Lines::Foot;
  const Vector3& PlaceOf(Index v) const { return this->Geometry.Positions[v]; }

  /// Keeps the closest point, and the closest one in another direction. Lines are not crossed,
  /// since a vertex on one has no other foot.
  void Visit(Index v, const Foot& foot)
  {
    std::array<Foot, 2>& feet = this->Feet[v];
    const bool isFirst = feet[0].Edge == None;
    const bool isSecond = !isFirst && feet[1].Edge == None && !this->AllLines.IsOnLine(v) &&
      (feet[0].Place - foot.Place).norm() > foot.Distance;
    if (!isFirst && !isSecond)
    {
      return;
    }
    feet[isFirst ? 0 : 1] = foot;
    this->Mesh.GetFan(v, this->Fan);
    for (const Index h : this->Fan)
    {
      for (const Index w : { this->Mesh.Head(h), this->Mesh.Tail(TriangleMesh::Previous(h)) })
      {
        if (this->AllLines.IsOnLine(w) || this->Feet[w][1].Edge != None)
        {
          continue;
        }
        const Foot next = this->AllLines.FootNear(foot.Edge, this->PlaceOf(w));
        if (next.Distance <= Reach * MostWidth * this->EdgeLength)
        {
          this->Queue.emplace(next.Distance, w, next.Edge);
        }
      }
    }
  }

  Vector3 Around(Index v, const Foot& foot) const
  {
    return this->Geometry.Frames.Normal[v].cross(this->PlaceOf(v) - foot.Place).normalized();
  }

  bool IsInside(Index v)
  {
    const auto& [first, second] = this->Feet[v];
    const Lines::Rim* const rim = first.Edge != None ? this->AllLines.RimAt(first.Edge) : nullptr;
    if (rim == nullptr)
    {
      return false;
    }
    const double width = std::clamp(
      PartOfRadius * rim->Radius, LeastWidth * this->EdgeLength, MostWidth * this->EdgeLength);
    const Vector3 away = this->PlaceOf(v) - first.Place;
    return first.Distance <= width && away.dot(first.Place - rim->Middle) > 0.0 &&
      this->IsInPlane(v, away) && (second.Edge == None || this->HasRoom(v, first, second));
  }

  /// Whether all triangles at a vertex, and the way to it, are in one plane.
  bool IsInPlane(Index v, const Vector3& way)
  {
    const Vector3& normal = this->Geometry.Frames.Normal[v];
    this->Mesh.GetFan(v, this->Fan);
    const auto isInPlane = [&](Index h)
    {
      const Vector3 a = this->PlaceOf(this->Mesh.Head(h)) - this->PlaceOf(v);
      const Vector3 b =
        this->PlaceOf(this->Mesh.Tail(TriangleMesh::Previous(h))) - this->PlaceOf(v);
      const Vector3 area = a.cross(b);
      return area.dot(normal) >= std::cos(Flat) * area.norm();
    };
    return std::abs(way.dot(normal)) <= std::sin(Flat) * way.norm() &&
      std::all_of(this->Fan.begin(), this->Fan.end(), isInPlane);
  }

  /// Whether a second line is far away, or beside the vertex and of the same directions.
  bool HasRoom(Index v, const Foot& first, const Foot& second) const
  {
    if (first.Distance <= PartOfGap * (first.Distance + second.Distance))
    {
      return true;
    }
    const Vector3 a = this->Around(v, first);
    const Vector3 b = this->Around(v, second);
    const double angle = std::atan2(this->Geometry.Frames.Normal[v].dot(a.cross(b)), a.dot(b));
    return a.dot(b) >= -0.5 && std::abs(std::remainder(angle, 2.0 * Pi / this->Degree)) < Alike;
  }

  const SurfaceGeometry& Geometry;
  const TriangleMesh& Mesh;
  int Degree;
  const Lines& AllLines;
  double EdgeLength;
  std::vector<std::array<Foot, 2>> Feet;
  using Entry = std::tuple<double, Index, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> Queue;
  std::vector<Index> Fan;
};
}

std::vector<Vector3> HoleBands(const SurfaceGeometry& geometry, int degree,
  const std::vector<char>& isFeature, double edgeLength)
{
  std::vector<Vector3> directions(geometry.Mesh.GetNumberOfVertices(), Vector3::Zero());
  const Lines lines(geometry, degree, isFeature);
  if (!lines.HaveRims())
  {
    return directions;
  }
  Bands bands(geometry, degree, lines, edgeLength);
  for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
  {
    directions[v] = bands.At(v);
  }
  return directions;
}
}
