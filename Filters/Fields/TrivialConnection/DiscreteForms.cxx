// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrivialConnection/DiscreteForms.h"

#include "Support/Threads.h"

namespace DirectionFields::Internal
{
DiscreteForms::DiscreteForms(
  const IntrinsicGeometry& geometry, const TriangleMesh::Component& component)
  : Geometry(geometry)
  , Component(component)
  , Weights(component.Edges())
{
  const TriangleMesh& mesh = geometry.Mesh;
  ParallelFor(component.Edges(), MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index e = begin; e < end; ++e)
      {
        this->Weights[e] =
          geometry.Lengths.EdgeWeight(mesh, mesh.HalfEdge(component.FirstEdge + e));
      }
    });
}

Eigen::VectorXd DiscreteForms::VertexAreas() const
{
  const TriangleMesh& mesh = this->Geometry.Mesh;
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(this->Component.Vertices());
  for (Index h = 3 * this->Component.FirstTriangle; h < 3 * this->Component.EndTriangle; ++h)
  {
    areas[mesh.Tail(h) - this->Component.FirstVertex] += this->Geometry.Lengths.Area[h / 3] / 3.0;
  }
  return areas;
}

double DiscreteForms::Product(const EdgeForm& a, const EdgeForm& b) const
{
  return ParallelSum(this->Component.Edges(), LightPiece, 0.0,
    [&](Index begin, Index end)
    {
      double sum = 0.0;
      for (Index e = begin; e < end; ++e)
      {
        sum += this->Weights[e] * a[e] * b[e];
      }
      return sum;
    });
}

Eigen::VectorXd DiscreteForms::Inflow(const EdgeForm& form) const
{
  // A pass over the edges takes a quarter of the time of one around each vertex, so that few
  // threads are no faster.
  Eigen::VectorXd inflow = Eigen::VectorXd::Zero(this->Component.Vertices());
  for (Index e = 0; e < this->Component.Edges(); ++e)
  {
    const Index h = this->Geometry.Mesh.HalfEdge(this->Component.FirstEdge + e);
    const double flow = this->Weights[e] * form[e];
    inflow[this->LocalHead(h)] += flow;
    inflow[this->LocalTail(h)] -= flow;
  }
  return inflow;
}

void DiscreteForms::SubtractRise(const Eigen::VectorXd& values, EdgeForm& form) const
{
  ParallelFor(this->Component.Edges(), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index e = begin; e < end; ++e)
      {
        const Index h = this->Geometry.Mesh.HalfEdge(this->Component.FirstEdge + e);
        form[e] -= values[this->LocalHead(h)] - values[this->LocalTail(h)];
      }
    });
}
}
