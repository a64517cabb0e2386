// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Field/Curvature.h"

#include "Sections/Assembly.h"
#include "Solvers/Matrices/CombinedMatrix.h"
#include "Solvers/Matrices/VectorOperations.h"
#include "Support/VectorMath.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace DirectionFields
{
namespace
{
constexpr Index PieceSize = 1 << 12;
constexpr Index FewEdges = 64;
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

std::vector<double> DihedralAngles(
  const TriangleMesh& mesh, const std::vector<Vector3>& positions)
{
  const auto point = [&](Index h) -> const Vector3& { return positions[mesh.Tail(h)]; };
  std::vector<Vector3> normals(mesh.GetNumberOfTriangles());
  ParallelFor(mesh.GetNumberOfTriangles(), PieceSize,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        const Vector3& a = point(3 * t);
        normals[t] = (point(3 * t + 1) - a)
                       .stableNormalized()
                       .cross((point(3 * t + 2) - a).stableNormalized())
                       .stableNormalized();
      }
    });
  std::vector<double> angles(mesh.GetNumberOfEdges());
  ParallelFor(mesh.GetNumberOfEdges(), PieceSize,
    [&](Index begin, Index end)
    {
      std::array<Complex, FewEdges> turns;
      for (Index first = begin; first < end; first += FewEdges)
      {
        const Index last = std::min(end, first + FewEdges);
        for (Index e = first; e < last; ++e)
        {
          const Index h = mesh.HalfEdge(e);
          const Index twin = mesh.Twin(h);
          turns[e - first] = 0.0;
          if (twin != None)
          {
            const Vector3& left = normals[h / 3];
            const Vector3& right = normals[twin / 3];
            const Vector3 along = (point(twin) - point(h)).stableNormalized();
            turns[e - first] = Complex(left.dot(right), along.dot(left.cross(right)));
          }
        }
        Arguments(turns.data(), last - first, angles.data() + first);
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
              this->Hopf[v] += strength * std::polar(1.0, 2.0 * connection.EdgeAngle[h]);
            }
            laplacian /= area;
            const double outward = laplacian.dot(frames.Normal[v]);
            const bool boundary = mesh.IsBoundary(v);
            this->Mean[v] =
              boundary ? -0.5 * outward : std::copysign(0.5 * laplacian.norm(), -outward);
            this->Gaussian[v] = boundary ? 0.0 : (2.0 * Pi - 2.0 * Pi / connection.Scale[v]) / area;
          }
        });
      Eigen::Map<ComplexVector> hopf(
        this->Hopf.data() + component.FirstVertex, component.Vertices());
      hopf = SolveMass(AssembleOperators(mesh, metric, connection, component, 2, 0.0), hopf);
    });
}
}
