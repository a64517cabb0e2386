// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces that cannot be oriented.

#include "Meshes/Surfaces.h"

#include <cmath>

namespace Meshes
{
using namespace DirectionFields;

namespace
{
/// Quads, each as two triangles, of a grid of points that is open or closed across and closed along.
/// next(i, j) numbers the points, i from 0 to along, j from 0 to across.
template <typename Number>
void AddGrid(int along, int across, const Number& number, Surface& surface)
{
  for (int i = 0; i < along; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const Index a = number(i, j);
      const Index b = number(i + 1, j);
      const Index c = number(i + 1, j + 1);
      const Index d = number(i, j + 1);
      surface.Triangles.push_back({ a, b, c });
      surface.Triangles.push_back({ a, c, d });
    }
  }
}

Vector3 OnMoebiusStrip(double angle, double side)
{
  const Vector3 radial(std::cos(angle), std::sin(angle), 0.0);
  return radial +
    0.3 * side * (std::cos(0.5 * angle) * radial + std::sin(0.5 * angle) * Vector3::UnitZ());
}
}

Surface MoebiusStrip(int segments, int across)
{
  Surface s;
  for (int i = 0; i < segments; ++i)
  {
    for (int j = 0; j <= across; ++j)
    {
      s.Points.push_back(OnMoebiusStrip(2.0 * Pi * i / segments, 2.0 * j / across - 1.0));
    }
  }
  AddGrid(
    segments, across,
    [&](int i, int j) { return i == segments ? across - j : i * (across + 1) + j; }, s);
  return s;
}

Surface TwiceAroundMoebiusStrip(int segments, int across)
{
  const Surface once = MoebiusStrip(segments, across);
  const auto size = static_cast<Index>(once.Points.size());
  Surface s;
  s.Points = once.Points;
  s.Points.insert(s.Points.end(), once.Points.begin(), once.Points.end());
  // The diagonals of the quads are the same on both rounds.
  for (const int round : { 0, 1 })
  {
    AddGrid(
      segments, across,
      [&](int i, int j)
      {
        const Index here = i == segments ? across - j : i * (across + 1) + j;
        return here + ((round == 1) != (i == segments) ? size : 0);
      },
      s);
  }
  for (std::size_t t = s.Triangles.size() / 2; t < s.Triangles.size(); ++t)
  {
    std::swap(s.Triangles[t][1], s.Triangles[t][2]);
  }
  return s;
}

Surface KleinBottle(int around, int across)
{
  Surface s;
  for (int i = 0; i < around; ++i)
  {
    const double u = 2.0 * Pi * i / around;
    for (int j = 0; j < across; ++j)
    {
      const double v = 2.0 * Pi * j / across;
      const double p = 0.5 * std::sin(v);
      const double q = 0.5 * std::sin(2.0 * v);
      const double radius = 2.0 + std::cos(0.5 * u) * p - std::sin(0.5 * u) * q;
      s.Points.emplace_back(
        radius * std::cos(u), radius * std::sin(u), std::sin(0.5 * u) * p + std::cos(0.5 * u) * q);
    }
  }
  AddGrid(
    around, across,
    [&](int i, int j) { return i == around ? (across - j) % across : i * across + j % across; }, s);
  return s;
}

Surface ProjectivePlane(int levels)
{
  const Surface sphere = Icosphere(levels);
  Surface s;
  std::vector<Index> number(sphere.Points.size(), None);
  for (std::size_t i = 0; i < sphere.Points.size(); ++i)
  {
    for (std::size_t k = 0; k < i && number[i] == None; ++k)
    {
      if ((sphere.Points[k] + sphere.Points[i]).norm() < 1e-9)
      {
        number[i] = number[k];
      }
    }
    if (number[i] == None)
    {
      number[i] = static_cast<Index>(s.Points.size());
      const Vector3& p = sphere.Points[i];
      // The Roman surface, bent so that it has no symmetry.
      s.Points.emplace_back(p.y() * p.z() + 0.2 * p.x() * p.x(),
        p.x() * p.z() - 0.1 * p.y() * p.x(), p.x() * p.y() + 0.3 * p.z() * p.z());
    }
  }
  std::vector<Vector3> middles;
  for (const Triangle& t : sphere.Triangles)
  {
    const Vector3 middle = sphere.Points[t[0]] + sphere.Points[t[1]] + sphere.Points[t[2]];
    bool isNew = true;
    for (const Vector3& other : middles)
    {
      isNew = isNew && (other + middle).norm() > 1e-9;
    }
    if (isNew)
    {
      middles.push_back(middle);
      s.Triangles.push_back({ number[t[0]], number[t[1]], number[t[2]] });
    }
  }
  return s;
}
}
