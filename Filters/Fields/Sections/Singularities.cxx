// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Sections/Singularities.h"

#include "Support/LargeArray.h"
#include "Support/PointOrder.h"
#include "Support/Threads.h"
#include "Support/VectorMath.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace DirectionFields
{
namespace
{
/// The nearest integer of a number of modulus below 2^51. The compiler can do this for several at
/// once.
double Nearest(double x)
{
  constexpr double unitIsLastBit = 6755399441055744.0;
  return (x + unitIsLastBit) - unitIsLastBit;
}

/// From this angle on, radians, rounding may have chosen between pi and -pi.
constexpr double HalfTurn = Pi - 1e-10;

/// For these functions all components may be as one.
TriangleMesh::Component AllOf(const TriangleMesh& mesh)
{
  return { 0, mesh.GetNumberOfTriangles(), 0, mesh.GetNumberOfEdges(), 0,
    mesh.GetNumberOfVertices(), false, false };
}
}

LargeArray<double> PhaseDifferences(const IntrinsicGeometry& geometry,
  const TriangleMesh::Component& component, int degree, const Complex* field)
{
  const TriangleMesh& mesh = geometry.Mesh;
  LargeArray<double> phase(component.Vertices());
  ParallelFor(component.Vertices(), LightPiece,
    [&](Index begin, Index end) { Arguments(field + begin, end - begin, phase.data() + begin); });
  LargeArray<double> omega(component.Edges());
  ParallelFor(component.Edges(), LightPiece,
    [&](Index begin, Index end)
    {
      double largest = 0.0;
      for (Index e = begin; e < end; ++e)
      {
        const Index h = mesh.HalfEdge(component.FirstEdge + e);
        const double angle = phase[mesh.Head(h) - component.FirstVertex] -
          phase[mesh.Tail(h) - component.FirstVertex] -
          degree * geometry.Transport.Rotation[component.FirstEdge + e];
        omega[e] = angle - 2.0 * Pi * Nearest(angle / (2.0 * Pi));
        largest = std::max(largest, std::abs(omega[e]));
      }
      for (Index e = begin; e < end && largest > HalfTurn; ++e)
      {
        if (std::abs(omega[e]) > HalfTurn)
        {
          // Of a cover one side decides for both, where the edge runs the other way.
          const Index own = mesh.HalfEdge(component.FirstEdge + e);
          const Index mirror = mesh.Mirror(own);
          const Index h = mirror != None && mesh.Edge(mirror) < mesh.Edge(own) ? mirror : own;
          const std::vector<Vector3>& at = geometry.Positions;
          const bool rises = ComesFirstInGrids(at[mesh.Tail(h)], at[mesh.Head(h)]);
          omega[e] = std::copysign(omega[e], rises ? 1.0 : -1.0);
        }
      }
    });
  return omega;
}

std::vector<int> SingularityIndices(
  const IntrinsicGeometry& geometry, int degree, const std::vector<Complex>& field)
{
  return SingularityIndices(geometry, AllOf(geometry.Mesh), degree, field.data());
}

std::vector<int> SingularityIndices(const IntrinsicGeometry& geometry,
  const TriangleMesh::Component& component, int degree, const Complex* field)
{
  const TriangleMesh& mesh = geometry.Mesh;
  // omega is computed once, in the direction of the edge, for both its triangles, and on one side
  // where the edge is seen from two: rounding must not break a tie between pi and -pi in two ways.
  const LargeArray<double> omega = PhaseDifferences(geometry, component, degree, field);
  const auto along = [&](Index side)
  {
    const Index mirror = mesh.Mirror(side);
    const Index h = mirror != None && mesh.Edge(mirror) < mesh.Edge(side) ? mirror : side;
    const double angle = omega[mesh.Edge(h) - component.FirstEdge];
    return mesh.GivesDirection(h) ? angle : -angle;
  };
  std::vector<int> index(component.Triangles());
  ParallelFor(component.Triangles(), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index k = begin; k < end; ++k)
      {
        const Index t = component.FirstTriangle + k;
        const double sum = degree * geometry.Transport.Curvature[t] + along(3 * t) +
          along(3 * t + 1) + along(3 * t + 2);
        index[k] = static_cast<int>(Nearest(sum / (2.0 * Pi)));
      }
    });
  return index;
}

std::vector<double> EnergyDensity(
  const IntrinsicGeometry& geometry, int degree, const std::vector<Complex>& field)
{
  const TriangleMesh& mesh = geometry.Mesh;
  LargeArray<double> square = PhaseDifferences(geometry, AllOf(mesh), degree, field.data());
  ParallelFor(mesh.GetNumberOfEdges(), LightPiece,
    [&](Index begin, Index end)
    {
      // 2 - 2 cos omega without cancellation.
      ForCosinesAndSines(
        begin, end, [&](Index e) { return 0.5 * square[e]; },
        [&](Index e, double, double sine) { square[e] = 4.0 * sine * sine; });
    });
  std::vector<double> density(mesh.GetNumberOfVertices());
  ParallelFor(mesh.GetNumberOfVertices(), MediumPiece,
    [&](Index begin, Index end)
    {
      std::vector<Index> fan;
      for (Index v = begin; v < end; ++v)
      {
        mesh.GetFan(v, fan);
        double energy = 0.0;
        double area = 0.0;
        for (const Index h : fan)
        {
          const std::array<Index, 3> edges = { mesh.Edge(h), mesh.Edge(TriangleMesh::Next(h)),
            mesh.Edge(TriangleMesh::Previous(h)) };
          const LargeArray<double>& squared = geometry.Lengths.SquaredLength;
          const double sum = squared[edges[0]] + squared[edges[1]] + squared[edges[2]];
          double products = 0.0;
          for (const Index e : edges)
          {
            products += (sum - 2.0 * squared[e]) * square[e];
          }
          energy += products / (8.0 * geometry.Lengths.Area[h / 3]);
          area += geometry.Lengths.Area[h / 3];
        }
        density[v] = area > 0.0 ? std::max(0.0, energy / area) : 0.0;
      }
    });
  return density;
}
}
