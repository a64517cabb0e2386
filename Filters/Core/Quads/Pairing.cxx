// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Quads/Pairing.h"

#include <algorithm>
#include <tuple>

namespace DirectionFields::Internal
{
namespace
{
/// The edge is the diagonal of a unit square of the lattice.
bool IsHypotenuse(const CellMesh& mesh, Index h)
{
  const Index g = mesh.Twin(h);
  if (!mesh.IsPositive(h / 3) || !mesh.IsPositive(g / 3))
  {
    return false;
  }
  const LatticePoint& a = mesh.Place(h);
  const LatticePoint& b = mesh.Place(CellMesh::Next(h));
  const LatticePoint& c = mesh.Place(CellMesh::Previous(h));
  const LatticePoint d = mesh.GetPlane().Apply(mesh.Across(h), mesh.Place(CellMesh::Previous(g)));
  const LatticePoint side = c - a;
  const bool isUnit = (side.A == 0 && std::abs(side.B) == Lattice::Unit) ||
    (side.B == 0 && std::abs(side.A) == Lattice::Unit);
  const LatticePoint diagonal = b - a;
  return Lattice::IsLatticePoint(a) && isUnit && std::abs(diagonal.A) == Lattice::Unit &&
    std::abs(diagonal.B) == Lattice::Unit && a + b == c + d;
}

bool IsUnitTriangle(const CellMesh& mesh, Index t)
{
  const LatticePoint& a = mesh.Place(3 * t);
  const LatticePoint& b = mesh.Place(3 * t + 1);
  const LatticePoint& c = mesh.Place(3 * t + 2);
  return Lattice::IsLatticePoint(a) && mesh.IsPositive(t) &&
    mesh.GetPlane().Turned(b - a, 1) == c - a && Lattice::IsLatticePoint(b) &&
    std::abs(std::norm(mesh.GetPlane().Place(b - a)) - 1.0) < 1e-9;
}

class Pairs
{
public:
  explicit Pairs(const CellMesh& mesh)
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
    return { this->Mesh.Tail(h), this->Mesh.Tail(CellMesh::Previous(this->Mesh.Twin(h))),
      this->Mesh.Head(h), this->Mesh.Tail(CellMesh::Previous(h)) };
  }

  const CellMesh& Mesh;
  /// The half-edge over which each triangle is joined to another one.
  std::vector<Index> Partner;

private:
  std::vector<Index> FacesAt;
  std::vector<char> OnBoundary;
};
}

Faces PairTriangles(const CellMesh& mesh)
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
      faces.IsRegular.push_back(isSquare[t]);
    }
  }
  return faces;
}
}
