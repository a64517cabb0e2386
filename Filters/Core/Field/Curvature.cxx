// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Field/Curvature.h"

#include "Sections/Assembly.h"
#include "Solvers/Matrices/CombinedMatrix.h"
#include "Solvers/Matrices/VectorOperations.h"

#include <cmath>

namespace DirectionFields
{
namespace
{
constexpr Index PieceSize = 1 << 12;
/// Relative residual of systems with the mass matrix: all digits that there are.
constexpr double Tolerance = 1e-14;
/// Some 30 are usual.
constexpr int MostSteps = 1000;

/// M x = b by conjugate gradients: scaled by its diagonal the mass matrix is well conditioned on any
/// mesh.
ComplexVector SolveMass(const Operators& operators, const ComplexVector& b)
{
  const CombinedMatrix mass(operators, 0.0, 1.0);
  Eigen::ArrayXd perDiagonal(b.size());
  ForRows(b,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        perDiagonal[v] = 1.0 / operators.Mass.coeff(v, v).real();
      }
    });
  ComplexVector x = ComplexVector::Zero(b.size());
  ComplexVector r = Copied(b);
  ComplexVector p = ComplexVector::Zero(b.size());
  ComplexVector q;
  struct Sums
  {
    double Squares = 0.0;
    /// r^* D^-1 r
    double Scaled = 0.0;
    Sums& operator+=(const Sums& other)
    {
      this->Squares += other.Squares;
      this->Scaled += other.Scaled;
      return *this;
    }
  };
  // x += step p, r -= step q
  const auto advance = [&](double step)
  {
    return ParallelSum<Sums>(static_cast<Index>(b.size()), VectorPiece, {},
      [&](Index begin, Index end)
      {
        Sums sums;
        for (Index v = begin; v < end; ++v)
        {
          if (step != 0.0)
          {
            x[v] += step * p[v];
            r[v] -= step * q[v];
          }
          const double square = std::norm(r[v]);
          sums.Squares += square;
          sums.Scaled += perDiagonal[v] * square;
        }
        return sums;
      });
  };
  Sums sums = advance(0.0);
  const double small = Tolerance * Tolerance * sums.Squares;
  double keep = 0.0;
  for (int step = 0; sums.Squares > small && step < MostSteps; ++step)
  {
    ForRows(b,
      [&](Index begin, Index end)
      {
        const Index length = end - begin;
        p.segment(begin, length) = keep * p.segment(begin, length) +
          (perDiagonal.segment(begin, length) * r.segment(begin, length).array()).matrix();
      });
    const double before = sums.Scaled;
    sums = advance(before / mass.Multiply(p, q));
    keep = sums.Scaled / before;
  }
  return x;
}
}

Curvature::Curvature(
  const SurfaceGeometry& geometry, const std::vector<double>& dihedralAngles)
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
