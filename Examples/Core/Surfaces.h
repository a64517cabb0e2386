// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Surfaces_h
#define Surfaces_h

#include <DirectionFields/Surface.h>

#include <array>
#include <map>

/// The unit sphere: the eight faces of an octahedron of 8 n^2 triangles, blown up.
inline DirectionFields::Surface Sphere(DirectionFields::Index n)
{
  using DirectionFields::Index;
  DirectionFields::Surface sphere;
  std::map<std::array<Index, 3>, Index> ids;
  for (const Index x : { -1, 1 })
  {
    for (const Index y : { -1, 1 })
    {
      for (const Index z : { -1, 1 })
      {
        const auto point = [&](Index i, Index j)
        {
          const std::array<Index, 3> place = { x * i, y * j, z * (n - i - j) };
          const auto [found, isNew] =
            ids.try_emplace(place, static_cast<Index>(sphere.Points.size()));
          if (isNew)
          {
            sphere.Points.push_back(
              DirectionFields::Vector3(place[0], place[1], place[2]).normalized());
          }
          return found->second;
        };
        const auto add = [&](Index a, Index b, Index c) {
          sphere.Triangles.push_back({ a, x * y * z > 0 ? b : c, x * y * z > 0 ? c : b });
        };
        for (Index i = 0; i < n; ++i)
        {
          for (Index j = 0; i + j < n; ++j)
          {
            add(point(i, j), point(i + 1, j), point(i, j + 1));
            if (i + j + 1 < n)
            {
              add(point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
            }
          }
        }
      }
    }
  }
  return sphere;
}

/// The center of a triangle.
inline DirectionFields::Vector3 Center(
  const DirectionFields::Surface& surface, std::size_t triangle)
{
  const DirectionFields::Triangle& corners = surface.Triangles[triangle];
  return (surface.Points[corners[0]] + surface.Points[corners[1]] + surface.Points[corners[2]]) /
    3.0;
}

#endif
