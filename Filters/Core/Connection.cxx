// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Connection.h"

namespace DirectionFields
{
Connection::Connection(
  const TriangleMesh& mesh, const Metric& metric, const std::vector<Vector3>& points)
  : CornerAngle(mesh.GetNumberOfHalfEdges())
  , EdgeAngle(mesh.GetNumberOfHalfEdges())
  , AngleSum(mesh.GetNumberOfVertices())
  , Rotation(mesh.GetNumberOfEdges())
  , Curvature(mesh.GetNumberOfTriangles())
{
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const bool boundary = mesh.IsBoundary(v);
    Index reference = mesh.Outgoing(v);
    double sum = 0.0;
    Index h = mesh.Outgoing(v);
    do
    {
      sum += metric.CornerAngle[h];
      if (!boundary &&
        LexicographicallyLess(
          points[mesh.Point(mesh.Head(h))], points[mesh.Point(mesh.Head(reference))]))
      {
        reference = h;
      }
      h = mesh.NextOutgoing(h);
    } while (h != None && h != mesh.Outgoing(v));

    const double scale = boundary ? 1.0 : 2.0 * Pi / sum;
    this->AngleSum[v] = boundary ? sum : 2.0 * Pi;
    double angle = 0.0;
    h = reference;
    do
    {
      this->EdgeAngle[h] = angle;
      this->CornerAngle[h] = scale * metric.CornerAngle[h];
      angle += this->CornerAngle[h];
      h = mesh.NextOutgoing(h);
    } while (h != None && h != reference);
  }
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = mesh.HalfEdge(e);
    const Index twin = mesh.Twin(h);
    const double back = twin == None ? this->AngleSum[mesh.Head(h)] : this->EdgeAngle[twin];
    this->Rotation[e] = back + Pi - this->EdgeAngle[h];
  }
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    this->Curvature[t] =
      this->CornerAngle[3 * t] + this->CornerAngle[3 * t + 1] + this->CornerAngle[3 * t + 2] - Pi;
  }
}
}
