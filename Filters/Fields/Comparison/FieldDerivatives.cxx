// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Comparison/FieldDerivatives.h"

#include "Support/Threads.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace DirectionFields
{
namespace
{
/// The directions at the corners of a triangle as angles in the vertices' cones. Returns false
/// where there are none.
bool CornerAngles(const GivenField& field, Index triangle, std::array<double, 3>& angles)
{
  const SurfaceGeometry& geometry = field.GetGeometry();
  const TriangleMesh& mesh = geometry.Mesh;
  const int n = field.GetDegree();
  for (int c = 0; c < 3; ++c)
  {
    const Complex& u = field.GetSection()[mesh.Tail(3 * triangle + c)];
    if (u == 0.0)
    {
      return false;
    }
    angles[c] = std::arg(u) / n;
  }
  if (n == 1)
  {
    return true;
  }
  // The direction at the end of each half-edge is turned to the side of that at its start.
  const auto isOpposite = [&](int c)
  {
    const Index h = 3 * triangle + c;
    const int next = (c + 1) % 3;
    return std::cos(angles[next] - angles[c] - geometry.Transport.RotationAlong(mesh, h)) < 0.0;
  };
  angles[1] += isOpposite(0) ? Pi : 0.0;
  angles[2] += isOpposite(1) ? Pi : 0.0;
  return !isOpposite(2);
}

/// The mean component of the vectors, turned by an angle, along a half-edge, times its length.
double FlowAlong(
  const SurfaceGeometry& geometry, Index h, double atTail, double atHead, double turned)
{
  const double along = geometry.Transport.EdgeAngle[h];
  const double arriving = along + geometry.Transport.RotationAlong(geometry.Mesh, h);
  const double length = std::sqrt(geometry.Lengths.SquaredLength[geometry.Mesh.Edge(h)]);
  return 0.5 * length * (std::cos(atTail + turned - along) + std::cos(atHead + turned - arriving));
}
}

FieldDerivatives::FieldDerivatives(const GivenField& field)
  : Divergence(field.GetSurface().Triangles.size(), 0.0)
  , Curl(this->Divergence)
{
  if (field.GetDegree() > 2)
  {
    throw std::invalid_argument(
      "Divergence and curl are those of vector and line fields, of degree 1 and 2; this field has degree " +
      std::to_string(field.GetDegree()) + ".");
  }
  const SurfaceGeometry& geometry = field.GetGeometry();
  const TriangleMesh& mesh = geometry.Mesh;
  for (std::size_t c = 0; c < mesh.GetComponents().size(); ++c)
  {
    const TriangleMesh::Component& component = mesh.GetComponents()[c];
    const double unit = geometry.Lengths.Unit[c];
    ParallelFor(component.Triangles(), HeavyPiece,
      [&](Index begin, Index end)
      {
        for (Index t = component.FirstTriangle + begin; t < component.FirstTriangle + end; ++t)
        {
          if (!mesh.IsFront(t))
          {
            continue;
          }
          double& divergence = this->Divergence[mesh.InputTriangle(t)];
          double& curl = this->Curl[mesh.InputTriangle(t)];
          std::array<double, 3> angles{};
          if (!CornerAngles(field, t, angles))
          {
            divergence = curl = std::numeric_limits<double>::quiet_NaN();
            continue;
          }
          for (int k = 0; k < 3; ++k)
          {
            const int next = (k + 1) % 3;
            curl += FlowAlong(geometry, 3 * t + k, angles[k], angles[next], 0.0);
            // The flow out of a triangle across a half-edge is the component of the field's left
            // quarter turn along it.
            divergence += FlowAlong(geometry, 3 * t + k, angles[k], angles[next], 0.5 * Pi);
          }
          const double scale = 1.0 / (geometry.Lengths.Area[t] * unit);
          curl *= scale;
          divergence *= scale;
          if (field.GetDegree() == 2)
          {
            curl = std::abs(curl);
            divergence = std::abs(divergence);
          }
        }
      });
  }
}
}
