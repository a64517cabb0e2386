// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Geometry/ClosestPoints.h"

#include "Support/MortonCurve.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
std::array<double, 3> ClosestPoints::ClosestWeights(const Vector3& p, const Corners& t)
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

ClosestPoints::ClosestPoints(const std::vector<Corners>& triangles)
  : Number(triangles.size())
{
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    this->Number[t] = static_cast<Index>(t);
  }
  this->Build(std::vector<Corners>(triangles));
}

ClosestPoints::ClosestPoints(const Surface& surface)
{
  const auto size = static_cast<Index>(surface.Points.size());
  std::vector<Corners> triangles;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Triangle& ids = surface.Triangles[t];
    if (std::all_of(ids.begin(), ids.end(),
          [&](Index p) { return p >= 0 && p < size && surface.Points[p].allFinite(); }))
    {
      triangles.push_back(
        { surface.Points[ids[0]], surface.Points[ids[1]], surface.Points[ids[2]] });
      this->Number.push_back(static_cast<Index>(t));
    }
  }
  this->Build(std::move(triangles));
}

void ClosestPoints::Build(std::vector<Corners>&& triangles)
{
  const auto count = static_cast<Index>(triangles.size());
  if (count == 0)
  {
    return;
  }
  double largest = 0.0;
  std::vector<Vector3> middles(count);
  LargeArray<Index> members(count);
  for (Index t = 0; t < count; ++t)
  {
    middles[t].setZero();
    for (const Vector3& p : triangles[t])
    {
      largest = std::max(largest, p.cwiseAbs().maxCoeff());
      middles[t] += p / 3.0;
    }
    members[t] = t;
  }
  this->Scale =
    largest > 0.0 ? std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1000, 1000)) : 1.0;
  const LargeArray<Index> order = MortonCurve::Sorted(middles, members);
  std::vector<Vector3>().swap(middles);
  this->Triangles.resize(count);
  std::vector<Index> number(count);
  ParallelFor(count, MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        number[t] = this->Number[order[t]];
        for (int c = 0; c < 3; ++c)
        {
          this->Triangles[t][c] = this->Scale * triangles[order[t]][c];
        }
      }
    });
  this->Number = std::move(number);
  for (Index below = count; this->Levels.empty() || below > 1;)
  {
    const Index nodes = NumberOfPieces(below, Width);
    std::vector<Node> level(nodes);
    const std::vector<Node>* const lower = this->Levels.empty() ? nullptr : &this->Levels.back();
    ParallelFor(nodes, MediumPiece,
      [&](Index begin, Index end)
      {
        // The last node of a level may have less than it could: the box of its last part is there several times.
        for (Index child = Width * begin; child < Width * end; ++child)
        {
          const Index k = std::min(child, below - 1);
          for (int axis = 0; axis < 3; ++axis)
          {
            double low = 0.0;
            double high = 0.0;
            if (lower != nullptr)
            {
              low = (*lower)[k].Low[axis].minCoeff();
              high = (*lower)[k].High[axis].maxCoeff();
            }
            else
            {
              const Corners& t = this->Triangles[k];
              low = std::min({ t[0][axis], t[1][axis], t[2][axis] });
              high = std::max({ t[0][axis], t[1][axis], t[2][axis] });
            }
            level[child / Width].Low[axis][child % Width] = low;
            level[child / Width].High[axis][child % Width] = high;
          }
        }
      });
    this->Levels.push_back(std::move(level));
    below = nodes;
  }
}

void ClosestPoints::Consider(
  Index at, const Vector3& place, const Vector3& normal, Answer& best) const
{
  const Corners& corners = this->Triangles[at];
  if (!normal.isZero(0.0) &&
    (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(normal) < 0.0)
  {
    return;
  }
  const std::array<double, 3> weights = ClosestWeights(place, corners);
  const Vector3 point = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
  const double squared = (point - place).squaredNorm();
  const Index number = this->Number[at];
  if (squared < best.SquaredDistance ||
    (squared == best.SquaredDistance && (best.Triangle == None || number < best.Triangle)))
  {
    best = { number, point, squared, weights, at };
  }
}

ClosestPoints::Answer ClosestPoints::Find(
  const Vector3& givenPlace, const Vector3& normal, double distance, Index guess) const
{
  Answer best;
  if (this->Triangles.empty() || !givenPlace.allFinite())
  {
    return best;
  }
  const Vector3 place = this->Scale * givenPlace;
  best.SquaredDistance = (this->Scale * distance) * (this->Scale * distance);
  if (guess != None)
  {
    this->Consider(guess, place, normal, best);
  }
  struct Entry
  {
    double Distance;
    Index Node;
    int Level;
  };
  // A level leaves at most three entries behind, and 4^16 are more triangles than can be numbered.
  std::array<Entry, 64> stack;
  std::size_t top = 0;
  stack[top++] = { 0.0, 0, static_cast<int>(this->Levels.size()) - 1 };
  while (top > 0)
  {
    const Entry entry = stack[--top];
    if (entry.Distance > best.SquaredDistance)
    {
      continue;
    }
    const Index first = Width * entry.Node;
    const Index below = entry.Level > 0 ? static_cast<Index>(this->Levels[entry.Level - 1].size())
                                        : static_cast<Index>(this->Triangles.size());
    const Node::Numbers distances = this->Levels[entry.Level][entry.Node].SquaredDistances(place);
    // The nearest one last, which is taken from the stack first.
    std::array<Entry, Width> children;
    int count = 0;
    for (Index k = 0; k < std::min(Width, below - first); ++k)
    {
      if (distances[k] <= best.SquaredDistance)
      {
        int at = count++;
        for (; at > 0 && children[at - 1].Distance < distances[k]; --at)
        {
          children[at] = children[at - 1];
        }
        children[at] = { distances[k], first + k, entry.Level - 1 };
      }
    }
    if (entry.Level > 0)
    {
      std::copy_n(children.begin(), count, stack.begin() + top);
      top += count;
      continue;
    }
    while (count > 0 && children[--count].Distance <= best.SquaredDistance)
    {
      this->Consider(children[count].Node, place, normal, best);
    }
  }
  best.Position /= this->Scale;
  best.SquaredDistance /= this->Scale * this->Scale;
  return best;
}
}
