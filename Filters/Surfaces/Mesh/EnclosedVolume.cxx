// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/EnclosedVolume.h"

#include "Support/Threads.h"

#include <Eigen/Geometry>

#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// The volume that a closed component encloses, in unit^3.
double SignedVolume(const TriangleMesh& mesh, const TriangleMesh::Component& component,
  const std::vector<Vector3>& positions, double unit)
{
  const Vector3 origin = positions[component.FirstVertex];
  return ParallelSum<double>(component.Triangles(), MediumPiece, 0.0,
           [&](Index begin, Index end)
           {
             double sum = 0.0;
             for (Index t = component.FirstTriangle + begin; t < component.FirstTriangle + end; ++t)
             {
               const auto corner = [&](Index c) -> Vector3
               { return (positions[mesh.Tail(3 * t + c)] - origin) / unit; };
               sum += corner(0).dot(corner(1).cross(corner(2)));
             }
             return sum;
           }) /
    6.0;
}
}

bool IsWoundInsideOut(double volume, double area)
{
  constexpr double leastVolume = 1e-6;
  return volume < -leastVolume * std::pow(area, 1.5);
}

bool IsWoundInsideOut(const TriangleMesh& mesh, Index component,
  const std::vector<Vector3>& positions, double unit, double area)
{
  const TriangleMesh::Component& ranges = mesh.GetComponents()[component];
  return ranges.Closed && !ranges.IsCover &&
    IsWoundInsideOut(SignedVolume(mesh, ranges, positions, unit), area);
}
}
