// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/Surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

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

namespace
{
using Row = std::vector<Vector3>;

/// Grids between rows of points, joined where their points are at one place.
class Grids
{
public:
  /// Of quads in this number of steps from a row to another one, which is above it as seen from
  /// outside.
  void Add(const Row& low, const Row& high, int steps)
  {
    for (int k = 0; k < steps; ++k)
    {
      const auto at = [&](std::size_t i, int step)
      { return this->NumberOf(low[i] + static_cast<double>(step) / steps * (high[i] - low[i])); };
      for (std::size_t i = 0; i + 1 < low.size(); ++i)
      {
        const Index a = at(i, k);
        const Index c = at(i + 1, k + 1);
        this->Made.Triangles.push_back({ a, at(i + 1, k), c });
        this->Made.Triangles.push_back({ a, c, at(i, k + 1) });
      }
    }
  }

  const Surface& Get() const { return this->Made; }

private:
  Index NumberOf(const Vector3& p)
  {
    constexpr double perUnit = 1e6;
    const std::array<long, 3> key = { std::lround(perUnit * p.x()), std::lround(perUnit * p.y()),
      std::lround(perUnit * p.z()) };
    const auto [at, isNew] =
      this->Numbers.emplace(key, static_cast<Index>(this->Made.Points.size()));
    if (isNew)
    {
      this->Made.Points.push_back(p);
    }
    return at->second;
  }

  Surface Made;
  std::map<std::array<long, 3>, Index> Numbers;
};

/// Around the axis z.
Row Arc(double radius, double z, double from, double to, int steps)
{
  Row row;
  for (int i = 0; i <= steps; ++i)
  {
    const double angle = from + static_cast<double>(i) / steps * (to - from);
    row.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  return row;
}

/// Away from the axis z, or towards it.
Row Ray(double angle, double z, double from, double to, int steps)
{
  Row row;
  for (int i = 0; i <= steps; ++i)
  {
    const double radius = from + static_cast<double>(i) / steps * (to - from);
    row.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  return row;
}

Row AtBottom(Row row)
{
  for (Vector3& p : row)
  {
    p.z() = 0.0;
  }
  return row;
}
}

Surface Flange(int fine)
{
  constexpr int holes = 6;
  constexpr double height = 0.3;
  constexpr double top = 1.2;
  Grids grids;
  for (int k = 0; k < holes; ++k)
  {
    const double middle = 2.0 * EIGEN_PI * k / holes;
    const double from = middle - EIGEN_PI / holes;
    const double to = middle + EIGEN_PI / holes;
    const auto arc = [&](double radius, double z) { return Arc(radius, z, from, to, 4 * fine); };
    grids.Add(arc(2.0, 0.0), arc(2.0, height), 2 * fine);
    grids.Add(arc(0.8, height), arc(0.8, top), 4 * fine);
    grids.Add(arc(0.8, top), arc(0.5, top), 2 * fine);
    grids.Add(arc(0.5, top), arc(0.5, 0.0), 5 * fine);
    grids.Add(arc(0.5, 0.0), arc(0.8, 0.0), 2 * fine);
    // Counter-clockwise around a sixth of the plate, and around its hole.
    Row around = arc(2.0, height);
    for (const Row& side : { Ray(to, height, 2.0, 0.8, 4 * fine),
           Arc(0.8, height, to, from, 4 * fine), Ray(from, height, 0.8, 2.0, 4 * fine) })
    {
      around.insert(around.end(), side.begin() + 1, side.end());
    }
    const Vector3 center(1.4 * std::cos(middle), 1.4 * std::sin(middle), height);
    Row rim;
    for (const Vector3& p : around)
    {
      rim.emplace_back(center + 0.2 * (p - center).normalized());
    }
    grids.Add(around, rim, 3 * fine);
    grids.Add(rim, AtBottom(rim), 2 * fine);
    grids.Add(AtBottom(rim), AtBottom(around), 3 * fine);
  }
  return grids.Get();
}
}
