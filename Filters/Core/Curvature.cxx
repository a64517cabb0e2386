// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curvature.h"

#include "Operators.h"
#include "Threads.h"

#include <Eigen/IterativeLinearSolvers>

#include <cmath>

namespace DirectionFields
{
namespace
{
constexpr Index PieceSize = 1 << 12;
}

std::vector<double> DihedralAngles(
  const TriangleMesh& mesh, const std::vector<Vector3>& positions)
{
  const auto point = [&](Index h) -> const Vector3& { return positions[mesh.Tail(h)]; };
  const auto normal = [&](Index t) -> Vector3
  {
    const Vector3& a = point(3 * t);
    return (point(3 * t + 1) - a)
      .stableNormalized()
      .cross((point(3 * t + 2) - a).stableNormalized())
      .stableNormalized();
  };
  std::vector<double> angles(mesh.GetNumberOfEdges(), 0.0);
  ParallelFor(mesh.GetNumberOfEdges(), PieceSize,
    [&](Index begin, Index end)
    {
      for (Index e = begin; e < end; ++e)
      {
        const Index h = mesh.HalfEdge(e);
        const Index twin = mesh.Twin(h);
        if (twin != None)
        {
          const Vector3 left = normal(h / 3);
          const Vector3 right = normal(twin / 3);
          const Vector3 along = (point(twin) - point(h)).stableNormalized();
          angles[e] = std::atan2(along.dot(left.cross(right)), left.dot(right));
        }
      }
    });
  return angles;
}

Curvature::Curvature(const TriangleMesh& mesh, const Metric& metric, const Connection& connection,
  const TangentFrames& frames, const std::vector<Vector3>& positions,
  const std::vector<double>& dihedralAngles)
  : Hopf(mesh.GetNumberOfVertices(), 0.0)
  , Mean(mesh.GetNumberOfVertices())
  , Gaussian(mesh.GetNumberOfVertices())
{
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
            double angle = 0.0;
            double area = 0.0;
            Vector3 laplacian = Vector3::Zero();
            for (const Index h : fan)
            {
              const std::array<double, 3> corners = metric.CornerAngles(mesh, h / 3);
              const Index next = TriangleMesh::Next(h);
              const Index previous = TriangleMesh::Previous(h);
              angle += corners[h % 3];
              area += metric.Area[h / 3] / 3.0;
              laplacian += 0.5 / std::tan(corners[previous % 3]) / metric.Unit[c] *
                (positions[mesh.Tail(next)] - positions[v]);
              laplacian += 0.5 / std::tan(corners[next % 3]) / metric.Unit[c] *
                (positions[mesh.Tail(previous)] - positions[v]);
              const double strength = -0.25 * dihedralAngles[mesh.Edge(h)] *
                std::sqrt(metric.SquaredLength[mesh.Edge(h)]);
              this->Hopf[v] += strength * std::polar(1.0, 2.0 * connection.EdgeAngle[h]);
            }
            laplacian /= area;
            const double outward = laplacian.dot(frames.Normal[v]);
            const bool boundary = mesh.IsBoundary(v);
            this->Mean[v] =
              boundary ? -0.5 * outward : std::copysign(0.5 * laplacian.norm(), -outward);
            this->Gaussian[v] = boundary ? 0.0 : (2.0 * Pi - angle) / area;
          }
        });
      const SparseMatrix mass =
        AssembleOperators(mesh, metric, connection, component, 2, 0.0).Mass;
      // Scaled by its diagonal the mass matrix is well conditioned on any mesh.
      Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper> solver(mass);
      solver.setTolerance(1e-14);
      Eigen::Map<ComplexVector> hopf(
        this->Hopf.data() + component.FirstVertex, component.Vertices());
      hopf = solver.solve(ComplexVector(hopf));
    });
}
}
