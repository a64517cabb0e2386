// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Field/Curvature.h"

#include "Sections/Assembly.h"
#include "Solvers/Systems/MassSystem.h"
#include "Support/Threads.h"

#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index PieceSize = 1 << 12;
}

Curvature::Curvature(const SurfaceGeometry& geometry, const std::vector<double>& dihedralAngles)
  : Hopf(geometry.Mesh.GetNumberOfVertices(), 0.0)
  , Mean(geometry.Mesh.GetNumberOfVertices())
  , Gaussian(geometry.Mesh.GetNumberOfVertices())
{
  const TriangleMesh& mesh = geometry.Mesh;
  const Metric& metric = geometry.Lengths;
  const std::vector<Vector3>& positions = geometry.Positions;
  mesh.ForEachComponent(
    [&](Index c)
    {
      const TriangleMesh::Component& component = mesh.GetComponents()[c];
      ParallelFor(component.Vertices(), PieceSize,
        [&](Index begin, Index end)
        {
          std::vector<Index> fan;
          for (Index v = component.FirstVertex + begin; v < component.FirstVertex + end; ++v)
          {
            mesh.GetFan(v, fan);
            double area = 0.0;
            Vector3 laplacian = Vector3::Zero();
            for (const Index h : fan)
            {
              const Index next = TriangleMesh::Next(h);
              const Index previous = TriangleMesh::Previous(h);
              const double out = metric.SquaredLength[mesh.Edge(h)];
              const double across = metric.SquaredLength[mesh.Edge(next)];
              const double back = metric.SquaredLength[mesh.Edge(previous)];
              // Half the cotangents of the corners opposite of the two edges at the vertex.
              const double perArea = 0.125 / metric.Area[h / 3] / metric.Unit[c];
              laplacian += perArea * (across + back - out) *
                Vector3(positions[mesh.Tail(next)] - positions[v]);
              laplacian += perArea * (out + across - back) *
                Vector3(positions[mesh.Tail(previous)] - positions[v]);
              area += metric.Area[h / 3] / 3.0;
              const double strength = -0.25 * dihedralAngles[mesh.Edge(h)] * std::sqrt(out);
              this->Hopf[v] += strength * std::polar(1.0, 2.0 * geometry.Transport.EdgeAngle[h]);
            }
            laplacian /= area;
            const double outward = laplacian.dot(geometry.Frames.Normal[v]);
            const bool boundary = mesh.IsBoundary(v);
            this->Mean[v] =
              boundary ? -0.5 * outward : std::copysign(0.5 * laplacian.norm(), -outward);
            this->Gaussian[v] =
              boundary ? 0.0 : (2.0 * Pi - 2.0 * Pi / geometry.Transport.Scale[v]) / area;
          }
        });
      Eigen::Map<ComplexVector> hopf(
        this->Hopf.data() + component.FirstVertex, component.Vertices());
      hopf = SolveMass(AssembleOperators(geometry, component, 2, 0.0), hopf);
    });
}
}
