// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "OwnField/SharpCorners.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace DirectionFields::Internal
{
namespace
{
/// Corners sharper than this, in radians, have no faces that would be worth it.
constexpr double Sharpest = 3.0 / 180.0 * Pi;
/// In parts of half of 2 pi / n: at half of it the field takes one face or none by chance, so that
/// corners a little wider have one, too.
constexpr double Widest = 10.0 / 9.0;
/// The radius of the part of a corner with given directions, in parts of how far its sides move
/// apart. Faces inside are as skew as the corner, so that a map folds where there are more of them:
/// the radius is one to six lengths of edges, and at most this part of the length of the sides.
constexpr double PartOfWidth = 0.3;
constexpr double LeastRadius = 1.0;
constexpr double MostFaces = 6.0;
constexpr double MostRadius = 0.45;
/// Sides are followed over this many lengths of edges, and this many edges, at most.
constexpr double LongestSide = 400.0;
constexpr int MostSteps = 4000;

class Corners
{
public:
  Corners(const SurfaceGeometry& geometry, int degree, const std::vector<char>& isFeature,
    double face, SharpCorners& result)
    : Geometry(geometry)
    , Mesh(geometry.Mesh)
    , Degree(degree)
    , Face(face)
    , IsSide(isFeature)
    , Sides(geometry.Mesh.GetNumberOfVertices(), 0)
    , VisitedBy(geometry.Mesh.GetNumberOfTriangles(), None)
    , Result(result)
  {
    for (Index e = 0; e < this->Mesh.GetNumberOfEdges(); ++e)
    {
      const Index h = this->Mesh.HalfEdge(e);
      this->IsSide[e] = this->IsSide[e] != 0 || this->Mesh.Twin(h) == None ? 1 : 0;
      this->Sides[this->Mesh.Tail(h)] += this->IsSide[e];
      this->Sides[this->Mesh.Head(h)] += this->IsSide[e];
    }
  }

  void Visit()
  {
    for (Index v = 0; v < this->Mesh.GetNumberOfVertices(); ++v)
    {
      // Two features that turn back upon each other are the end of a fold, which a map may round.
      if (this->Sides[v] >= (this->Mesh.IsBoundary(v) ? 2 : 3))
      {
        this->Visit(v);
      }
    }
  }

private:
  /// Two sides at a vertex that follow each other counter-clockwise, and what is between them.
  struct Corner
  {
    Index Vertex;
    Index First;
    Index Last;
    std::vector<Index> Triangles;
    double Angle;
  };
  /// A place on a side.
  struct Place
  {
    double Length;
    Vector3 Position;
  };

  const Vector3& PositionOf(Index v) const { return this->Geometry.Positions[v]; }

  void Visit(Index v)
  {
    this->Mesh.GetFan(v, this->Fan);
    const std::size_t count = this->Fan.size();
    const bool isBoundary = this->Mesh.IsBoundary(v);
    const auto isSide = [&](Index h) { return this->IsSide[this->Mesh.Edge(h)] != 0; };
    for (std::size_t first = 0; first < count; ++first)
    {
      if (!isSide(this->Fan[first]))
      {
        continue;
      }
      Corner corner{ v, this->Mesh.Head(this->Fan[first]), None, {}, 0.0 };
      for (std::size_t k = first; k < first + count && corner.Last == None; ++k)
      {
        const Index h = this->Fan[k % count];
        if (k >= count && isBoundary)
        {
          break;
        }
        corner.Angle +=
          this->Geometry.Transport.CornerAngle(this->Mesh, h) / this->Geometry.Transport.Scale[v];
        corner.Triangles.push_back(h / 3);
        const Index back = TriangleMesh::Previous(h);
        corner.Last = isSide(back) ? this->Mesh.Tail(back) : None;
      }
      if (corner.Last != None && corner.Angle > Sharpest &&
        corner.Angle < Widest * Pi / this->Degree)
      {
        this->Fill(corner);
      }
    }
  }

  /// The side that leaves a vertex towards another one, to where it ends, meets others or turns.
  std::vector<Place> SideFrom(Index v, Index next) const
  {
    const double mostTurned = std::cos(Pi / this->Degree);
    const Vector3 forward = (this->PositionOf(next) - this->PositionOf(v)).normalized();
    std::vector<Place> side{ { 0.0, this->PositionOf(v) } };
    std::vector<Index> fan;
    for (int step = 0; step < MostSteps; ++step)
    {
      const Vector3 edge = this->PositionOf(next) - this->PositionOf(v);
      if (!(edge.normalized().dot(forward) > mostTurned) ||
        side.back().Length > LongestSide * this->Face)
      {
        break;
      }
      side.push_back({ side.back().Length + edge.norm(), this->PositionOf(next) });
      if (this->Sides[next] != 2)
      {
        break;
      }
      Index after = None;
      this->Mesh.GetFan(next, fan);
      for (const Index h : fan)
      {
        const Index back = TriangleMesh::Previous(h);
        after = this->IsSide[this->Mesh.Edge(h)] != 0 && this->Mesh.Head(h) != v
          ? this->Mesh.Head(h)
          : after;
        after = this->IsSide[this->Mesh.Edge(back)] != 0 && this->Mesh.Tail(back) != v
          ? this->Mesh.Tail(back)
          : after;
      }
      if (after == None)
      {
        break;
      }
      v = next;
      next = after;
    }
    return side;
  }

  /// The radius around a corner inside of which directions are given; 0 for a corner too small.
  double RadiusOf(const Corner& corner) const
  {
    const std::vector<Place> first = this->SideFrom(corner.Vertex, corner.First);
    const std::vector<Place> last = this->SideFrom(corner.Vertex, corner.Last);
    double length = 0.0;
    double width = 0.0;
    std::size_t k = 0;
    for (const Place& place : first)
    {
      while (k + 1 < last.size() && last[k + 1].Length < place.Length)
      {
        ++k;
      }
      if (k + 1 >= last.size() && last.back().Length < place.Length)
      {
        break;
      }
      const double step = last[k + 1 < last.size() ? k + 1 : k].Length - last[k].Length;
      const double part = step > 0.0 ? (place.Length - last[k].Length) / step : 0.0;
      const Vector3 opposite = last[k].Position +
        part * (last[k + 1 < last.size() ? k + 1 : k].Position - last[k].Position);
      const double apart = (place.Position - opposite).norm();
      if (apart < width)
      {
        break;
      }
      length = place.Length;
      width = apart;
    }
    if (last.back().Length < first.back().Length && length < last.back().Length)
    {
      // The other side ends between two places of this one.
      const double part = last.back().Length;
      width = std::max(width, part * (length > 0.0 ? width / length : corner.Angle));
      length = part;
    }
    const double most = std::min(MostRadius * length, MostFaces * this->Face);
    const double radius = std::max(std::min(PartOfWidth * width, most), LeastRadius * this->Face);
    return radius <= MostRadius * length ? radius : 0.0;
  }

  void Fill(const Corner& corner)
  {
    const double radius = this->RadiusOf(corner);
    if (!(radius > 0.0))
    {
      return;
    }
    const Vector3& at = this->PositionOf(corner.Vertex);
    const Vector3 toFirst = (this->PositionOf(corner.First) - at).normalized();
    const Vector3 toLast = (this->PositionOf(corner.Last) - at).normalized();
    const Vector3 middle = (toFirst + toLast).normalized();
    const Vector3 across = (toLast - toFirst).normalized();
    const double turned = Pi / this->Degree;
    const Vector3 direction = std::cos(turned) * middle + std::sin(turned) * across;
    if (this->Sides[corner.Vertex] == 2 && this->Mesh.IsBoundary(corner.Vertex))
    {
      this->Result.IsEnd[corner.Vertex] = 1;
      this->Result.Directions[corner.Vertex] = direction;
    }
    std::vector<Index> triangles = corner.Triangles;
    for (const Index t : triangles)
    {
      this->VisitedBy[t] = corner.Vertex;
    }
    for (std::size_t k = 0; k < triangles.size(); ++k)
    {
      for (Index h = 3 * triangles[k]; h < 3 * triangles[k] + 3; ++h)
      {
        const Index w = this->Mesh.Tail(h);
        const Vector3 from = this->PositionOf(w) - at;
        if (from.norm() < radius && this->Sides[w] == 0)
        {
          this->Result.Directions[w] = direction;
        }
        const Index twin = this->Mesh.Twin(h);
        const Index head = this->Mesh.Head(h);
        const bool isOutside = twin == None || this->IsSide[this->Mesh.Edge(h)] != 0 ||
          (from.norm() >= radius && (this->PositionOf(head) - at).norm() >= radius);
        if (!isOutside && this->Sides[w] > 0 && this->Sides[head] > 0 && w != corner.Vertex &&
          head != corner.Vertex)
        {
          this->Result.IsChord[this->Mesh.Edge(h)] = 1;
        }
        if (!isOutside && this->VisitedBy[twin / 3] != corner.Vertex)
        {
          this->VisitedBy[twin / 3] = corner.Vertex;
          triangles.push_back(twin / 3);
        }
      }
    }
  }

  const SurfaceGeometry& Geometry;
  const TriangleMesh& Mesh;
  const int Degree;
  const double Face;
  std::vector<char> IsSide;
  /// How many there are at each vertex.
  std::vector<int> Sides;
  /// The vertex of the corner that a triangle was last visited for.
  std::vector<Index> VisitedBy;
  SharpCorners& Result;
  std::vector<Index> Fan;
};
}

SharpCorners::SharpCorners(
  const SurfaceGeometry& geometry, int degree, const std::vector<char>& isFeature, double face)
  : Directions(geometry.Mesh.GetNumberOfVertices(), Vector3::Zero())
  , IsChord(geometry.Mesh.GetNumberOfEdges(), 0)
  , IsEnd(geometry.Mesh.GetNumberOfVertices(), 0)
{
  Corners(geometry, degree, isFeature, face, *this).Visit();
}
}
