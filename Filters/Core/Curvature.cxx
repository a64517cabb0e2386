// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curvature.h"

#include "Operators.h"

#include <Eigen/IterativeLinearSolvers>

#include <cmath>

namespace DirectionFields
{
std::vector<double> DihedralAngles(const TriangleMesh& mesh, const std::vector<Vector3>& points)
{
  const auto point = [&](Index h) -> const Vector3& { return points[mesh.Point(mesh.Tail(h))]; };
  const auto normal = [&](Index t) -> Vector3
  {
    const Vector3& a = point(3 * t);
    return (point(3 * t + 1) - a)
      .stableNormalized()
      .cross((point(3 * t + 2) - a).stableNormalized())
      .stableNormalized();
  };
  std::vector<double> angles(mesh.GetNumberOfEdges(), 0.0);
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
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
  return angles;
}

Curvature::Curvature(const TriangleMesh& mesh, const Metric& metric, const Connection& connection,
  const TangentFrames& frames, const std::vector<Vector3>& points,
  const std::vector<double>& dihedralAngles)
  : Hopf(mesh.GetNumberOfVertices(), 0.0)
  , Mean(mesh.GetNumberOfVertices())
  , Gaussian(mesh.GetNumberOfVertices())
{
  std::vector<double> angle(mesh.GetNumberOfVertices(), 0.0);
  std::vector<double> area(mesh.GetNumberOfVertices(), 0.0);
  std::vector<Vector3> laplacian(mesh.GetNumberOfVertices(), Vector3::Zero());
  for (std::size_t c = 0; c < mesh.GetComponents().size(); ++c)
  {
    const TriangleMesh::Component& component = mesh.GetComponents()[c];
    for (Index h = 3 * component.FirstTriangle; h < 3 * component.EndTriangle; ++h)
    {
      const Index i = mesh.Tail(h);
      const Index j = mesh.Head(h);
      angle[i] += metric.CornerAngle[h];
      area[i] += metric.Area[h / 3] / 3.0;
      const double weight = 0.5 / std::tan(metric.CornerAngle[TriangleMesh::Previous(h)]);
      const Vector3 edge = (points[mesh.Point(j)] - points[mesh.Point(i)]) / metric.Unit[c];
      laplacian[i] += weight * edge;
      laplacian[j] -= weight * edge;
      // The half-edge at i, and at j the same edge seen from there.
      const double strength =
        -0.25 * dihedralAngles[mesh.Edge(h)] * std::sqrt(metric.SquaredLength[mesh.Edge(h)]);
      this->Hopf[i] += strength * std::polar(1.0, 2.0 * connection.EdgeAngle[h]);
    }
    const SparseMatrix mass =
      AssembleOperators(mesh, metric, connection, component, 2, 0.0).Mass;
    // Scaled by its diagonal the mass matrix is well conditioned on any mesh.
    Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper> solver(mass);
    solver.setTolerance(1e-14);
    Eigen::Map<ComplexVector> hopf(this->Hopf.data() + component.FirstVertex, component.Vertices());
    hopf = solver.solve(ComplexVector(hopf));
  }
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const Vector3 meanVector = laplacian[v] / area[v];
    const double outward = meanVector.dot(frames.Normal[v]);
    if (mesh.IsBoundary(v))
    {
      this->Mean[v] = -0.5 * outward;
      this->Gaussian[v] = 0.0;
    }
    else
    {
      this->Mean[v] = std::copysign(0.5 * meanVector.norm(), -outward);
      this->Gaussian[v] = (2.0 * Pi - angle[v]) / area[v];
    }
  }
}
}
