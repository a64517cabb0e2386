// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SoftFeatures/WideBends.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Triangles that are fewer steps away from an edge, from vertex to vertex, are around it.
constexpr int Rings = 3;

double AngleBetween(const Vector3& a, const Vector3& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}
}

/// The pieces to one side in two halves of about the same area.
struct WideBends::Halves
{
  using Place = std::vector<Piece>::const_iterator;
  Halves(Place begin, Place end)
  {
    double all = 0.0;
    for (Place at = begin; at != end; ++at)
    {
      all += at->Area.norm();
    }
    double area = 0.0;
    for (Place at = begin; at != end; ++at)
    {
      (area < 0.5 * all ? this->First : this->Second) += at->Area;
      area += at->Area.norm();
    }
  }
  Vector3 Sum() const { return this->First + this->Second; }
  double Bend() const { return AngleBetween(this->First, this->Second); }
  Vector3 First = Vector3::Zero();
  Vector3 Second = Vector3::Zero();
};

WideBends::WideBends(const SurfaceGeometry& geometry)
  : Mesh(geometry.Mesh)
  , Positions(geometry.Positions)
  , Known(geometry.Mesh.GetNumberOfEdges())
  , IsKnown(geometry.Mesh.GetNumberOfEdges(), 0)
  , SeenTriangle(geometry.Mesh.GetNumberOfTriangles(), None)
  , SeenVertex(geometry.Mesh.GetNumberOfVertices(), None)
{
}

const WideBend& WideBends::At(Index e)
{
  if (this->IsKnown[e] == 0)
  {
    this->IsKnown[e] = 1;
    this->Known[e] = this->Measure(e);
  }
  return this->Known[e];
}

WideBend WideBends::Measure(Index e)
{
  this->Collect(e);
  const Index h = this->Mesh.HalfEdge(e);
  const Vector3& tail = this->Positions[this->Mesh.Tail(h)];
  const Vector3& head = this->Positions[this->Mesh.Head(h)];
  const Vector3 middle = 0.5 * (tail + head);
  Vector3 normal = Vector3::Zero();
  for (Piece& piece : this->Pieces)
  {
    normal += piece.Area;
  }
  const Vector3 aside = (head - tail).cross(normal);
  for (Piece& piece : this->Pieces)
  {
    piece.Away = (piece.Middle - middle).dot(aside);
  }
  std::sort(this->Pieces.begin(), this->Pieces.end(),
    [](const Piece& a, const Piece& b) { return a.Away < b.Away; });
  const auto between = std::find_if(
    this->Pieces.begin(), this->Pieces.end(), [](const Piece& piece) { return piece.Away > 0.0; });
  const Halves right(this->Pieces.begin(), between);
  const Halves left(between, this->Pieces.end());
  return { AngleBetween(left.Sum(), right.Sum()), 0.5 * (left.Bend() + right.Bend()) };
}

void WideBends::Collect(Index e)
{
  this->Pieces.clear();
  const Index h = this->Mesh.HalfEdge(e);
  std::vector<Index> front = { this->Mesh.Tail(h), this->Mesh.Head(h) };
  for (const Index v : front)
  {
    this->SeenVertex[v] = e;
  }
  for (int k = 0; k < Rings; ++k)
  {
    std::vector<Index> next;
    for (const Index v : front)
    {
      this->CollectAt(v, e, next);
    }
    front = std::move(next);
  }
}

void WideBends::CollectAt(Index v, Index e, std::vector<Index>& next)
{
  Index h = this->Mesh.Outgoing(v);
  do
  {
    const Index t = h / 3;
    if (this->SeenTriangle[t] != e)
    {
      this->SeenTriangle[t] = e;
      const Vector3& a = this->Positions[this->Mesh.Tail(3 * t)];
      const Vector3& b = this->Positions[this->Mesh.Tail(3 * t + 1)];
      const Vector3& c = this->Positions[this->Mesh.Tail(3 * t + 2)];
      this->Pieces.push_back({ (a + b + c) / 3.0, (b - a).cross(c - a) });
      for (Index k = 3 * t; k < 3 * t + 3; ++k)
      {
        const Index w = this->Mesh.Tail(k);
        if (this->SeenVertex[w] != e)
        {
          this->SeenVertex[w] = e;
          next.push_back(w);
        }
      }
    }
    h = this->Mesh.NextOutgoing(h);
  } while (h != None && h != this->Mesh.Outgoing(v));
}
}
