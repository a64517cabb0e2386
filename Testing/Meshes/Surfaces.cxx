// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/Surfaces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

namespace Meshes
{
using DirectionFields::Pi;
using DirectionFields::Triangle;

namespace
{
/// Appends quads of a lattice with wrap-around where the count equals the points of that direction.
void AddQuads(Surface& surface, int columns, int rows, bool wrapColumns, bool wrapRows)
{
  const int quadColumns = wrapColumns ? columns : columns - 1;
  const int quadRows = wrapRows ? rows : rows - 1;
  for (int j = 0; j < quadRows; ++j)
  {
    for (int i = 0; i < quadColumns; ++i)
    {
      const Index a = j * columns + i;
      const Index b = j * columns + (i + 1) % columns;
      const Index c = (j + 1) % rows * columns + (i + 1) % columns;
      const Index d = (j + 1) % rows * columns + i;
      surface.Triangles.push_back({ a, b, c });
      surface.Triangles.push_back({ a, c, d });
    }
  }
}

Surface Subdivided(const Surface& coarse, bool toUnitSphere)
{
  Surface fine;
  fine.Points = coarse.Points;
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b)
  {
    const std::pair<Index, Index> key(std::min(a, b), std::max(a, b));
    const auto [it, inserted] = middles.emplace(key, static_cast<Index>(fine.Points.size()));
    if (inserted)
    {
      const Vector3 between = 0.5 * (coarse.Points[a] + coarse.Points[b]);
      fine.Points.push_back(toUnitSphere ? between.normalized() : between);
    }
    return it->second;
  };
  for (const Triangle& t : coarse.Triangles)
  {
    const Index a = middle(t[0], t[1]);
    const Index b = middle(t[1], t[2]);
    const Index c = middle(t[2], t[0]);
    fine.Triangles.push_back({ t[0], a, c });
    fine.Triangles.push_back({ t[1], b, a });
    fine.Triangles.push_back({ t[2], c, b });
    fine.Triangles.push_back({ a, b, c });
  }
  return fine;
}

/// The points that the triangles use, renumbered.
Surface Compacted(const Surface& surface)
{
  Surface compact;
  std::vector<Index> number(surface.Points.size(), DirectionFields::None);
  for (Triangle t : surface.Triangles)
  {
    for (Index& corner : t)
    {
      if (number[corner] == DirectionFields::None)
      {
        number[corner] = static_cast<Index>(compact.Points.size());
        compact.Points.push_back(surface.Points[corner]);
      }
      corner = number[corner];
    }
    compact.Triangles.push_back(t);
  }
  return compact;
}
}

Surface Tetrahedron()
{
  return { { { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } },
    { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } } };
}

Surface Octahedron()
{
  return { { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } },
    { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 },
      { 0, 3, 5 } } };
}

Surface Icosahedron()
{
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  Surface s{
    { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 }, { 0, -1, g }, { 0, 1, g },
      { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 }, { -g, 0, -1 }, { -g, 0, 1 } },
    { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 }, { 1, 5, 9 },
      { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 }, { 3, 2, 6 },
      { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 }, { 9, 8, 1 } }
  };
  for (Vector3& p : s.Points)
  {
    p.normalize();
  }
  return s;
}

Surface Cube()
{
  Surface s;
  for (int k = 0; k < 8; ++k)
  {
    s.Points.emplace_back(k & 1, (k >> 1) & 1, (k >> 2) & 1);
  }
  const std::array<std::array<Index, 4>, 6> sides = { { { 0, 2, 3, 1 }, { 4, 5, 7, 6 },
    { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } } };
  for (const auto& q : sides)
  {
    s.Triangles.push_back({ q[0], q[1], q[2] });
    s.Triangles.push_back({ q[0], q[2], q[3] });
  }
  return s;
}

Surface Icosphere(int levels)
{
  Surface s = Icosahedron();
  for (int level = 0; level < levels; ++level)
  {
    s = Subdivided(s, true);
  }
  return s;
}

Surface Hemisphere(int levels)
{
  Surface s = Icosphere(levels);
  s.Triangles.erase(std::remove_if(s.Triangles.begin(), s.Triangles.end(),
                      [&](const Triangle& t) {
                        return s.Points[t[0]].z() + s.Points[t[1]].z() + s.Points[t[2]].z() < 0.0;
                      }),
    s.Triangles.end());
  return Compacted(s);
}

Surface Square(int cells, double size)
{
  Surface s;
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      s.Points.emplace_back(size * i / cells, size * j / cells, 0.0);
    }
  }
  AddQuads(s, cells + 1, cells + 1, false, false);
  return s;
}

Surface Disk(int rings)
{
  Surface s;
  s.Points.emplace_back(0.0, 0.0, 0.0);
  const auto number = [](int ring, int k)
  { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + k % (6 * ring); };
  for (int ring = 1; ring <= rings; ++ring)
  {
    for (int k = 0; k < 6 * ring; ++k)
    {
      const double angle = 2.0 * Pi * k / (6 * ring);
      const double radius = static_cast<double>(ring) / rings;
      s.Points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
  }
  for (int ring = 1; ring <= rings; ++ring)
  {
    for (int sector = 0; sector < 6; ++sector)
    {
      for (int k = 0; k < ring; ++k)
      {
        const int outer = sector * ring + k;
        const int inner = sector * (ring - 1) + k;
        s.Triangles.push_back(
          { number(ring - 1, inner), number(ring, outer), number(ring, outer + 1) });
        if (k + 1 < ring)
        {
          s.Triangles.push_back(
            { number(ring - 1, inner), number(ring, outer + 1), number(ring - 1, inner + 1) });
        }
      }
    }
  }
  return s;
}

Surface Cylinder(int around, int along, double height)
{
  Surface s;
  for (int j = 0; j <= along; ++j)
  {
    for (int i = 0; i < around; ++i)
    {
      const double angle = 2.0 * Pi * i / around;
      s.Points.emplace_back(std::cos(angle), std::sin(angle), height * j / along);
    }
  }
  AddQuads(s, around, along + 1, true, false);
  return s;
}

Surface Torus(int around, int across, double majorRadius, double minorRadius)
{
  Surface s;
  for (int j = 0; j < across; ++j)
  {
    const double b = 2.0 * Pi * j / across;
    for (int i = 0; i < around; ++i)
    {
      const double a = 2.0 * Pi * i / around;
      const double r = majorRadius + minorRadius * std::cos(b);
      s.Points.emplace_back(r * std::cos(a), r * std::sin(a), minorRadius * std::sin(b));
    }
  }
  AddQuads(s, around, across, true, true);
  return s;
}

Surface Potato(int levels)
{
  Surface s = Icosphere(levels);
  for (Vector3& p : s.Points)
  {
    const double radius = 1.0 + 0.15 * std::sin(2.0 * p.x() + 0.5) +
      0.1 * std::sin(3.0 * p.y() + p.x()) + 0.12 * std::cos(2.5 * p.z() - p.y() + 0.3);
    p = radius * p.cwiseProduct(Vector3(1.4, 1.0, 0.8));
  }
  return s;
}

Surface FlatlySubdivided(const Surface& surface, int levels)
{
  Surface s = surface;
  for (int level = 0; level < levels; ++level)
  {
    s = Subdivided(s, false);
  }
  return s;
}

Surface LShape(int cells)
{
  Surface s = Square(2 * cells, 2.0);
  s.Triangles.erase(std::remove_if(s.Triangles.begin(), s.Triangles.end(),
                      [&](const Triangle& t)
                      {
                        const Vector3 middle =
                          (s.Points[t[0]] + s.Points[t[1]] + s.Points[t[2]]) / 3.0;
                        return middle.x() > 1.0 && middle.y() > 1.0;
                      }),
    s.Triangles.end());
  return Compacted(s);
}

Surface PlateWithHole(int around, int across, double radius, bool bent)
{
  Surface s;
  constexpr double bevel = 0.15;
  const double wall = bent ? 0.5 * Pi * bevel + 0.3 : 0.0;
  for (int j = 0; j <= across; ++j)
  {
    for (int i = 0; i < around; ++i)
    {
      // From the circle outwards along rays to a square, whose outermost part is bent down.
      const double angle = 2.0 * Pi * i / around + 0.25 * Pi;
      const Vector3 ray(std::cos(angle), std::sin(angle), 0.0);
      const double t = static_cast<double>(j) / across;
      const double stretch = (1.0 + wall) / ray.lpNorm<Eigen::Infinity>();
      Vector3 p = ((1.0 - t) * radius + t * stretch) * ray;
      const int axis = std::abs(p.x()) > std::abs(p.y()) ? 0 : 1;
      const double beyond = std::abs(p[axis]) - (1.0 - bevel);
      if (bent && beyond > 0.0)
      {
        const double bend = std::min(beyond / bevel, 0.5 * Pi);
        const double scale = 1.0 / std::abs(p[axis]);
        p *= scale * (1.0 - bevel + bevel * std::sin(bend));
        p.z() = bevel * (std::cos(bend) - 1.0) - std::max(0.0, beyond - 0.5 * Pi * bevel);
      }
      s.Points.push_back(p);
    }
  }
  AddQuads(s, around, across + 1, true, false);
  for (Triangle& t : s.Triangles)
  {
    std::swap(t[1], t[2]);
  }
  return s;
}

Surface Jittered(Surface surface, double length, unsigned seed)
{
  std::mt19937 engine(seed);
  const auto random = [&] { return 2.0 * (engine() / 4294967296.0) - 1.0; };
  for (Vector3& p : surface.Points)
  {
    const double x = random();
    const double y = random();
    const double z = random();
    p += length / std::sqrt(3.0) * Vector3(x, y, z);
  }
  return surface;
}

Surface Transformed(const Surface& surface, const Eigen::Matrix3d& linear, const Vector3& shift)
{
  Surface s = surface;
  for (Vector3& p : s.Points)
  {
    p = linear * p + shift;
  }
  return s;
}

Eigen::Matrix3d ObliqueRotation(double angle)
{
  return Eigen::AngleAxisd(angle, Vector3(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
}

Surface Joined(const Surface& a, const Surface& b)
{
  Surface s = a;
  const auto offset = static_cast<Index>(a.Points.size());
  s.Points.insert(s.Points.end(), b.Points.begin(), b.Points.end());
  for (const Triangle& t : b.Triangles)
  {
    s.Triangles.push_back({ t[0] + offset, t[1] + offset, t[2] + offset });
  }
  return s;
}

Surface Shuffled(const Surface& surface, unsigned seed, std::vector<Index>& newPoint,
  std::vector<Index>& newTriangle)
{
  std::mt19937 engine(seed);
  const auto permutation = [&](std::size_t n)
  {
    std::vector<Index> p(n);
    std::iota(p.begin(), p.end(), 0);
    for (std::size_t k = n; k > 1; --k)
    {
      std::swap(p[k - 1], p[engine() % k]);
    }
    return p;
  };
  newPoint = permutation(surface.Points.size());
  newTriangle = permutation(surface.Triangles.size());
  Surface s;
  s.Points.resize(surface.Points.size());
  s.Triangles.resize(surface.Triangles.size());
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    s.Points[newPoint[i]] = surface.Points[i];
  }
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const unsigned turn = engine() % 3;
    for (unsigned c = 0; c < 3; ++c)
    {
      s.Triangles[newTriangle[t]][c] = newPoint[surface.Triangles[t][(c + turn) % 3]];
    }
  }
  return s;
}

double Deviation(const DirectionFields::Result& field, Index point, const Vector3& direction)
{
  double best = 180.0;
  for (int k = 0; k < field.Degree; ++k)
  {
    const Vector3 d = field.Direction(point, k);
    best = std::min(best, std::atan2(d.cross(direction).norm(), d.dot(direction)) * 180.0 / Pi);
  }
  return best;
}

Surface Soup(const Surface& surface)
{
  Surface soup;
  for (const auto& triangle : surface.Triangles)
  {
    const auto first = static_cast<Index>(soup.Points.size());
    for (const Index point : triangle)
    {
      soup.Points.push_back(surface.Points[point]);
    }
    soup.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return soup;
}

DirectionFields::Guidance GuidanceAt(
  const Surface& surface, const std::map<Index, Vector3>& vectors)
{
  DirectionFields::Guidance guidance;
  guidance.Vectors.assign(surface.Points.size(), Vector3::Zero());
  for (const auto& [point, vector] : vectors)
  {
    guidance.Vectors[point] = vector;
  }
  return guidance;
}

Index Count(const DirectionFields::Result& field, DirectionFields::ConstraintKind kind)
{
  return static_cast<Index>(std::count(field.Constraint.begin(), field.Constraint.end(), kind));
}
}
