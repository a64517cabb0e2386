// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Extraction/Pairing.h"

#include <algorithm>
#include <tuple>

namespace DirectionFields::Internal
{
namespace
{
/// The edge is the diagonal of a unit square of the grid.
bool IsHypotenuse(const ExtractionMesh& mesh, Index h)
{
  const Index g = mesh.Twin(h);
  if (!mesh.IsPositive(h / 3) || !mesh.IsPositive(g / 3))
  {
    return false;
  }
  const GridPoint& a = mesh.Place(h);
  const GridPoint& b = mesh.Place(ExtractionMesh::Next(h));
  const GridPoint& c = mesh.Place(ExtractionMesh::Previous(h));
  const GridPoint d =
    mesh.GetPlane().Apply(mesh.Across(h), mesh.Place(ExtractionMesh::Previous(g)));
  const GridPoint side = c - a;
  const bool isUnit = (side.A == 0 && std::abs(side.B) == IntegerGrid::Unit) ||
    (side.B == 0 && std::abs(side.A) == IntegerGrid::Unit);
  const GridPoint diagonal = b - a;
  return IntegerGrid::IsGridPoint(a) && isUnit && std::abs(diagonal.A) == IntegerGrid::Unit &&
    std::abs(diagonal.B) == IntegerGrid::Unit && a + b == c + d;
}

bool IsUnitTriangle(const ExtractionMesh& mesh, Index t)
{
  const GridPoint& a = mesh.Place(3 * t);
  const GridPoint& b = mesh.Place(3 * t + 1);
  const GridPoint& c = mesh.Place(3 * t + 2);
  return IntegerGrid::IsGridPoint(a) && mesh.IsPositive(t) &&
    mesh.GetPlane().Turned(b - a, 1) == c - a && IntegerGrid::IsGridPoint(b) &&
    std::abs(std::norm(mesh.GetPlane().Place(b - a)) - 1.0) < 1e-9;
}

class Pairs
{
public:
  explicit Pairs(const ExtractionMesh& mesh)
    : Mesh(mesh)
    , Partner(mesh.GetNumberOfTriangles(), None)
    , FacesAt(mesh.GetNumberOfVertices(), 0)
    , OnBoundary(mesh.GetNumberOfVertices(), 0)
  {
    for (Index h = 0; h < 3 * mesh.GetNumberOfTriangles(); ++h)
    {
      if (mesh.IsTriangle(h / 3))
      {
        ++this->FacesAt[mesh.Tail(h)];
        if (mesh.Twin(h) == None)
        {
          this->OnBoundary[mesh.Tail(h)] = this->OnBoundary[mesh.Head(h)] = 1;
        }
      }
    }
  }

  bool IsCandidate(Index h) const
  {
    const Index g = this->Mesh.Twin(h);
    return g > h && !this->Mesh.IsFeature(h) && this->Partner[h / 3] == None &&
      this->Partner[g / 3] == None;
  }
  void Join(Index h)
  {
    const Index g = this->Mesh.Twin(h);
    const auto keepsEnough = [&](Index v)
    { return this->OnBoundary[v] != 0 ? this->FacesAt[v] > 1 : this->FacesAt[v] > 3; };
    if (this->IsCandidate(h) && keepsEnough(this->Mesh.Tail(h)) && keepsEnough(this->Mesh.Head(h)))
    {
      this->Partner[h / 3] = h;
      this->Partner[g / 3] = g;
      --this->FacesAt[this->Mesh.Tail(h)];
      --this->FacesAt[this->Mesh.Head(h)];
    }
  }
  Faces::Face QuadOver(Index h) const
  {
    return { this->Mesh.Tail(h), this->Mesh.Tail(ExtractionMesh::Previous(this->Mesh.Twin(h))),
      this->Mesh.Head(h), this->Mesh.Tail(ExtractionMesh::Previous(h)) };
  }

  /// Joins an unpaired triangle with another one along few quads between them, whose triangles are
  /// paired differently: a shortest alternating path.
  void Augment(Index first, const std::vector<Vector3>& points)
  {
    // The half-edge over which each triangle of the path would be joined, and the triangle whose
    // partner it was before.
    struct Visit
    {
      Index Triangle;
      Index From;
      Index HalfEdge;
      int Length;
    };
    std::vector<Visit> visits = { { first, None, None, 0 } };
    std::vector<Index> seen = { first };
    for (std::size_t k = 0; k < visits.size() && visits[k].Length < LongestPath; ++k)
    {
      for (Index h = 3 * visits[k].Triangle; h < 3 * visits[k].Triangle + 3; ++h)
      {
        const Index g = this->Mesh.Twin(h);
        if (g == None || this->Mesh.IsFeature(h) ||
          std::find(seen.begin(), seen.end(), g / 3) != seen.end() ||
          ScaledJacobian(points, this->QuadOver(h)) <= LeastQuality)
        {
          continue;
        }
        const Index partner = this->Partner[g / 3];
        if (partner == None)
        {
          std::vector<Index> path = { h };
          for (std::size_t i = k; visits[i].From != None; i = visits[i].From)
          {
            path.push_back(visits[i].HalfEdge);
          }
          if (this->Follow(path))
          {
            return;
          }
          continue;
        }
        const Index freed = this->Mesh.Twin(partner) / 3;
        if (std::find(seen.begin(), seen.end(), freed) == seen.end())
        {
          seen.insert(seen.end(), { g / 3, freed });
          visits.push_back({ freed, static_cast<Index>(k), h, visits[k].Length + 1 });
        }
      }
    }
  }

  const ExtractionMesh& Mesh;
  /// The half-edge over which each triangle is joined to another one.
  std::vector<Index> Partner;

private:
  static constexpr int LongestPath = 6;

  void Set(Index h, bool isJoined)
  {
    const Index g = this->Mesh.Twin(h);
    const int change = isJoined ? -1 : 1;
    this->Partner[h / 3] = isJoined ? h : None;
    this->Partner[g / 3] = isJoined ? g : None;
    this->FacesAt[this->Mesh.Tail(h)] += change;
    this->FacesAt[this->Mesh.Head(h)] += change;
  }
  /// Pairs the triangles along these edges, unless that leaves a vertex with too few faces.
  bool Follow(const std::vector<Index>& path)
  {
    std::vector<Index> before;
    for (const Index h : path)
    {
      for (const Index t : { h / 3, this->Mesh.Twin(h) / 3 })
      {
        const Index old = this->Partner[t];
        if (old != None)
        {
          before.push_back(old);
          this->Set(old, false);
        }
      }
    }
    bool isSound = true;
    for (const Index h : path)
    {
      this->Set(h, true);
    }
    for (const Index h : path)
    {
      for (const Index v : { this->Mesh.Tail(h), this->Mesh.Head(h) })
      {
        isSound = isSound && this->FacesAt[v] >= (this->OnBoundary[v] != 0 ? 1 : 3);
      }
    }
    if (!isSound)
    {
      for (const Index h : path)
      {
        this->Set(h, false);
      }
      for (const Index h : before)
      {
        this->Set(h, true);
      }
    }
    return isSound;
  }

  std::vector<Index> FacesAt;
  std::vector<char> OnBoundary;
};
}

Faces PairTriangles(const ExtractionMesh& mesh)
{
  Faces faces;
  const Index halfEdges = 3 * mesh.GetNumberOfTriangles();
  Pairs pairs(mesh);
  std::vector<char> isSquare(mesh.GetNumberOfTriangles(), 0);
  if (mesh.GetPlane().GetDegree() == 4)
  {
    std::vector<Vector3> points(mesh.GetNumberOfVertices());
    for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      points[v] = mesh.Position(v);
    }
    for (Index h = 0; h < halfEdges; ++h)
    {
      if (mesh.IsTriangle(h / 3) && pairs.IsCandidate(h) && IsHypotenuse(mesh, h))
      {
        pairs.Join(h);
        isSquare[h / 3] = pairs.Partner[h / 3] != None ? 1 : 0;
        isSquare[mesh.Twin(h) / 3] = isSquare[h / 3];
      }
    }
    std::vector<std::tuple<double, Index>> others;
    for (Index h = 0; h < halfEdges; ++h)
    {
      if (mesh.IsTriangle(h / 3) && pairs.IsCandidate(h))
      {
        const double quality = ScaledJacobian(points, pairs.QuadOver(h));
        if (quality > LeastQuality)
        {
          others.emplace_back(-quality, h);
        }
      }
    }
    std::sort(others.begin(), others.end());
    for (const auto& [quality, h] : others)
    {
      pairs.Join(h);
    }
    for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
    {
      if (mesh.IsTriangle(t) && pairs.Partner[t] == None)
      {
        pairs.Augment(t, points);
      }
    }
  }
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    if (!mesh.IsTriangle(t))
    {
      continue;
    }
    const Index h = pairs.Partner[t];
    if (h == None)
    {
      faces.Corners.push_back(
        { mesh.Tail(3 * t), mesh.Tail(3 * t + 1), mesh.Tail(3 * t + 2), None });
      faces.IsRegular.push_back(
        mesh.GetPlane().GetDegree() == 6 && IsUnitTriangle(mesh, t) ? 1 : 0);
    }
    else if (mesh.Twin(h) > h)
    {
      faces.Corners.push_back(pairs.QuadOver(h));
      faces.IsRegular.push_back(isSquare[t] != 0 && IsHypotenuse(mesh, h) ? 1 : 0);
    }
  }
  return faces;
}
}
