// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SolverFiles/EdgeMiddles.h"

#include "SolverFiles/ShellChecks.h"

#include <cmath>
#include <cstddef>

namespace DirectionFields::Internal
{
namespace
{
/// The cosine of the largest angle between normals, and of lines, that is smooth: 40 degrees.
constexpr double Smooth = 0.766;
/// Of a middle from the straight one, in lengths of the edge.
constexpr double MostBent = 0.125;

class Middles
{
public:
  Middles(const ShellMesh& mesh, const ShellEdges& edges)
    : Mesh(mesh)
    , Edges(edges)
    , FacesAtPoint(mesh.Points.size())
    , FacesAtEdge(edges.Ends.size())
    , LinesAtPoint(mesh.Points.size())
  {
    for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
    {
      this->Normals.push_back(NormalOf(mesh, mesh.Faces[f]).stableNormalized());
      for (int k = 0; k < CornersOf(mesh.Faces[f]); ++k)
      {
        this->FacesAtPoint[mesh.Faces[f][k]].push_back(f);
        this->FacesAtEdge[edges.OfFace[f][k]].push_back(f);
      }
    }
    for (std::size_t e = 0; e < edges.Ends.size(); ++e)
    {
      if (this->IsLine(e))
      {
        this->LinesAtPoint[edges.Ends[e][0]].push_back(edges.Ends[e][1]);
        this->LinesAtPoint[edges.Ends[e][1]].push_back(edges.Ends[e][0]);
      }
    }
  }

  Vector3 At(std::size_t e) const
  {
    const Index from = this->Edges.Ends[e][0];
    const Index to = this->Edges.Ends[e][1];
    const Vector3& a = this->Mesh.Points[from];
    const Vector3& b = this->Mesh.Points[to];
    // Halves first: the sum of large coordinates may be no number.
    const Vector3 straight = 0.5 * a + 0.5 * b;
    const Vector3 edge = b - a;
    const Vector3 along = edge.stableNormalized();
    const bool isLine = this->IsLine(e);
    Vector3 atA = isLine ? this->DirectionAt(from, to) : this->DirectionWithin(e, from, along);
    Vector3 atB =
      isLine ? Vector3(-this->DirectionAt(to, from)) : this->DirectionWithin(e, to, along);
    // Where a line or the surface ends an edge is bent as it is at its other end.
    const auto mirrored = [&](const Vector3& d) { return Vector3(2.0 * along.dot(d) * along - d); };
    atA = atA.isZero(0.0) ? mirrored(atB) : atA;
    atB = atB.isZero(0.0) ? mirrored(atA) : atB;
    // By these lengths a cubic curve goes through the middle of a circle's arc.
    const Vector3 bend =
      0.25 * edge.norm() * (atA / (1.0 + along.dot(atA)) - atB / (1.0 + along.dot(atB)));
    return bend.norm() <= MostBent * edge.norm() ? Vector3(straight + bend) : straight;
  }

private:
  bool IsLine(std::size_t e) const
  {
    const std::vector<std::size_t>& faces = this->FacesAtEdge[e];
    // Neighbours may be wound in either way.
    return faces.size() != 2 ||
      std::abs(this->Normals[faces[0]].dot(this->Normals[faces[1]])) < Smooth;
  }

  /// The mean normal of the faces at a point that are smooth with one.
  Vector3 NormalAt(Index point, const Vector3& like) const
  {
    Vector3 sum = Vector3::Zero();
    for (const std::size_t f : this->FacesAtPoint[point])
    {
      const double along = this->Normals[f].dot(like);
      sum += std::abs(along) < Smooth ? Vector3(Vector3::Zero())
        : along > 0.0                 ? this->Normals[f]
                                      : Vector3(-this->Normals[f]);
    }
    return sum.stableNormalized();
  }

  /// The direction of an edge at one of its ends, along the faces there; zero at the end of the
  /// surface, where faces are on one side only.
  Vector3 DirectionWithin(std::size_t e, Index at, const Vector3& along) const
  {
    if (!this->LinesAtPoint[at].empty())
    {
      return Vector3::Zero();
    }
    const Vector3& one = this->Normals[this->FacesAtEdge[e][0]];
    const Vector3& other = this->Normals[this->FacesAtEdge[e][1]];
    const Vector3 normal = this->NormalAt(
      at, (one + (one.dot(other) > 0.0 ? other : Vector3(-other))).stableNormalized());
    return (along - along.dot(normal) * normal).stableNormalized();
  }

  /// The direction of a line at a point, from there to the next one; zero where it ends.
  Vector3 DirectionAt(Index point, Index next) const
  {
    const std::vector<Index>& ends = this->LinesAtPoint[point];
    if (ends.size() != 2)
    {
      return Vector3::Zero();
    }
    const Vector3& at = this->Mesh.Points[point];
    const Vector3 in = at - this->Mesh.Points[ends[0] == next ? ends[1] : ends[0]];
    const Vector3 out = this->Mesh.Points[next] - at;
    if (in.stableNormalized().dot(out.stableNormalized()) < Smooth)
    {
      return Vector3::Zero();
    }
    // Of the circle through the three points.
    return (in * (out.norm() / in.norm()) + out * (in.norm() / out.norm())).stableNormalized();
  }

  const ShellMesh& Mesh;
  const ShellEdges& Edges;
  std::vector<Vector3> Normals;
  std::vector<std::vector<std::size_t>> FacesAtPoint;
  std::vector<std::vector<std::size_t>> FacesAtEdge;
  /// Where lines lead to from each point.
  std::vector<std::vector<Index>> LinesAtPoint;
};
}

std::vector<Vector3> MiddlesOf(const ShellMesh& mesh, const ShellEdges& edges)
{
  const Middles middles(mesh, edges);
  std::vector<Vector3> places;
  for (std::size_t e = 0; e < edges.Ends.size(); ++e)
  {
    places.push_back(middles.At(e));
  }
  return places;
}
}
