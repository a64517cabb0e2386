// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Extraction/GridPoints.h"

#include "Extraction/DelaunayFlips.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace DirectionFields::Internal
{
namespace
{
std::int64_t FloorOf(std::int64_t x)
{
  return x >> IntegerGrid::Bits;
}

/// Puts the grid points of a feature edge on it, from its tail on.
void SplitFeature(ExtractionMesh& mesh, Index h)
{
  const IntegerGrid& plane = mesh.GetPlane();
  const GridPoint p = mesh.Place(h);
  const GridPoint q = mesh.Place(ExtractionMesh::Next(h));
  const Vector3 start = mesh.Position(mesh.Tail(h));
  const Vector3 end = mesh.Position(mesh.Head(h));
  for (int turn = 0; turn < plane.GetDegree() / 2; ++turn)
  {
    const GridPoint from = plane.Turned(p, -turn);
    const GridPoint to = plane.Turned(q, -turn);
    if (from.B != to.B || (from.B & (IntegerGrid::Unit - 1)) != 0 || from.A == to.A)
    {
      continue;
    }
    const bool isForward = to.A > from.A;
    const std::int64_t low = std::min(from.A, to.A);
    const std::int64_t high = std::max(from.A, to.A);
    std::vector<std::int64_t> between;
    for (std::int64_t k = FloorOf(low) + 1; k * IntegerGrid::Unit < high; ++k)
    {
      between.push_back(k * IntegerGrid::Unit);
    }
    if (!isForward)
    {
      std::reverse(between.begin(), between.end());
    }
    Index edge = h;
    for (const std::int64_t a : between)
    {
      const double s = static_cast<double>(a - from.A) / static_cast<double>(to.A - from.A);
      const GridPoint place = plane.Turned({ a, from.B }, turn);
      // The rest of the edge is the first half-edge of the first triangle that is added.
      const Index rest = 3 * mesh.GetNumberOfTriangles();
      mesh.SetKept(mesh.SplitEdge(edge, place, start + s * (end - start)), true);
      edge = rest;
    }
    return;
  }
}

/// Puts the grid points inside of a triangle into it, and onto its edges.
class TriangleFiller
{
public:
  explicit TriangleFiller(ExtractionMesh& mesh)
    : Mesh(mesh)
  {
  }

  void Fill(Index t)
  {
    std::array<GridPoint, 3> p;
    std::array<Vector3, 3> positions;
    for (int c = 0; c < 3; ++c)
    {
      p[c] = this->Mesh.Place(3 * t + c);
      positions[c] = this->Mesh.Position(this->Mesh.Tail(3 * t + c));
    }
    const auto [lowA, highA] = std::minmax({ p[0].A, p[1].A, p[2].A });
    const auto [lowB, highB] = std::minmax({ p[0].B, p[1].B, p[2].B });
    const double total = Area(p[0], p[1], p[2]);
    std::vector<Point> points;
    for (std::int64_t b = FloorOf(lowB + IntegerGrid::Unit - 1); b * IntegerGrid::Unit <= highB;
         ++b)
    {
      // Of a row only the part between the sides: a sliver across the grid has few points.
      std::int64_t from = highA;
      std::int64_t to = lowA;
      this->RowRange(p, b * IntegerGrid::Unit, from, to);
      for (std::int64_t a = FloorOf(from + IntegerGrid::Unit - 1); a * IntegerGrid::Unit <= to; ++a)
      {
        const GridPoint place{ a * IntegerGrid::Unit, b * IntegerGrid::Unit };
        bool isInside = true;
        for (int c = 0; c < 3; ++c)
        {
          isInside = isInside && IntegerGrid::Orientation(p[c], p[(c + 1) % 3], place) >= 0;
        }
        if (isInside)
        {
          const double u = Area(place, p[1], p[2]) / total;
          const double v = Area(p[0], place, p[2]) / total;
          points.push_back({ Mixed(place), place,
            u * positions[0] + v * positions[1] + (1.0 - u - v) * positions[2] });
        }
      }
    }
    // Row by row, all would be joined with the same few corners.
    if (points.size() > FewPoints)
    {
      std::sort(
        points.begin(), points.end(), [](const Point& a, const Point& b) { return a.Key < b.Key; });
    }
    this->Parts.clear();
    this->FirstTriangle = t;
    this->FirstNew = this->Mesh.GetNumberOfTriangles();
    this->PartOf.clear();
    this->AddPart(t);
    for (const Point& point : points)
    {
      this->Insert(point.Place, point.Position);
    }
  }

private:
  static double Area(const GridPoint& p, const GridPoint& q, const GridPoint& r)
  {
    const GridPoint u = q - p;
    const GridPoint v = r - p;
    return static_cast<double>(u.A) * static_cast<double>(v.B) -
      static_cast<double>(u.B) * static_cast<double>(v.A);
  }

  /// Where the row b crosses a triangle, a little widened.
  static void RowRange(
    const std::array<GridPoint, 3>& p, std::int64_t b, std::int64_t& from, std::int64_t& to)
  {
    for (int c = 0; c < 3; ++c)
    {
      const GridPoint& q = p[c];
      const GridPoint& r = p[(c + 1) % 3];
      if (std::min(q.B, r.B) > b || std::max(q.B, r.B) < b)
      {
        continue;
      }
      if (q.B == r.B)
      {
        from = std::min({ from, q.A, r.A });
        to = std::max({ to, q.A, r.A });
        continue;
      }
      const double s = static_cast<double>(b - q.B) / static_cast<double>(r.B - q.B);
      const std::int64_t a = q.A + std::llround(s * static_cast<double>(r.A - q.A));
      from = std::min(from, a - 2);
      to = std::max(to, a + 2);
    }
  }

  struct Point
  {
    std::uint64_t Key;
    GridPoint Place;
    Vector3 Position;
  };
  /// As good as random, one number for each place (G. Steele et al.: Fast Splittable Pseudorandom
  /// Number Generators, 2014).
  static std::uint64_t Mixed(const GridPoint& place)
  {
    std::uint64_t x = static_cast<std::uint64_t>(place.A) * 0x9e3779b97f4a7c15u +
      static_cast<std::uint64_t>(place.B);
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
  }

  /// A triangle that was once a part: its corners, and the parts that it was cut into.
  struct Part
  {
    std::array<GridPoint, 3> Places;
    Index Triangle;
    std::array<Index, 3> Children{ None, None, None };
  };
  Index AddPart(Index t)
  {
    const auto number = static_cast<Index>(this->Parts.size());
    this->Parts.push_back(
      { { this->Mesh.Place(3 * t), this->Mesh.Place(3 * t + 1), this->Mesh.Place(3 * t + 2) }, t });
    if (t >= this->FirstNew)
    {
      this->PartOf.resize(this->Mesh.GetNumberOfTriangles() - this->FirstNew, None);
      this->PartOf[t - this->FirstNew] = number;
    }
    else
    {
      this->FirstPart = number;
    }
    return number;
  }
  /// The part that a triangle is now, or None.
  Index FindPart(Index t) const
  {
    if (t < this->FirstNew)
    {
      return t == this->FirstTriangle ? this->FirstPart : None;
    }
    const Index at = t - this->FirstNew;
    return at < static_cast<Index>(this->PartOf.size()) ? this->PartOf[at] : None;
  }
  static bool IsIn(const Part& part, const GridPoint& place)
  {
    return IntegerGrid::Orientation(part.Places[0], part.Places[1], place) >= 0 &&
      IntegerGrid::Orientation(part.Places[1], part.Places[2], place) >= 0 &&
      IntegerGrid::Orientation(part.Places[2], part.Places[0], place) >= 0;
  }
  /// Descends to the part that contains a point: with points in random order that takes about the
  /// logarithm of their number.
  Index Locate(const GridPoint& place) const
  {
    Index at = 0;
    while (this->Parts[at].Children[0] != None)
    {
      const std::array<Index, 3>& children = this->Parts[at].Children;
      const auto* const child = std::find_if(children.begin(), children.end(),
        [&](Index k) { return k != None && IsIn(this->Parts[k], place); });
      if (child == children.end())
      {
        return None;
      }
      at = *child;
    }
    return at;
  }

  /// Finds the part of the triangle that a point is in, and splits it, or its edge.
  void Insert(const GridPoint& place, const Vector3& position)
  {
    const Index part = this->Locate(place);
    if (part == None)
    {
      return;
    }
    const Index t = this->Parts[part].Triangle;
    int zero = -1;
    int zeros = 0;
    for (int c = 0; c < 3; ++c)
    {
      if (IntegerGrid::Orientation(this->Mesh.Place(3 * t + c),
            this->Mesh.Place(ExtractionMesh::Next(3 * t + c)), place) == 0)
      {
        zero = c;
        ++zeros;
      }
    }
    const Index before = this->Mesh.GetNumberOfTriangles();
    if (zeros == 0)
    {
      this->Mesh.SetKept(this->Mesh.SplitTriangle(t, place, position), true);
      this->Divide(part, { t, before, before + 1 });
    }
    else if (zeros == 1 && !this->Mesh.IsFeature(3 * t + zero))
    {
      // The triangle on the other side may be another part of this one.
      const Index twin = this->Mesh.Twin(3 * t + zero);
      const Index beyond = twin != None ? this->FindPart(twin / 3) : None;
      this->Mesh.SetKept(this->Mesh.SplitEdge(3 * t + zero, place, position), true);
      this->Divide(part, { t, before, None });
      if (beyond != None)
      {
        this->Divide(beyond, { twin / 3, before + 1, None });
      }
    }
  }
  void Divide(Index part, const std::array<Index, 3>& triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index child = triangles[k] != None ? this->AddPart(triangles[k]) : None;
      this->Parts[part].Children[k] = child;
    }
  }

  /// This number of points is searched for just as quickly in any order.
  static constexpr std::size_t FewPoints = 8;
  ExtractionMesh& Mesh;
  /// The first one is the whole triangle.
  std::vector<Part> Parts;
  /// The triangle that is being filled, whose number stays with one part, and the triangles that
  /// were added after it.
  Index FirstTriangle = None;
  Index FirstPart = 0;
  Index FirstNew = 0;
  std::vector<Index> PartOf;
};
}

void InsertGridPoints(ExtractionMesh& mesh)
{
  const Index triangles = mesh.GetNumberOfTriangles();
  for (Index h = 0; h < 3 * triangles; ++h)
  {
    if (mesh.IsPositive(h / 3) && IntegerGrid::IsGridPoint(mesh.Place(h)))
    {
      mesh.SetKept(mesh.Tail(h), true);
    }
    if (mesh.IsFeature(h) && IntegerGrid::IsGridPoint(mesh.Place(h)))
    {
      mesh.SetKept(mesh.Tail(h), true);
    }
  }
  // Where one edge of a triangle is split, another one gets a new number.
  for (Index h = 0; h < 3 * mesh.GetNumberOfTriangles(); ++h)
  {
    if (mesh.IsFeature(h))
    {
      SplitFeature(mesh, h);
    }
  }
  // A split edge leaves a part of the triangle beyond behind, which has its turn, too.
  TriangleFiller filler(mesh);
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    if (mesh.IsPositive(t))
    {
      filler.Fill(t);
    }
  }
  std::vector<Index> edges;
  for (Index h = 3 * mesh.GetNumberOfTriangles() - 1; h >= 0; --h)
  {
    if (mesh.Twin(h) > h)
    {
      edges.push_back(h);
    }
  }
  MakeDelaunay(mesh, edges);
}
}
