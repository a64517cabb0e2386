// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReferenceSection.h"

#include <cmath>

namespace DirectionFields
{
namespace
{
/// A sum below this part of the sum of absolute values cancels by symmetry.
constexpr double Cancelled = 1e-3;
}

ReferenceSection::ReferenceSection(const TriangleMesh& mesh, const TangentFrames& frames,
  const std::vector<Vector3>& points, const TriangleMesh::Component& component, int degree)
  : Mesh(mesh)
  , Frames(frames)
  , Points(points)
  , Component(component)
  , Degree(degree)
{
  Vector3 low = points[mesh.Point(component.FirstVertex)];
  Vector3 high = low;
  for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
  {
    low = low.cwiseMin(points[mesh.Point(v)]);
    high = high.cwiseMax(points[mesh.Point(v)]);
  }
  this->Center = 0.5 * low + 0.5 * high;
  const double size = (high - low).maxCoeff();
  this->HalfSize = size > 0.0 ? 0.5 * size : 1.0;
}

Complex ReferenceSection::Power(Index vertex, const Vector3& v) const
{
  const Index i = this->Component.FirstVertex + vertex;
  const Complex z(v.dot(this->Frames.X[i]), v.dot(this->Frames.Y[i]));
  return std::polar(std::abs(z), this->Degree * std::arg(z));
}

Vector3 ReferenceSection::Position(Index vertex) const
{
  const Index i = this->Component.FirstVertex + vertex;
  return (this->Points[this->Mesh.Point(i)] - this->Center) / this->HalfSize;
}

ComplexVector ReferenceSection::Start() const
{
  ComplexVector start(this->Component.Vertices());
  for (Index v = 0; v < start.size(); ++v)
  {
    const Vector3 p = this->Position(v);
    // Irregular coefficients, so that no symmetry of the surface makes the section orthogonal to
    // the eigenvector.
    const Vector3 field(0.83 + 0.31 * p[1] - 0.24 * p[2] + 0.17 * std::sin(1.3 * p[0] + 2.1 * p[1]),
      0.47 - 0.38 * p[0] + 0.29 * p[2] + 0.19 * std::sin(1.7 * p[1] + 0.9 * p[2] + 0.4),
      0.29 + 0.22 * p[0] - 0.35 * p[1] + 0.23 * std::sin(2.3 * p[2] - 1.1 * p[0] + 0.7));
    start[v] = this->Power(v, field);
  }
  if (!(start.norm() > 0.0))
  {
    start.setOnes();
  }
  return start;
}

void ReferenceSection::FixPhase(ComplexVector& u) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    Complex sum = 0.0;
    double size = 0.0;
    for (Index v = 0; v < u.size(); ++v)
    {
      const Complex term = std::conj(u[v]) * this->Power(v, Vector3::Unit(axis));
      sum += term;
      size += std::abs(term);
    }
    if (std::abs(sum) > Cancelled * size && size > 0.0)
    {
      u *= sum / std::abs(sum);
      return;
    }
  }
  // One vertex that no symmetry maps to another decides.
  const Vector3 oblique(0.37, 0.23, 0.11);
  Index chosen = 0;
  double largest = -1.0;
  for (Index v = 0; v < u.size(); ++v)
  {
    const double value = std::abs(u[v]) * (2.0 + oblique.dot(this->Position(v)));
    if (value > largest)
    {
      largest = value;
      chosen = v;
    }
  }
  const Complex turn = std::conj(u[chosen]) * this->Power(chosen, oblique);
  if (std::abs(turn) > 0.0)
  {
    u *= turn / std::abs(turn);
  }
}
}
