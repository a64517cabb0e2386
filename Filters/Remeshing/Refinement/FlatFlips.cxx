// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Refinement/FlatFlips.h"

#include "Support/SortedEnds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace DirectionFields::Internal
{
namespace
{
/// Diagonals that pass each other within this part of the longest edge are one place.
constexpr double Close = 0.01;
/// The normals of two triangles that are one plane enclose no more than this cosine says: 15
/// degrees.
constexpr double Parallel = 0.966;
/// By how much the sum of the opposite angles has to be more than pi: a square stays as it is.
constexpr double Margin = 1e-6;
/// In planes flips come to an end; where the surface is bent nothing says so.
constexpr Index MostFlipsPerEdge = 10;

/// The triangles of a surface, with half-edges 3 t + c that are turned in place.
class Flips
{
public:
  Flips(const SurfaceGeometry& geometry, const std::vector<char>& isFixed,
    const std::vector<double>& longest)
    : Mesh(geometry.Mesh)
    , Positions(geometry.Positions)
    , Longest(longest)
  {
    const Index count = 3 * this->Mesh.GetNumberOfTriangles();
    this->Tail.resize(count);
    this->Twin.resize(count);
    this->IsFixed.resize(count);
    for (Index h = 0; h < count; ++h)
    {
      this->Tail[h] = this->Mesh.Tail(h);
      this->Twin[h] = this->Mesh.Twin(h);
      this->IsFixed[h] = this->Twin[h] == None || isFixed[this->Mesh.Edge(h)] != 0 ? 1 : 0;
      this->Joined.insert(this->Ends(this->Mesh.Tail(h), this->Mesh.Head(h)));
    }
  }

  void Run()
  {
    std::vector<Index> stack;
    for (Index h = static_cast<Index>(this->Tail.size()) - 1; h >= 0; --h)
    {
      stack.push_back(h);
    }
    Index left = MostFlipsPerEdge * this->Mesh.GetNumberOfEdges();
    while (!stack.empty() && left > 0)
    {
      const Index h = stack.back();
      stack.pop_back();
      if (this->IsFixed[h] == 0 && this->Improves(h))
      {
        const Index g = this->Twin[h];
        this->Flip(h);
        for (const Index side : { TriangleMesh::Next(h), TriangleMesh::Previous(h),
               TriangleMesh::Next(g), TriangleMesh::Previous(g) })
        {
          stack.push_back(side);
        }
        --left;
      }
    }
  }

  std::vector<Triangle> Triangles() const
  {
    std::vector<Triangle> triangles;
    for (Index t = 0; t < this->Mesh.GetNumberOfTriangles(); ++t)
    {
      if (this->Mesh.IsFront(t))
      {
        triangles.push_back({ this->Mesh.Point(this->Tail[3 * t]),
          this->Mesh.Point(this->Tail[3 * t + 1]), this->Mesh.Point(this->Tail[3 * t + 2]) });
      }
    }
    return triangles;
  }

private:
  /// The points at the ends of an edge: sheets that meet there must not share two edges.
  std::array<Index, 2> Ends(Index a, Index b) const
  {
    return SortedEnds(this->Mesh.Point(a), this->Mesh.Point(b));
  }

  Vector3 Normal(Index a, Index b, Index c) const
  {
    return (this->Positions[b] - this->Positions[a]).cross(this->Positions[c] - this->Positions[a]);
  }

  double Angle(Index at, Index a, Index b) const
  {
    const Vector3 u = this->Positions[a] - this->Positions[at];
    const Vector3 v = this->Positions[b] - this->Positions[at];
    return std::atan2(u.cross(v).norm(), u.dot(v));
  }

  /// Whether the two triangles at an edge are one plane, nearly, and the other diagonal is the
  /// Delaunay one.
  bool Improves(Index h) const
  {
    const Index g = this->Twin[h];
    const Index a = this->Tail[h];
    const Index b = this->Tail[g];
    const Index c = this->Tail[TriangleMesh::Previous(h)];
    const Index d = this->Tail[TriangleMesh::Previous(g)];
    if (c == d || this->Angle(c, a, b) + this->Angle(d, a, b) < Pi + Margin ||
      this->Joined.count(this->Ends(c, d)) > 0)
    {
      return false;
    }
    const Vector3 left = this->Normal(a, b, c);
    const Vector3 right = this->Normal(b, a, d);
    const Vector3 first = this->Normal(c, d, b);
    const Vector3 second = this->Normal(d, c, a);
    const auto areOne = [](const Vector3& n, const Vector3& m)
    { return n.dot(m) > Parallel * n.norm() * m.norm(); };
    // Triangles without area have no normal.
    const Vector3 both = left + right;
    if (!(left.isZero(0.0) || right.isZero(0.0) || areOne(left, right)) || !areOne(first, both) ||
      !areOne(second, both))
    {
      return false;
    }
    const double distance =
      std::abs((this->Positions[c] - this->Positions[a]).dot(both.normalized())) +
      std::abs((this->Positions[d] - this->Positions[a]).dot(both.normalized()));
    return distance < Close * this->Longest[this->Mesh.Point(a)];
  }

  void Flip(Index h)
  {
    const Index g = this->Twin[h];
    const Index hNext = TriangleMesh::Next(h);
    const Index gNext = TriangleMesh::Next(g);
    const Index hPrevious = TriangleMesh::Previous(h);
    const Index gPrevious = TriangleMesh::Previous(g);
    const Index c = this->Tail[hPrevious];
    const Index d = this->Tail[gPrevious];
    this->Joined.erase(this->Ends(this->Tail[h], this->Tail[g]));
    this->Joined.insert(this->Ends(c, d));
    // The triangle of h becomes d, c and its former tail; that of g c, d and the other end.
    const Index a = this->Tail[h];
    const Index b = this->Tail[g];
    struct Side
    {
      Index Twin;
      char IsFixed;
    };
    const auto sideOf = [this](Index s) { return Side{ this->Twin[s], this->IsFixed[s] }; };
    const Side bc = sideOf(hNext);
    const Side ca = sideOf(hPrevious);
    const Side ad = sideOf(gNext);
    const Side db = sideOf(gPrevious);
    const auto set = [this](Index s, Index tail, const Side& side)
    {
      this->Tail[s] = tail;
      this->Twin[s] = side.Twin;
      this->IsFixed[s] = side.IsFixed;
      if (side.Twin != None)
      {
        this->Twin[side.Twin] = s;
      }
    };
    this->Tail[h] = d;
    set(hNext, c, ca);
    set(hPrevious, a, ad);
    this->Tail[g] = c;
    set(gNext, d, db);
    set(gPrevious, b, bc);
  }

  const TriangleMesh& Mesh;
  const std::vector<Vector3>& Positions;
  const std::vector<double>& Longest;
  std::vector<Index> Tail;
  std::vector<Index> Twin;
  std::vector<char> IsFixed;
  std::set<std::array<Index, 2>> Joined;
};
}

std::vector<Triangle> FlipFlat(const SurfaceGeometry& geometry, const std::vector<char>& isFixed,
  const std::vector<double>& longest)
{
  Flips flips(geometry, isFixed, longest);
  flips.Run();
  return flips.Triangles();
}
}
