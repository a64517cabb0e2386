// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/Surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace Meshes
{
using DirectionFields::Triangle;

Surface DoubleTorus()
{
  // The boundary of a plate of 7 x 3 unit blocks with two blocks left out.
  Surface s;
  const auto solid = [](int x, int y, int z) {
    return x >= 0 && x < 7 && y >= 0 && y < 3 && z == 0 && !(y == 1 && (x == 1 || x == 5)) ? 1 : 0;
  };
  std::map<std::array<int, 3>, Index> numbers;
  const auto number = [&](const std::array<int, 3>& corner)
  {
    const auto [it, inserted] = numbers.emplace(corner, static_cast<Index>(s.Points.size()));
    if (inserted)
    {
      s.Points.emplace_back(corner[0], corner[1], corner[2]);
    }
    return it->second;
  };
  for (int x = 0; x < 7; ++x)
  {
    for (int y = 0; y < 3; ++y)
    {
      for (int axis = 0; axis < 3 && solid(x, y, 0); ++axis)
      {
        for (int side = 0; side < 2; ++side)
        {
          std::array<int, 3> beyond = { x, y, 0 };
          beyond[axis] += side ? 1 : -1;
          if (solid(beyond[0], beyond[1], beyond[2]))
          {
            continue;
          }
          std::array<Index, 4> q;
          for (int k = 0; k < 4; ++k)
          {
            std::array<int, 3> corner = { x, y, 0 };
            corner[axis] += side;
            corner[(axis + 1) % 3] += k == 1 || k == 2;
            corner[(axis + 2) % 3] += k >= 2;
            q[k] = number(corner);
          }
          if (!side)
          {
            std::swap(q[1], q[3]);
          }
          s.Triangles.push_back({ q[0], q[1], q[2] });
          s.Triangles.push_back({ q[0], q[2], q[3] });
        }
      }
    }
  }
  return s;
}

Surface FourfoldDisk(int cells)
{
  Surface s;
  const int n = 2 * cells + 1;
  for (int j = -cells; j <= cells; ++j)
  {
    for (int i = -cells; i <= cells; ++i)
    {
      // Squares about the center become circles.
      const Vector3 p(static_cast<double>(i) / cells, static_cast<double>(j) / cells, 0.0);
      const double ring = std::max(std::abs(p.x()), std::abs(p.y()));
      s.Points.push_back(ring > 0.0 ? Vector3(ring * p.normalized()) : p);
    }
  }
  for (int j = 0; j < 2 * cells; ++j)
  {
    for (int i = 0; i < 2 * cells; ++i)
    {
      const Index a = j * n + i;
      const Index b = a + 1;
      const Index c = b + n;
      const Index d = a + n;
      // Diagonals point to the center in all four quadrants.
      if ((i < cells) == (j < cells))
      {
        s.Triangles.push_back({ a, b, c });
        s.Triangles.push_back({ a, c, d });
      }
      else
      {
        s.Triangles.push_back({ a, b, d });
        s.Triangles.push_back({ b, c, d });
      }
    }
  }
  return s;
}

Surface ChamferedCube(int cells)
{
  // The surface of a cubic lattice, its outermost layer pulled in where two or three sides meet.
  std::map<std::array<int, 3>, Index> numbers;
  Surface s;
  const int n = cells + 2;
  const auto number = [&](const std::array<int, 3>& corner)
  {
    const auto [it, inserted] = numbers.emplace(corner, static_cast<Index>(s.Points.size()));
    if (inserted)
    {
      Vector3 p;
      int outer = 0;
      for (int k = 0; k < 3; ++k)
      {
        outer += corner[k] == 0 || corner[k] == n;
        p[k] = 2.0 * corner[k] / n - 1.0;
      }
      for (int k = 0; k < 3 && outer > 1; ++k)
      {
        if (corner[k] == 0 || corner[k] == n)
        {
          p[k] *= 1.0 - (outer == 2 ? 1.0 : 4.0 / 3.0) / n;
        }
      }
      s.Points.push_back(p);
    }
    return it->second;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side = 0; side < 2; ++side)
    {
      for (int u = 0; u < n; ++u)
      {
        for (int v = 0; v < n; ++v)
        {
          std::array<Index, 4> q;
          for (int k = 0; k < 4; ++k)
          {
            std::array<int, 3> corner;
            corner[axis] = side * n;
            corner[(axis + 1) % 3] = u + (k == 1 || k == 2);
            corner[(axis + 2) % 3] = v + (k >= 2);
            q[k] = number(corner);
          }
          if (!side)
          {
            std::swap(q[1], q[3]);
          }
          s.Triangles.push_back({ q[0], q[1], q[2] });
          s.Triangles.push_back({ q[0], q[2], q[3] });
        }
      }
    }
  }
  return s;
}

Surface BallWithLimbs()
{
  // Each limb is what a cap of the ball becomes: from its tip to its rim by distances from the axis
  // and along it.
  constexpr double rim = 0.5;
  const std::array<std::array<double, 3>, 5> profile = { { { 0.0, 0.0, 3.0 }, { 0.15, 0.08, 2.95 },
    { 0.75, 0.1, 1.05 }, { 0.85, 0.2, 0.95 }, { 1.0, std::sin(rim), std::cos(rim) } } };
  Surface s = Icosphere(5);
  for (Vector3& point : s.Points)
  {
    const Vector3 old = point;
    Index axis = 0;
    old.cwiseAbs().maxCoeff(&axis);
    const double u = std::acos(std::min(1.0, std::abs(old[axis]))) / rim;
    if (u >= 1.0)
    {
      continue;
    }
    std::size_t k = 1;
    while (profile[k][0] < u)
    {
      ++k;
    }
    const double part = (u - profile[k - 1][0]) / (profile[k][0] - profile[k - 1][0]);
    const auto at = [&](int c)
    { return profile[k - 1][c] + part * (profile[k][c] - profile[k - 1][c]); };
    Vector3 across = old;
    across[axis] = 0.0;
    point = at(1) * across.stableNormalized();
    point[axis] = std::copysign(at(2), old[axis]);
  }
  return s;
}
}
