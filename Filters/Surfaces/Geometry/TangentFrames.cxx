// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Geometry/TangentFrames.h"

#include "Support/LargeArray.h"
#include "Support/Threads.h"
#include "Support/VectorMath.h"

#include <cmath>

namespace DirectionFields
{
namespace
{
/// Zero where the vector is zero.
Vector3 Normalized(const Vector3& vector)
{
  const double square = vector.squaredNorm();
  const bool isSafe = square > 1e-200 && square < 1e200;
  return isSafe ? Vector3(vector * (1.0 / std::sqrt(square))) : vector.stableNormalized();
}

/// The cross product of two vectors, normalized; zero where they are parallel.
Vector3 UnitNormal(const Vector3& a, const Vector3& b)
{
  const Vector3 cross = a.cross(b);
  const double square = cross.squaredNorm();
  return square > 1e-200 && square < 1e200
    ? Vector3(cross * (1.0 / std::sqrt(square)))
    : a.stableNormalized().cross(b.stableNormalized()).stableNormalized();
}
}

TangentFrames::TangentFrames(
  const TriangleMesh& mesh, const Connection& connection, const std::vector<Vector3>& positions)
  : Normal(mesh.GetNumberOfVertices())
  , X(mesh.GetNumberOfVertices())
{
  for (std::vector<Vector3>* axes : { &this->Normal, &this->X })
  {
    PreferLargePages(axes->data(), axes->size() * sizeof(Vector3));
  }
  ParallelFor(mesh.GetNumberOfVertices(), MediumPiece,
    [&](Index begin, Index end)
    {
      std::vector<Index> fan;
      std::vector<Vector3> edges;
      std::vector<double> angles;
      std::vector<double> cosines;
      std::vector<double> sines;
      for (Index v = begin; v < end; ++v)
      {
        // The edges counter-clockwise; a boundary vertex has one more than triangles.
        mesh.GetFan(v, fan);
        edges.clear();
        angles.clear();
        for (const Index h : fan)
        {
          edges.emplace_back(positions[mesh.Head(h)] - positions[v]);
          angles.push_back(connection.EdgeAngle[h]);
        }
        const bool boundary = mesh.IsBoundary(v);
        if (boundary)
        {
          edges.emplace_back(
            positions[mesh.Tail(TriangleMesh::Previous(fan.back()))] - positions[v]);
          angles.push_back(connection.AngleSum[v]);
        }
        Vector3 sum = Vector3::Zero();
        for (std::size_t k = 0; k < fan.size(); ++k)
        {
          const std::size_t next = k + 1 < edges.size() ? k + 1 : 0;
          const double corner = angles[next] - angles[k];
          sum += (corner > 0.0 ? corner : corner + 2.0 * Pi) * UnitNormal(edges[k], edges[next]);
        }
        Vector3 normal = Normalized(sum);
        if (normal.isZero())
        {
          const Vector3 edge = edges[0].stableNormalized();
          normal = edge.isZero() ? Vector3::UnitZ().eval() : AnyOrthogonal(edge);
        }

        cosines.resize(angles.size());
        sines.resize(angles.size());
        CosinesAndSines(
          angles.data(), static_cast<Index>(angles.size()), cosines.data(), sines.data());
        const Vector3 a = AnyOrthogonal(normal);
        const Vector3 b = normal.cross(a);
        Complex fit = 0.0;
        for (std::size_t k = 0; k < edges.size(); ++k)
        {
          const double square = edges[k].squaredNorm();
          const bool isSafe = square > 1e-200 && square < 1e200;
          const Vector3 edge = isSafe ? edges[k] : Vector3(edges[k].stableNormalized());
          const double x = edge.dot(a);
          const double y = edge.dot(b);
          const double projected = x * x + y * y;
          // An edge along the normal has no direction in the tangent plane.
          if (projected > 1e-24 * (isSafe ? square : 1.0))
          {
            fit += Complex(x * cosines[k] + y * sines[k], y * cosines[k] - x * sines[k]) *
              (1.0 / std::sqrt(projected));
          }
        }
        const double length = Modulus(fit);
        fit = length > 1e-12 ? fit / length : Complex(1.0);
        this->Normal[v] = normal;
        this->X[v] = fit.real() * a + fit.imag() * b;
      }
    });
}
}
