// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/CoverSymmetry.h"

#include <complex>

namespace DirectionFields::Parallel
{
namespace
{
/// The angles at which an edge is seen from its end on the front and from that on the back add up
/// to the turn between the two.
double AngleBetween(const DistributedMesh& mesh, Index front, Index back)
{
  const TriangleMesh& triangles = mesh.GetMesh();
  const Connection& transport = mesh.GetGeometry().Transport;
  // The second edge of the first corner, which leaves the vertex behind, too, at the boundary.
  const Index h = triangles.Outgoing(front);
  const Index next = triangles.NextOutgoing(h);
  const Index there = mesh.Behind(triangles.Tail(TriangleMesh::Previous(h)));
  Index g = triangles.Outgoing(back);
  while (g != None && triangles.Head(g) != there)
  {
    g = triangles.NextOutgoing(g);
  }
  return (next == None ? transport.AngleSum[front] : transport.EdgeAngle[next]) +
    (g == None ? 0.0 : transport.EdgeAngle[g]);
}
}

CoverSymmetry::CoverSymmetry(const DistributedMesh& mesh, int component, int degree)
{
  for (const std::size_t c : mesh.PartsOf(component))
  {
    const TriangleMesh::Component& part = mesh.GetMesh().GetComponents()[c];
    for (Index v = part.FirstVertex; v < part.EndVertex; ++v)
    {
      if (mesh.IsOwned(v) && mesh.IsFront(v))
      {
        const Index back = mesh.Behind(v);
        this->Pairs.push_back({ v, back, std::polar(1.0, degree * AngleBetween(mesh, v, back)) });
      }
    }
  }
}

void CoverSymmetry::MakeSymmetric(const Messages& messages, std::vector<Complex>& section) const
{
  // The mirror image of e^(i phi) u is e^(-i phi) times that of u.
  double sums[2] = { 0.0, 0.0 };
  for (const Pair& pair : this->Pairs)
  {
    const Complex product =
      2.0 * std::conj(section[pair.Front]) * std::conj(section[pair.Back]) * pair.Turn;
    sums[0] += product.real();
    sums[1] += product.imag();
  }
  messages.Sum(sums, 2);
  const Complex factor = std::polar(1.0, 0.5 * std::arg(Complex(sums[0], sums[1])));
  for (const Pair& pair : this->Pairs)
  {
    section[pair.Front] *= factor;
    section[pair.Back] *= factor;
  }
  this->Symmetrize(section);
}

void CoverSymmetry::Symmetrize(std::vector<Complex>& section) const
{
  for (const Pair& pair : this->Pairs)
  {
    Complex& front = section[pair.Front];
    Complex& back = section[pair.Back];
    front = 0.5 * (front + std::conj(back) * pair.Turn);
    back = std::conj(front) * pair.Turn;
  }
}
}
