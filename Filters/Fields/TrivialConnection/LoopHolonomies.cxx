// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrivialConnection/LoopHolonomies.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Steps of a descent that could only go on by rounding.
constexpr int MostSteps = 10000;
/// Smaller gains are rounding.
constexpr double LeastGain = 1e-9;

/// The angle of an edge in the cone of the vertex at one of its ends.
double AngleAt(const IntrinsicGeometry& geometry, Index h, bool atTail)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const Index outgoing = atTail ? h : mesh.Twin(h);
  // The last edge of the fan of a boundary vertex has no half-edge that leaves it.
  return outgoing != None ? geometry.Transport.EdgeAngle[outgoing]
                          : geometry.Transport.AngleSum[mesh.Head(h)];
}
}

std::vector<int> LoopHolonomies(const IntrinsicGeometry& geometry,
  const TriangleMesh::Component& component, int degree, const TreeCotree& trees,
  const EdgeForm& rotation)
{
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<int> numbers;
  for (std::size_t j = 0; j < trees.GetGenerators().size(); ++j)
  {
    const std::vector<Index> loop = trees.LoopOf(j);
    // The loop's half-edges in turn: whether each runs along its edge.
    Index at = mesh.Tail(mesh.HalfEdge(component.FirstEdge + loop.front()));
    std::vector<bool> forward;
    double sum = 0.0;
    for (const Index e : loop)
    {
      const Index h = mesh.HalfEdge(component.FirstEdge + e);
      forward.push_back(mesh.Tail(h) == at);
      at = forward.back() ? mesh.Head(h) : mesh.Tail(h);
      sum += forward.back() ? rotation[e] : -rotation[e];
    }
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      const std::size_t next = (k + 1) % loop.size();
      const double arriving =
        AngleAt(geometry, mesh.HalfEdge(component.FirstEdge + loop[k]), !forward[k]) + Pi;
      const double leaving =
        AngleAt(geometry, mesh.HalfEdge(component.FirstEdge + loop[next]), forward[next]);
      const double turn = leaving - arriving;
      sum -= degree * (turn - 2.0 * Pi * std::round(turn / (2.0 * Pi)));
    }
    numbers.push_back(static_cast<int>(std::lround(sum / (2.0 * Pi))));
  }
  return numbers;
}

Eigen::VectorXi NearestIntegers(const Eigen::MatrixXd& products, const Eigen::VectorXd& slope)
{
  const Eigen::VectorXd least = products.ldlt().solve(-slope);
  Eigen::VectorXd x(slope.size());
  for (Eigen::Index j = 0; j < slope.size(); ++j)
  {
    x[j] = std::isfinite(least[j]) ? std::round(least[j]) : 0.0;
  }
  for (int step = 0; step < MostSteps; ++step)
  {
    const Eigen::VectorXd gradient = products * x + slope;
    Eigen::Index best = -1;
    double gain = LeastGain * (1.0 + products.diagonal().cwiseAbs().maxCoeff());
    for (Eigen::Index j = 0; j < x.size(); ++j)
    {
      const double smaller = std::abs(gradient[j]) - 0.5 * products(j, j);
      if (smaller > gain)
      {
        gain = smaller;
        best = j;
      }
    }
    if (best < 0)
    {
      break;
    }
    x[best] -= gradient[best] > 0.0 ? 1.0 : -1.0;
  }
  return x.cast<int>();
}
}
