// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TangentFrames.h"

namespace DirectionFields
{
namespace
{
/// Unit vector orthogonal to a unit vector.
Vector3 AnyOrthogonal(const Vector3& n)
{
  Eigen::Index smallest;
  n.cwiseAbs().minCoeff(&smallest);
  return n.cross(Vector3::Unit(smallest)).normalized();
}
}

TangentFrames::TangentFrames(const TriangleMesh& mesh, const Metric& metric,
  const Connection& connection, const std::vector<Vector3>& points)
  : Normal(mesh.GetNumberOfVertices())
  , X(mesh.GetNumberOfVertices())
  , Y(mesh.GetNumberOfVertices())
{
  const auto point = [&](Index v) -> const Vector3& { return points[mesh.Point(v)]; };
  std::vector<Vector3> triangleNormal(mesh.GetNumberOfTriangles());
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    const Vector3& a = point(mesh.Tail(3 * t));
    triangleNormal[t] = (point(mesh.Tail(3 * t + 1)) - a)
                          .stableNormalized()
                          .cross((point(mesh.Tail(3 * t + 2)) - a).stableNormalized())
                          .stableNormalized();
  }
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const Index first = mesh.Outgoing(v);
    Vector3 sum = Vector3::Zero();
    Index h = first;
    do
    {
      sum += metric.CornerAngle[h] * triangleNormal[h / 3];
      h = mesh.NextOutgoing(h);
    } while (h != None && h != first);
    Vector3 normal = sum.stableNormalized();
    if (normal.isZero())
    {
      const Vector3 edge = (point(mesh.Head(first)) - point(v)).stableNormalized();
      normal = edge.isZero() ? Vector3::UnitZ().eval() : AnyOrthogonal(edge);
    }

    const Vector3 a = AnyOrthogonal(normal);
    const Vector3 b = normal.cross(a);
    Complex fit = 0.0;
    const auto addEdge = [&](Index neighbour, double angle)
    {
      const Vector3 edge = (point(neighbour) - point(v)).stableNormalized();
      const Complex projected(edge.dot(a), edge.dot(b));
      const double length = std::abs(projected);
      // An edge along the normal has no direction in the tangent plane.
      if (length > 1e-12)
      {
        fit += projected / length * std::polar(1.0, -angle);
      }
    };
    h = first;
    Index last = first;
    do
    {
      addEdge(mesh.Head(h), connection.EdgeAngle[h]);
      last = h;
      h = mesh.NextOutgoing(h);
    } while (h != None && h != first);
    if (h == None)
    {
      addEdge(mesh.Tail(TriangleMesh::Previous(last)), connection.AngleSum[v]);
    }
    const double length = std::abs(fit);
    fit = length > 1e-12 ? fit / length : Complex(1.0);
    this->Normal[v] = normal;
    this->X[v] = fit.real() * a + fit.imag() * b;
    this->Y[v] = normal.cross(this->X[v]);
  }
}
}
