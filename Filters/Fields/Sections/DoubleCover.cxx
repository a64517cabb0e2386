// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Sections/DoubleCover.h"

#include <cmath>

namespace DirectionFields::Internal
{
DoubleCover::DoubleCover(
  const IntrinsicGeometry& geometry, const TriangleMesh::Component& component, int degree)
  : Mesh(geometry.Mesh)
  , Transport(geometry.Transport)
  , Component(component)
  , Degree(degree)
{
}

Complex DoubleCover::Mirrored(Index vertex, const Complex& value) const
{
  // The second edge of a corner is seen at one angle from here and at another from the other side.
  const Index h = this->Mesh.Outgoing(vertex);
  const Index next = this->Mesh.NextOutgoing(h);
  const Index other = TriangleMesh::Next(this->Mesh.Mirror(h));
  const double sum =
    (next == None ? this->Transport.AngleSum[vertex] : this->Transport.EdgeAngle[next]) +
    this->Transport.EdgeAngle[other];
  return std::conj(value) * std::polar(1.0, this->Degree * sum);
}

ComplexVector DoubleCover::Mirrored(const ComplexVector& u) const
{
  ComplexVector mirrored(u.size());
  for (Index v = 0; v < u.size(); ++v)
  {
    const Index vertex = this->Component.FirstVertex + v;
    mirrored[this->Mesh.MirrorVertex(vertex) - this->Component.FirstVertex] =
      this->Mirrored(vertex, u[v]);
  }
  return mirrored;
}

void DoubleCover::Symmetrize(ComplexVector& u) const
{
  u = 0.5 * (u + this->Mirrored(u)).eval();
  const ComplexVector mirrored = this->Mirrored(u);
  for (Index v = 0; v < u.size(); ++v)
  {
    if (!this->Mesh.IsFrontVertex(this->Component.FirstVertex + v))
    {
      u[v] = mirrored[v];
    }
  }
}

void DoubleCover::MakeSymmetric(ComplexVector& u, const SparseMatrix& mass) const
{
  // The mirror image of e^(i phi) u is e^(-i phi) times that of u.
  const Complex overlap = u.dot(this->Mirrored(u));
  u *= std::polar(1.0, 0.5 * std::arg(overlap));
  this->Symmetrize(u);
  u /= std::sqrt(u.dot(mass * u).real());
}
}
