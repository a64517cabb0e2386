// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Glyphs/OutwardSides.h"

#include "Mesh/EnclosedVolume.h"
#include "Mesh/MergePoints.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>

namespace DirectionFields::Internal
{
namespace
{
bool IsSound(const Surface& surface, const Triangle& triangle)
{
  const auto points = static_cast<Index>(surface.Points.size());
  return std::all_of(triangle.begin(), triangle.end(),
    [&](Index point) { return point >= 0 && point < points && surface.Points[point].allFinite(); });
}

/// Whether a mesh has wound a triangle of the surface the other way round.
bool IsTurned(const MergedMesh& merged, Index triangle, const Triangle& input)
{
  const auto pointOf = [&](Index point)
  { return merged.FirstPoint.empty() ? point : merged.FirstPoint[point]; };
  const Index tail = merged.Mesh.Point(merged.Mesh.Tail(3 * triangle));
  const Index head = merged.Mesh.Point(merged.Mesh.Head(3 * triangle));
  for (int c = 0; c < 3; ++c)
  {
    if (pointOf(input[c]) == tail)
    {
      return pointOf(input[(c + 1) % 3]) != head;
    }
  }
  return false;
}

double AreaOf(const TriangleMesh& mesh, const TriangleMesh::Component& component,
  const std::vector<Vector3>& positions)
{
  double area = 0.0;
  for (Index t = component.FirstTriangle; t < component.EndTriangle; ++t)
  {
    const Vector3& origin = positions[mesh.Tail(3 * t)];
    const Vector3 a = positions[mesh.Tail(3 * t + 1)] - origin;
    const Vector3 b = positions[mesh.Tail(3 * t + 2)] - origin;
    area += 0.5 * a.cross(b).norm();
  }
  return area;
}
}

std::vector<signed char> OutwardSides(const Surface& surface)
{
  std::vector<signed char> sides(surface.Triangles.size(), 0);
  // The triangles that a mesh can be made of, and their numbers where others are left out.
  std::vector<Index> number;
  Surface rest;
  const Surface* sound = &surface;
  if (!std::all_of(surface.Triangles.begin(), surface.Triangles.end(),
        [&](const Triangle& triangle) { return IsSound(surface, triangle); }))
  {
    rest.Points = surface.Points;
    for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
    {
      if (IsSound(surface, surface.Triangles[t]))
      {
        rest.Triangles.push_back(surface.Triangles[t]);
        number.push_back(static_cast<Index>(t));
      }
    }
    sound = &rest;
  }

  const MergedMesh merged = MergedMesh::AcrossSeams(*sound);
  const TriangleMesh& mesh = merged.Mesh;
  const std::vector<Vector3> positions = mesh.Positions(sound->Points);
  const auto components = static_cast<Index>(mesh.GetComponents().size());
  for (Index c = 0; c < components; ++c)
  {
    const TriangleMesh::Component& component = mesh.GetComponents()[c];
    if (!component.Closed || component.IsCover)
    {
      continue;
    }
    const bool insideOut =
      IsWoundInsideOut(mesh, c, positions, 1.0, AreaOf(mesh, component, positions));
    for (Index t = component.FirstTriangle; t < component.EndTriangle; ++t)
    {
      const Index input = mesh.InputTriangle(t);
      const bool turned = IsTurned(merged, t, sound->Triangles[input]);
      sides[number.empty() ? input : number[input]] = turned != insideOut ? -1 : 1;
    }
  }
  return sides;
}
}
