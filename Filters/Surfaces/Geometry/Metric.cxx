// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Geometry/Metric.h"

#include "MeshError.h"
#include "Support/Threads.h"
#include "Support/VectorMath.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace DirectionFields
{
namespace
{
/// Squares of lengths in this range neither overflow nor vanish.
constexpr double Small = 1e-100;
constexpr double Large = 1e100;
/// The triangle inequality must hold by this part of the longest edge.
constexpr double Slack = 1e-6;
/// Shortest edge, relative to the mean.
constexpr double ShortestEdge = 1e-9;
/// Lengthening an edge can spoil the triangle on its other side. This is followed at most so often.
constexpr int MaximumSweeps = 50;

/// The length that is missing for the triangle inequality to hold with its slack.
double Deficit(double a, double b, double c)
{
  const double longest = std::max({ a, b, c });
  return longest + Slack * longest - (a + b + c - longest);
}

class Mollification
{
public:
  Mollification(const TriangleMesh& mesh, LargeArray<double>& length)
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
      if (this->ClampEdges(t) || this->Deficit(t) > 0.0)
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
    return ::DirectionFields::Deficit(this->Length[this->Mesh.Edge(3 * t)],
      this->Length[this->Mesh.Edge(3 * t + 1)], this->Length[this->Mesh.Edge(3 * t + 2)]);
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
  LargeArray<double>& Length;
};

struct EdgeSums
{
  /// Coordinate difference.
  double Largest = 0.0;
  double Length = 0.0;

  void operator+=(const EdgeSums& other)
  {
    this->Largest = std::max(this->Largest, other.Largest);
    this->Length += other.Length;
  }
};

struct TriangleSums
{
  double Area = 0.0;
  Index Bad = 0;

  void operator+=(const TriangleSums& other)
  {
    this->Area += other.Area;
    this->Bad += other.Bad;
  }
};

/// Loops over a range of numbers.
template <typename Sum, typename Body>
Sum SumOver(Index first, Index end, const Body& body)
{
  return ParallelSum(end - first, LightPiece, Sum{},
    [&](Index pieceBegin, Index pieceEnd)
    {
      Sum sum;
      for (Index k = first + pieceBegin; k < first + pieceEnd; ++k)
      {
        body(k, sum);
      }
      return sum;
    });
}

[[noreturn]] void RefuseOverflow(
  const TriangleMesh& mesh, const TriangleMesh::Component& component, const std::vector<Vector3>& p)
{
  for (Index e = component.FirstEdge;; ++e)
  {
    const Index h = mesh.HalfEdge(e);
    if (!(p[mesh.Head(h)] - p[mesh.Tail(h)]).allFinite())
    {
      const Index point = mesh.Point(mesh.Tail(h));
      throw MeshError(MeshError::Kind::NonFinitePoint, point,
        "The coordinates at point " + std::to_string(point) +
          " are so large that an edge length overflows. Scale the mesh down.");
    }
  }
}
}

double TriangleArea(const std::array<double, 3>& length)
{
  // Heron's formula as arranged by Kahan.
  const double low = std::min(length[0], length[1]);
  const double high = std::max(length[0], length[1]);
  const double a = std::max(high, length[2]);
  const double c = std::min(low, length[2]);
  const double b = std::max(low, std::min(high, length[2]));
  return 0.25 *
    std::sqrt(std::max(0.0, (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c))));
}

std::array<double, 3> TriangleAngles(const std::array<double, 3>& length, double area)
{
  const std::array<double, 3> opposite = { length[1], length[2], length[0] };
  const int first = opposite[0] >= opposite[1] ? (opposite[0] >= opposite[2] ? 0 : 2)
                                               : (opposite[1] >= opposite[2] ? 1 : 2);
  const int second = (first + 1) % 3;
  const int third = (first + 2) % 3;
  const double longest = opposite[first];
  const double twiceSum = 2.0 * (longest + (opposite[second] + opposite[third]));
  // tan(angle / 2) = area / (s (s - opposite)), s half the sum of the lengths. The two smaller
  // angles come without cancellation, and the largest one is pi less these.
  const std::array<double, 2> tangents = {
    8.0 * area / (twiceSum * (opposite[third] + (longest - opposite[second]))),
    8.0 * area / (twiceSum * (opposite[second] + (longest - opposite[third]))),
  };
  std::array<double, 2> halves;
  Arctangents(tangents.data(), 2, halves.data());
  std::array<double, 3> angles;
  angles[second] = 2.0 * halves[0];
  angles[third] = 2.0 * halves[1];
  angles[first] = Pi - (angles[second] + angles[third]);
  return angles;
}

Metric::Metric(
  const TriangleMesh& mesh, const std::vector<Vector3>& positions, const std::vector<double>& sizes)
  : SquaredLength(mesh.GetNumberOfEdges())
  , Area(mesh.GetNumberOfTriangles())
  , Unit(mesh.GetComponents().size())
  , ComponentArea(mesh.GetComponents().size())
{
  std::vector<Index> degenerate(mesh.GetComponents().size());
  mesh.ForEachComponent([&](Index c) { degenerate[c] = this->Measure(mesh, positions, sizes, c); });
  this->DegenerateTriangles = std::accumulate(degenerate.begin(), degenerate.end(), Index(0));
}

/// Returns the number of degenerate triangles.
Index Metric::Measure(const TriangleMesh& mesh, const std::vector<Vector3>& positions,
  const std::vector<double>& sizes, Index c)
{
  const TriangleMesh::Component& component = mesh.GetComponents()[c];
  LargeArray<double>& length = this->SquaredLength;
  const auto edgeVector = [&](Index e) -> Vector3
  {
    const Index h = mesh.HalfEdge(e);
    const Vector3 edge = positions[mesh.Head(h)] - positions[mesh.Tail(h)];
    const double square = sizes.empty() ? 1.0 : sizes[mesh.Head(h)] * sizes[mesh.Tail(h)];
    return square == 1.0 ? edge : Vector3(edge / std::sqrt(square));
  };
  auto sums = SumOver<EdgeSums>(component.FirstEdge, component.EndEdge,
    [&](Index e, EdgeSums& sum)
    {
      const Vector3 edge = edgeVector(e);
      sum.Largest = std::max(sum.Largest, edge.lpNorm<Eigen::Infinity>());
      length[e] = edge.norm();
      sum.Length += length[e];
    });
  double scale = 1.0;
  if (!(sums.Largest > Small && sums.Largest < Large))
  {
    // The largest coordinate difference is divided out first: squares of it could overflow.
    if (!std::isfinite(sums.Largest))
    {
      RefuseOverflow(mesh, component, positions);
    }
    scale = sums.Largest > 0.0 ? sums.Largest : 1.0;
    sums = SumOver<EdgeSums>(component.FirstEdge, component.EndEdge,
      [&](Index e, EdgeSums& sum)
      {
        length[e] = (edgeVector(e) / scale).norm();
        sum.Length += length[e];
      });
  }
  const double mean = sums.Length > 0.0 ? sums.Length / component.Edges() : 1.0;
  this->Unit[c] = scale * mean;
  ParallelFor(component.Edges(), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index e = component.FirstEdge + begin; e < component.FirstEdge + end; ++e)
      {
        // Where all points coincide only the connectivity is left: every edge gets the same length.
        length[e] = sums.Length > 0.0 ? length[e] / mean : 1.0;
      }
    });
  const auto measureAreas = [&]
  {
    return SumOver<TriangleSums>(component.FirstTriangle, component.EndTriangle,
      [&](Index t, TriangleSums& sum)
      {
        const std::array<double, 3> l = { length[mesh.Edge(3 * t)], length[mesh.Edge(3 * t + 1)],
          length[mesh.Edge(3 * t + 2)] };
        this->Area[t] = TriangleArea(l);
        sum.Area += this->Area[t];
        sum.Bad += std::min({ l[0], l[1], l[2] }) < ShortestEdge || Deficit(l[0], l[1], l[2]) > 0.0;
      });
  };
  TriangleSums triangles = measureAreas();
  Index degenerate = sums.Length > 0.0 ? 0 : component.Triangles();
  if (triangles.Bad > 0)
  {
    degenerate = Mollification(mesh, length).Apply(component);
    triangles = measureAreas();
  }
  const int sides = component.IsCover ? 2 : 1;
  this->ComponentArea[c] = triangles.Area / sides;
  ParallelFor(component.Edges(), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index e = component.FirstEdge + begin; e < component.FirstEdge + end; ++e)
      {
        length[e] *= length[e];
      }
    });
  return degenerate / sides;
}

void Metric::SetUnit(const TriangleMesh& mesh, Index component, double unit)
{
  const TriangleMesh::Component& ranges = mesh.GetComponents()[component];
  const double ratio = this->Unit[component] / unit;
  for (Index e = ranges.FirstEdge; e < ranges.EndEdge; ++e)
  {
    this->SquaredLength[e] *= ratio * ratio;
  }
  for (Index t = ranges.FirstTriangle; t < ranges.EndTriangle; ++t)
  {
    this->Area[t] *= ratio * ratio;
  }
  this->ComponentArea[component] *= ratio * ratio;
  this->Unit[component] = unit;
}

std::array<double, 3> Metric::CornerAngles(const TriangleMesh& mesh, Index triangle) const
{
  std::array<double, 3> length;
  for (int c = 0; c < 3; ++c)
  {
    length[c] = std::sqrt(this->SquaredLength[mesh.Edge(3 * triangle + c)]);
  }
  return TriangleAngles(length, this->Area[triangle]);
}
}
