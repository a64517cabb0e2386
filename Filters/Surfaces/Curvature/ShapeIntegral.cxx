// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curvature/ShapeIntegral.h"

#include <array>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Where the corner opposite of an edge is, in the directions of the edge and across it.
struct Corner
{
  double Along;
  double Across;
};

/// @param edge, back, opposite squared lengths: of the edge, of the one from its tail to the
///              corner, and of the third one
Corner CornerBeside(double edge, double back, double opposite, double area)
{
  const double length = std::sqrt(edge);
  return { 0.5 * (edge + back - opposite) / length, 2.0 * area / length };
}

/// Half the integral of the angle over an edge of a triangulated quadric.
/// @param along, mixed, across second derivatives in the directions of the edge and across it
double HalfBend(
  double length, const Corner& left, const Corner& right, double along, double mixed, double across)
{
  const double leftBulge = left.Along * (left.Along - length) / left.Across;
  const double rightBulge = right.Along * (right.Along - length) / right.Across;
  const double jump = 0.5 * (leftBulge + rightBulge) * along + (left.Along - right.Along) * mixed +
    0.5 * (left.Across + right.Across) * across;
  return 0.5 * jump * length;
}

/// Whether a triangle at a vertex faces away from the surface at one of its corners.
bool IsFolded(const SurfaceGeometry& geometry, Index v)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const Index first = mesh.Outgoing(v);
  Index h = first;
  do
  {
    const std::array<Index, 3> corners = { v, mesh.Head(h), mesh.Tail(TriangleMesh::Previous(h)) };
    const Vector3& origin = geometry.Positions[v];
    const Vector3 normal =
      (geometry.Positions[corners[1]] - origin).cross(geometry.Positions[corners[2]] - origin);
    for (const Index corner : corners)
    {
      if (normal.dot(geometry.Frames.Normal[corner]) < 0.0)
      {
        return true;
      }
    }
    h = mesh.NextOutgoing(h);
  } while (h != None && h != first);
  return false;
}
}

WeightedShape ShapeIntegral(const SurfaceGeometry& geometry, Index v, const Shape& shape)
{
  const TriangleMesh& mesh = geometry.Mesh;
  double area = 0.0;
  const Index first = mesh.Outgoing(v);
  Index h = first;
  do
  {
    area += geometry.Lengths.Area[h / 3] / 3.0;
    h = mesh.NextOutgoing(h);
  } while (h != None && h != first);
  return { area * shape.Hopf, area * shape.Mean, area };
}

WeightedShape ShapeIntegral(
  const SurfaceGeometry& geometry, Index v, const Shape& edges, const Shape& estimate)
{
  if (IsFolded(geometry, v))
  {
    return ShapeIntegral(geometry, v, estimate);
  }
  const TriangleMesh& mesh = geometry.Mesh;
  const Metric& metric = geometry.Lengths;
  const auto squared = [&](Index h) { return metric.SquaredLength[mesh.Edge(h)]; };
  WeightedShape sum = ShapeIntegral(
    geometry, v, Shape{ estimate.Hopf + edges.Hopf, estimate.Mean + edges.Mean, 0.0 });
  const Index first = mesh.Outgoing(v);
  Index h = first;
  do
  {
    const Index twin = mesh.Twin(h);
    if (twin != None)
    {
      const Index left = TriangleMesh::Previous(h);
      const Index right = TriangleMesh::Next(twin);
      const double edge = squared(h);
      const Corner leftCorner =
        CornerBeside(edge, squared(left), squared(TriangleMesh::Next(h)), metric.Area[h / 3]);
      const Corner rightCorner = CornerBeside(
        edge, squared(right), squared(TriangleMesh::Previous(twin)), metric.Area[twin / 3]);
      const Complex turn = std::polar(1.0, 2.0 * geometry.Transport.EdgeAngle[h]);
      const Complex hopf = estimate.Hopf * std::conj(turn);
      const double half = 0.5 *
        HalfBend(std::sqrt(edge), leftCorner, rightCorner, estimate.Mean + hopf.real(), hopf.imag(),
          estimate.Mean - hopf.real());
      sum.Hopf += half * turn;
      sum.Mean -= half;
    }
    h = mesh.NextOutgoing(h);
  } while (h != None && h != first);
  return sum;
}
}
