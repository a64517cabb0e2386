// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/Surfaces.h"

#include <random>

namespace Meshes
{
namespace
{
/// The lengths of the triangles' edges in the mean.
double MeanEdge(const Surface& surface)
{
  double sum = 0.0;
  for (const auto& t : surface.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      sum += (surface.Points[t[(i + 1) % 3]] - surface.Points[t[i]]).norm();
    }
  }
  return sum / (3.0 * static_cast<double>(surface.Triangles.size()));
}

/// Sums of the normals of the triangles at each point, weighted by area; of unit length.
std::vector<Vector3> Normals(const Surface& surface)
{
  std::vector<Vector3> normals(surface.Points.size(), Vector3::Zero());
  for (const auto& t : surface.Triangles)
  {
    const Vector3 normal = (surface.Points[t[1]] - surface.Points[t[0]])
                             .cross(surface.Points[t[2]] - surface.Points[t[0]]);
    for (const Index v : t)
    {
      normals[v] += normal;
    }
  }
  for (Vector3& normal : normals)
  {
    normal.stableNormalize();
  }
  return normals;
}
}

Surface Roughened(Surface surface, double edges, unsigned seed)
{
  const double length = edges * MeanEdge(surface);
  const std::vector<Vector3> normals = Normals(surface);
  std::mt19937 engine(seed);
  for (std::size_t v = 0; v < surface.Points.size(); ++v)
  {
    // Nearly a normal distribution, the same with any library.
    double sum = -6.0;
    for (int k = 0; k < 12; ++k)
    {
      sum += engine() / 4294967296.0;
    }
    surface.Points[v] += length * sum * normals[v];
  }
  return surface;
}
}
