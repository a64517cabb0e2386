// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Quads/ClosestPoints.h"

#include <limits>

namespace DirectionFields::Internal
{
namespace
{
/// Weights of the point of a triangle that is closest to a place (C. Ericson: Real-Time Collision
/// Detection, 2005, section 5.1.5).
std::array<double, 3> ClosestWeights(const Vector3& p, const ClosestPoints::Corners& t)
{
  const Vector3 ab = t[1] - t[0];
  const Vector3 ac = t[2] - t[0];
  const Vector3 ap = p - t[0];
  const double d1 = ab.dot(ap);
  const double d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return { 1.0, 0.0, 0.0 };
  }
  const Vector3 bp = p - t[1];
  const double d3 = ab.dot(bp);
  const double d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3)
  {
    return { 0.0, 1.0, 0.0 };
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
  {
    const double v = d1 / (d1 - d3);
    return { 1.0 - v, v, 0.0 };
  }
  const Vector3 cp = p - t[2];
  const double d5 = ab.dot(cp);
  const double d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6)
  {
    return { 0.0, 0.0, 1.0 };
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
  {
    const double w = d2 / (d2 - d6);
    return { 1.0 - w, 0.0, w };
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
  {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return { 0.0, 1.0 - w, w };
  }
  const double sum = va + vb + vc;
  return { va / sum, vb / sum, vc / sum };
}
}

ClosestPoints::ClosestPoints(std::vector<Corners> triangles)
  : Triangles(std::move(triangles))
{
  const auto count = static_cast<Index>(this->Triangles.size());
  std::vector<Box> boxes;
  for (Index begin = 0; begin < count; begin += Leaf)
  {
    Box box{ this->Triangles[begin][0], this->Triangles[begin][0] };
    for (Index t = begin; t < std::min(count, begin + Leaf); ++t)
    {
      for (const Vector3& p : this->Triangles[t])
      {
        box.Low = box.Low.cwiseMin(p);
        box.High = box.High.cwiseMax(p);
      }
    }
    boxes.push_back(box);
  }
  this->Levels.push_back(std::move(boxes));
  while (this->Levels.back().size() > 1)
  {
    const std::vector<Box>& below = this->Levels.back();
    std::vector<Box> above;
    for (std::size_t k = 0; k < below.size(); k += 2)
    {
      Box box = below[k];
      if (k + 1 < below.size())
      {
        box.Low = box.Low.cwiseMin(below[k + 1].Low);
        box.High = box.High.cwiseMax(below[k + 1].High);
      }
      above.push_back(box);
    }
    this->Levels.push_back(std::move(above));
  }
}

ClosestPoints::Answer ClosestPoints::Find(
  const Vector3& place, const Vector3& normal, double distance) const
{
  Answer best;
  best.SquaredDistance = distance * distance;
  if (this->Triangles.empty())
  {
    return best;
  }
  const bool anyNormal = normal.isZero(0.0);
  struct Entry
  {
    std::size_t Level;
    std::size_t Box;
    double Distance;
  };
  std::array<Entry, 128> stack;
  std::size_t top = 0;
  const std::size_t root = this->Levels.size() - 1;
  stack[top++] = { root, 0, this->Levels[root][0].SquaredDistance(place) };
  while (top > 0)
  {
    const Entry entry = stack[--top];
    if (entry.Distance > best.SquaredDistance)
    {
      continue;
    }
    if (entry.Level > 0)
    {
      const std::vector<Box>& below = this->Levels[entry.Level - 1];
      const std::size_t first = 2 * entry.Box;
      Entry near{ entry.Level - 1, first, below[first].SquaredDistance(place) };
      if (first + 1 < below.size())
      {
        Entry far{ entry.Level - 1, first + 1, below[first + 1].SquaredDistance(place) };
        if (far.Distance < near.Distance)
        {
          std::swap(near, far);
        }
        stack[top++] = far;
      }
      stack[top++] = near;
      continue;
    }
    const auto end = std::min(this->Triangles.size(), (entry.Box + 1) * Leaf);
    for (std::size_t t = entry.Box * Leaf; t < end; ++t)
    {
      const Corners& corners = this->Triangles[t];
      const Box box{ corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]),
        corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]) };
      if (box.SquaredDistance(place) > best.SquaredDistance)
      {
        continue;
      }
      if (!anyNormal && (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(normal) < 0.0)
      {
        continue;
      }
      const std::array<double, 3> weights = ClosestWeights(place, corners);
      const Vector3 point =
        weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
      const double squared = (point - place).squaredNorm();
      const auto number = static_cast<Index>(t);
      if (squared < best.SquaredDistance ||
        (squared == best.SquaredDistance && (best.Triangle == None || number < best.Triangle)))
      {
        best = { number, point, squared, weights };
      }
    }
  }
  return best;
}
}
