// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/Creases.h"

#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// The least angle of a crease, radians.
constexpr double SharpAngle = Pi / 6.0;
/// The sharpness of a crease over that of the edges around it.
constexpr double Prominence = 3.0;
/// The least part of its angle that the normals at the vertices beyond its two triangles enclose.
constexpr double Support = 0.6;

/// The third largest of the angles around a vertex: the first two may belong to one crease.
float ThirdSharpest(const TriangleMesh& mesh, const std::vector<double>& angles, Index v)
{
  float first = 0.0F;
  float second = 0.0F;
  float third = 0.0F;
  const Index begin = mesh.Outgoing(v);
  Index h = begin;
  do
  {
    const auto angle = static_cast<float>(std::abs(angles[mesh.Edge(h)]));
    third = std::max(third, std::min(second, angle));
    second = std::max(second, std::min(first, angle));
    first = std::max(first, angle);
    h = mesh.NextOutgoing(h);
  } while (h != None && h != begin);
  return third;
}
}

Creases::Creases(const SurfaceGeometry& geometry, const std::vector<double>& dihedralAngles)
  : Edge(geometry.Mesh.GetNumberOfEdges(), 0)
  , Vertex(geometry.Mesh.GetNumberOfVertices(), 0)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const auto isCrease = [&](Index e)
  {
    const Index h = mesh.HalfEdge(e);
    const double angle = std::abs(dihedralAngles[e]);
    const double around = std::min(ThirdSharpest(mesh, dihedralAngles, mesh.Tail(h)),
      ThirdSharpest(mesh, dihedralAngles, mesh.Head(h)));
    if (angle <= Prominence * around)
    {
      return false;
    }
    const Vector3& left = geometry.Frames.Normal[mesh.Tail(TriangleMesh::Previous(h))];
    const Vector3& right = geometry.Frames.Normal[mesh.Tail(TriangleMesh::Previous(mesh.Twin(h)))];
    return std::acos(std::clamp(left.dot(right), -1.0, 1.0)) > Support * angle;
  };
  ParallelFor(mesh.GetNumberOfEdges(), MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index e = begin; e < end; ++e)
      {
        this->Edge[e] = std::abs(dihedralAngles[e]) > SharpAngle && isCrease(e) ? 1 : 0;
      }
    });
  this->FindVertices(mesh);
}

void Creases::FindVertices(const TriangleMesh& mesh)
{
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    if (this->Edge[e] != 0)
    {
      const Index h = mesh.HalfEdge(e);
      this->Vertex[mesh.Tail(h)] = 1;
      this->Vertex[mesh.Head(h)] = 1;
    }
  }
}

void Creases::DropSingleEdges(const TriangleMesh& mesh, const std::vector<char>& components,
  const std::function<void(std::vector<char>&)>& complete)
{
  // The only end of a crease at an interior vertex has the first value, at one on the boundary the
  // second one.
  constexpr char inside = 1;
  constexpr char outside = 2;
  constexpr char several = 3;
  std::vector<char> ends(this->Vertex.size(), 0);
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    if (this->Edge[e] != 0)
    {
      const Index h = mesh.HalfEdge(e);
      for (const Index v : { mesh.Tail(h), mesh.Head(h) })
      {
        const char one = mesh.IsBoundary(v) ? outside : inside;
        ends[v] = ends[v] == 0 ? one : several;
      }
    }
  }
  complete(ends);
  mesh.ForEachComponent(
    [&](Index c)
    {
      const TriangleMesh::Component& component = mesh.GetComponents()[c];
      for (Index e = component.FirstEdge; components[c] != 0 && e < component.EndEdge; ++e)
      {
        const Index h = mesh.HalfEdge(e);
        const int tail = ends[mesh.Tail(h)];
        const int head = ends[mesh.Head(h)];
        if (tail != several && head != several && tail + head < 2 * outside)
        {
          this->Edge[e] = 0;
        }
      }
    });
  std::fill(this->Vertex.begin(), this->Vertex.end(), 0);
  this->FindVertices(mesh);
  complete(this->Vertex);
}
}
