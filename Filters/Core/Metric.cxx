// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Metric.h"

#include "MeshError.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace DirectionFields
{
namespace
{
/// By how much the triangle inequality must hold, relative to the longest edge.
constexpr double Slack = 1e-6;
/// Shortest edge, relative to the mean.
constexpr double ShortestEdge = 1e-9;
/// Lengthening an edge can spoil the triangle on its other side; so many times this is followed.
constexpr int MaximumSweeps = 50;

class Mollification
{
public:
  Mollification(const TriangleMesh& mesh, std::vector<double>& length)
    : Mesh(mesh)
    , Length(length)
  {
  }

  /// Returns the number of triangles that were (nearly) without area. Lengths have mean one.
  Index Apply(const TriangleMesh::Component& component)
  {
    std::vector<Index> bad;
    for (Index t = component.FirstTriangle; t < component.EndTriangle; ++t)
    {
      if (this->ClampEdges(t) | (this->Deficit(t) > 0.0))
      {
        bad.push_back(t);
      }
    }
    const auto count = static_cast<Index>(bad.size());
    std::vector<Index> spoiled;
    for (int sweep = 0; sweep < MaximumSweeps && !bad.empty(); ++sweep)
    {
      spoiled.clear();
      for (const Index t : bad)
      {
        this->Lengthen(t, spoiled);
      }
      bad.swap(spoiled);
    }
    if (!bad.empty())
    {
      this->LengthenAll(component);
    }
    return count;
  }

private:
  std::array<Index, 3> EdgesByLength(Index t) const
  {
    std::array<Index, 3> edges = { this->Mesh.Edge(3 * t), this->Mesh.Edge(3 * t + 1),
      this->Mesh.Edge(3 * t + 2) };
    std::stable_sort(edges.begin(), edges.end(),
      [this](Index a, Index b) { return this->Length[a] < this->Length[b]; });
    return edges;
  }

  double Deficit(Index t) const
  {
    const double a = this->Length[this->Mesh.Edge(3 * t)];
    const double b = this->Length[this->Mesh.Edge(3 * t + 1)];
    const double c = this->Length[this->Mesh.Edge(3 * t + 2)];
    const double longest = std::max({ a, b, c });
    return longest + Slack * longest - (a + b + c - longest);
  }

  bool ClampEdges(Index t)
  {
    bool clamped = false;
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      double& length = this->Length[this->Mesh.Edge(h)];
      if (length < ShortestEdge)
      {
        length = ShortestEdge;
        clamped = true;
      }
    }
    return clamped;
  }

  void Lengthen(Index t, std::vector<Index>& spoiled)
  {
    const double deficit = this->Deficit(t);
    if (deficit <= 0.0)
    {
      return;
    }
    const Index edge = this->EdgesByLength(t)[0];
    // A little more than the deficit: rounding must not leave any of it.
    this->Length[edge] += deficit * 1.01;
    for (const Index h : { this->Mesh.HalfEdge(edge), this->Mesh.Twin(this->Mesh.HalfEdge(edge)) })
    {
      if (h != None && this->Deficit(h / 3) > 0.0)
      {
        spoiled.push_back(h / 3);
      }
    }
  }

  /// The same addition to all edges mends all triangles at once.
  void LengthenAll(const TriangleMesh::Component& component)
  {
    double addition = 0.0;
    for (Index t = component.FirstTriangle; t < component.EndTriangle; ++t)
    {
      addition = std::max(addition, this->Deficit(t));
    }
    for (Index e = component.FirstEdge; e < component.EndEdge; ++e)
    {
      this->Length[e] += addition * (1.0 + 2.0 * Slack);
    }
  }

  const TriangleMesh& Mesh;
  std::vector<double>& Length;
};

/// Heron's formula as arranged by Kahan, for a >= b >= c.
double TriangleArea(double a, double b, double c)
{
  return 0.25 * std::sqrt(std::max(0.0, (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c))));
}
}

Metric::Metric(const TriangleMesh& mesh, const std::vector<Vector3>& points)
  : SquaredLength(mesh.GetNumberOfEdges())
  , CornerAngle(mesh.GetNumberOfHalfEdges())
  , Area(mesh.GetNumberOfTriangles())
{
  const auto edgeVector = [&](Index e) -> Vector3
  {
    const Index h = mesh.HalfEdge(e);
    return points[mesh.Point(mesh.Head(h))] - points[mesh.Point(mesh.Tail(h))];
  };
  std::vector<double> length(mesh.GetNumberOfEdges());
  Mollification mollification(mesh, length);
  for (const TriangleMesh::Component& component : mesh.GetComponents())
  {
    // The largest coordinate difference is divided out first: squares of it could overflow.
    double largest = 0.0;
    for (Index e = component.FirstEdge; e < component.EndEdge; ++e)
    {
      const double extent = edgeVector(e).lpNorm<Eigen::Infinity>();
      if (!std::isfinite(extent))
      {
        const Index point = mesh.Point(mesh.Tail(mesh.HalfEdge(e)));
        throw MeshError(MeshError::Kind::NonFinitePoint, point,
          "The coordinates at point " + std::to_string(point) +
            " are so large that an edge length overflows. Scale the mesh down.");
      }
      largest = std::max(largest, extent);
    }
    if (largest == 0.0)
    {
      largest = 1.0;
    }
    double sum = 0.0;
    for (Index e = component.FirstEdge; e < component.EndEdge; ++e)
    {
      length[e] = (edgeVector(e) / largest).norm();
      sum += length[e];
    }
    const double mean = sum > 0.0 ? sum / component.Edges() : 1.0;
    this->Unit.push_back(largest * mean);
    for (Index e = component.FirstEdge; e < component.EndEdge; ++e)
    {
      // Where all points coincide only the connectivity is left: every edge gets the same length.
      length[e] = sum > 0.0 ? length[e] / mean : 1.0;
    }
    this->DegenerateTriangles +=
      sum > 0.0 ? mollification.Apply(component) : component.Triangles();

    double area = 0.0;
    for (Index t = component.FirstTriangle; t < component.EndTriangle; ++t)
    {
      std::array<double, 3> l;
      for (int c = 0; c < 3; ++c)
      {
        l[c] = length[mesh.Edge(3 * t + c)];
      }
      std::array<double, 3> descending = l;
      std::sort(descending.begin(), descending.end(), std::greater<double>());
      this->Area[t] = TriangleArea(descending[0], descending[1], descending[2]);
      area += this->Area[t];
      for (int c = 0; c < 3; ++c)
      {
        const double next = l[c];
        const double previous = l[(c + 2) % 3];
        const double opposite = l[(c + 1) % 3];
        // next^2 + previous^2 - opposite^2 without the cancellation of squares.
        const double twiceDot =
          next * next + (previous - opposite) * (previous + opposite);
        this->CornerAngle[3 * t + c] = std::atan2(4.0 * this->Area[t], twiceDot);
      }
    }
    this->ComponentArea.push_back(area);
  }
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    this->SquaredLength[e] = length[e] * length[e];
  }
}
}
