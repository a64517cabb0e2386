// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Quads/LatticePoints.h"

#include "Quads/DelaunayFlips.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
std::int64_t FloorOf(std::int64_t x)
{
  return x >> Lattice::Bits;
}

/// Puts the lattice points of a feature edge on it, from its tail on.
void SplitFeature(CellMesh& mesh, Index h)
{
  const Lattice& plane = mesh.GetPlane();
  const LatticePoint p = mesh.Place(h);
  const LatticePoint q = mesh.Place(CellMesh::Next(h));
  const Vector3 start = mesh.Position(mesh.Tail(h));
  const Vector3 end = mesh.Position(mesh.Head(h));
  for (int turn = 0; turn < plane.GetDegree() / 2; ++turn)
  {
    const LatticePoint from = plane.Turned(p, -turn);
    const LatticePoint to = plane.Turned(q, -turn);
    if (from.B != to.B || (from.B & (Lattice::Unit - 1)) != 0 || from.A == to.A)
    {
      continue;
    }
    const bool isForward = to.A > from.A;
    const std::int64_t low = std::min(from.A, to.A);
    const std::int64_t high = std::max(from.A, to.A);
    std::vector<std::int64_t> between;
    for (std::int64_t k = FloorOf(low) + 1; k * Lattice::Unit < high; ++k)
    {
      between.push_back(k * Lattice::Unit);
    }
    if (!isForward)
    {
      std::reverse(between.begin(), between.end());
    }
    Index edge = h;
    for (const std::int64_t a : between)
    {
      const double s = static_cast<double>(a - from.A) / static_cast<double>(to.A - from.A);
      const LatticePoint place = plane.Turned({ a, from.B }, turn);
      // The rest of the edge is the first half-edge of the first triangle that is added.
      const Index rest = 3 * mesh.GetNumberOfTriangles();
      mesh.SetKept(mesh.SplitEdge(edge, place, start + s * (end - start)), true);
      edge = rest;
    }
    return;
  }
}

/// Puts the lattice points inside of a triangle into it, and onto its edges.
class TriangleFiller
{
public:
  explicit TriangleFiller(CellMesh& mesh)
    : Mesh(mesh)
  {
  }

  void Fill(Index t)
  {
    this->Parts.assign(1, t);
    std::array<LatticePoint, 3> p;
    std::array<Vector3, 3> positions;
    for (int c = 0; c < 3; ++c)
    {
      p[c] = this->Mesh.Place(3 * t + c);
      positions[c] = this->Mesh.Position(this->Mesh.Tail(3 * t + c));
    }
    const auto [lowA, highA] = std::minmax({ p[0].A, p[1].A, p[2].A });
    const auto [lowB, highB] = std::minmax({ p[0].B, p[1].B, p[2].B });
    const double total = Area(p[0], p[1], p[2]);
    for (std::int64_t b = FloorOf(lowB + Lattice::Unit - 1); b * Lattice::Unit <= highB; ++b)
    {
      // Of a row only what is between the sides: a sliver across the lattice has few points.
      std::int64_t from = highA;
      std::int64_t to = lowA;
      this->RowRange(p, b * Lattice::Unit, from, to);
      for (std::int64_t a = FloorOf(from + Lattice::Unit - 1); a * Lattice::Unit <= to; ++a)
      {
        const LatticePoint place{ a * Lattice::Unit, b * Lattice::Unit };
        bool isInside = true;
        for (int c = 0; c < 3; ++c)
        {
          isInside = isInside && Lattice::Orientation(p[c], p[(c + 1) % 3], place) >= 0;
        }
        if (isInside)
        {
          const double u = Area(place, p[1], p[2]) / total;
          const double v = Area(p[0], place, p[2]) / total;
          this->Insert(place, u * positions[0] + v * positions[1] + (1.0 - u - v) * positions[2]);
        }
      }
    }
  }

private:
  static double Area(const LatticePoint& p, const LatticePoint& q, const LatticePoint& r)
  {
    const LatticePoint u = q - p;
    const LatticePoint v = r - p;
    return static_cast<double>(u.A) * static_cast<double>(v.B) -
      static_cast<double>(u.B) * static_cast<double>(v.A);
  }

  /// Where the row b crosses a triangle, a little widened.
  static void RowRange(
    const std::array<LatticePoint, 3>& p, std::int64_t b, std::int64_t& from, std::int64_t& to)
  {
    for (int c = 0; c < 3; ++c)
    {
      const LatticePoint& q = p[c];
      const LatticePoint& r = p[(c + 1) % 3];
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

  /// Finds the part of the triangle that a point is in, and splits it, or its edge.
  void Insert(const LatticePoint& place, const Vector3& position)
  {
    for (auto part = this->Parts.rbegin(); part != this->Parts.rend(); ++part)
    {
      const Index t = *part;
      int zero = -1;
      int zeros = 0;
      bool isInside = true;
      for (int c = 0; c < 3 && isInside; ++c)
      {
        const int side = Lattice::Orientation(
          this->Mesh.Place(3 * t + c), this->Mesh.Place(CellMesh::Next(3 * t + c)), place);
        isInside = side >= 0;
        if (side == 0)
        {
          zero = c;
          ++zeros;
        }
      }
      if (!isInside)
      {
        continue;
      }
      if (zeros == 0)
      {
        const Index before = this->Mesh.GetNumberOfTriangles();
        this->Mesh.SetKept(this->Mesh.SplitTriangle(t, place, position), true);
        this->Parts.push_back(before);
        this->Parts.push_back(before + 1);
      }
      else if (zeros == 1 && !this->Mesh.IsFeature(3 * t + zero))
      {
        // The triangle on the other side may be another part of this one.
        const Index twin = this->Mesh.Twin(3 * t + zero);
        const bool isPart = twin != None &&
          std::find(this->Parts.begin(), this->Parts.end(), twin / 3) != this->Parts.end();
        const Index before = this->Mesh.GetNumberOfTriangles();
        this->Mesh.SetKept(this->Mesh.SplitEdge(3 * t + zero, place, position), true);
        this->Parts.push_back(before);
        if (isPart)
        {
          this->Parts.push_back(before + 1);
        }
      }
      return;
    }
  }

  CellMesh& Mesh;
  /// The parts of the triangle so far.
  std::vector<Index> Parts;
};
}

void InsertLatticePoints(CellMesh& mesh)
{
  const Index triangles = mesh.GetNumberOfTriangles();
  for (Index h = 0; h < 3 * triangles; ++h)
  {
    if (mesh.IsPositive(h / 3) && Lattice::IsLatticePoint(mesh.Place(h)))
    {
      mesh.SetKept(mesh.Tail(h), true);
    }
    if (mesh.IsFeature(h) && Lattice::IsLatticePoint(mesh.Place(h)))
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
