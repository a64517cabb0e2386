// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Geometry/Connection.h"

#include "Support/PointOrder.h"
#include "Support/Threads.h"

namespace DirectionFields
{
Connection::Connection(
  const TriangleMesh& mesh, const Metric& metric, const std::vector<Vector3>& positions)
  : EdgeAngle(mesh.GetNumberOfHalfEdges())
  , Scale(mesh.GetNumberOfVertices())
  , AngleSum(mesh.GetNumberOfVertices())
  , Rotation(mesh.GetNumberOfEdges())
  , Curvature(mesh.GetNumberOfTriangles())
{
  // The corner angles first stand where the sums of those before them come.
  LargeArray<double>& cornerAngle = this->EdgeAngle;
  ParallelFor(mesh.GetNumberOfTriangles(), MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        const std::array<double, 3> angles = metric.CornerAngles(mesh, t);
        std::copy(angles.begin(), angles.end(), cornerAngle.begin() + 3 * t);
      }
    });
  ParallelFor(mesh.GetNumberOfVertices(), MediumPiece,
    [&](Index begin, Index end)
    {
      std::vector<Index> fan;
      for (Index v = begin; v < end; ++v)
      {
        mesh.GetFan(v, fan);
        const bool boundary = mesh.IsBoundary(v);
        std::size_t reference = 0;
        double sum = 0.0;
        for (std::size_t k = 0; k < fan.size(); ++k)
        {
          sum += cornerAngle[fan[k]];
          if (!boundary &&
            LexicographicallyLess(
              positions[mesh.Head(fan[k])], positions[mesh.Head(fan[reference])]))
          {
            reference = k;
          }
        }
        const double scale = boundary ? 1.0 : 2.0 * Pi / sum;
        this->Scale[v] = scale;
        this->AngleSum[v] = boundary ? sum : 2.0 * Pi;
        double angle = 0.0;
        for (std::size_t k = 0; k < fan.size(); ++k)
        {
          const std::size_t behind = reference + k;
          const std::size_t at = behind < fan.size() ? behind : behind - fan.size();
          const double corner = scale * cornerAngle[fan[at]];
          this->EdgeAngle[fan[at]] = angle;
          angle += corner;
        }
      }
    });
  this->Connect(mesh);
}

void Connection::Connect(const TriangleMesh& mesh)
{
  ParallelFor(mesh.GetNumberOfEdges(), MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index e = begin; e < end; ++e)
      {
        const Index h = mesh.HalfEdge(e);
        const Index twin = mesh.Twin(h);
        const double back = twin == None ? this->AngleSum[mesh.Head(h)] : this->EdgeAngle[twin];
        this->Rotation[e] = back + Pi - this->EdgeAngle[h];
      }
    });
  ParallelFor(mesh.GetNumberOfTriangles(), MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        this->Curvature[t] = this->CornerAngle(mesh, 3 * t) + this->CornerAngle(mesh, 3 * t + 1) +
          this->CornerAngle(mesh, 3 * t + 2) - Pi;
      }
    });
}
}
