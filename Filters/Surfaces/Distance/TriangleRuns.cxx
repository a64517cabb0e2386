// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/TriangleRuns.h"

#include "Support/Threads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace DirectionFields::Internal
{
TriangleRuns::TriangleRuns(const Surface& surface, LargeArray<Index>&& order)
  : Input(surface)
  , Order(std::move(order))
{
  const auto count = static_cast<Index>(this->Order.size());
  this->Boxes.resize(NumberOfPieces(count, RunSize));
  ParallelFor(static_cast<Index>(this->Boxes.size()), MediumPiece / RunSize,
    [&](Index begin, Index end)
    {
      for (Index run = begin; run < end; ++run)
      {
        Box box{ Vector3::Constant(std::numeric_limits<double>::infinity()),
          Vector3::Constant(-std::numeric_limits<double>::infinity()) };
        for (Index k = RunSize * run; k < std::min(count, RunSize * (run + 1)); ++k)
        {
          for (const Index point : this->Input.Triangles[this->Order[k]])
          {
            box.Low = box.Low.cwiseMin(this->Input.Points[point]);
            box.High = box.High.cwiseMax(this->Input.Points[point]);
          }
        }
        this->Boxes[run] = box;
      }
    });
  double largest = 0.0;
  for (const Box& box : this->Boxes)
  {
    largest = std::max({ largest, box.Low.cwiseAbs().maxCoeff(), box.High.cwiseAbs().maxCoeff() });
  }
  this->Scale =
    largest > 0.0 ? std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1000, 1000)) : 1.0;
}

ClosestPoints::Answer TriangleRuns::Find(const Vector3& givenPlace) const
{
  ClosestPoints::Answer best;
  if (!givenPlace.allFinite())
  {
    return best;
  }
  best.SquaredDistance = std::numeric_limits<double>::infinity();
  const Vector3 place = this->Scale * givenPlace;
  // The nearest box comes first: few of the others are nearer than its closest point.
  std::vector<std::pair<double, Index>> runs(this->Boxes.size());
  for (std::size_t run = 0; run < runs.size(); ++run)
  {
    const Box& box = this->Boxes[run];
    const Vector3 outside = (this->Scale * box.Low - place)
                              .cwiseMax(place - this->Scale * box.High)
                              .cwiseMax(Vector3::Zero());
    runs[run] = { outside.squaredNorm(), static_cast<Index>(run) };
  }
  const auto isFarther = std::greater<>();
  std::make_heap(runs.begin(), runs.end(), isFarther);
  while (!runs.empty() && runs.front().first <= best.SquaredDistance)
  {
    const Index first = RunSize * runs.front().second;
    std::pop_heap(runs.begin(), runs.end(), isFarther);
    runs.pop_back();
    for (Index k = first; k < std::min(static_cast<Index>(this->Order.size()), first + RunSize);
         ++k)
    {
      const Index triangle = this->Order[k];
      const Triangle& ids = this->Input.Triangles[triangle];
      const ClosestPoints::Corners corners = { this->Scale * this->Input.Points[ids[0]],
        this->Scale * this->Input.Points[ids[1]], this->Scale * this->Input.Points[ids[2]] };
      const std::array<double, 3> weights = ClosestPoints::ClosestWeights(place, corners);
      const Vector3 point =
        weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
      const double squared = (point - place).squaredNorm();
      if (squared < best.SquaredDistance ||
        (squared == best.SquaredDistance && (best.Triangle == None || triangle < best.Triangle)))
      {
        best = { triangle, point, squared, weights };
      }
    }
  }
  best.Position /= this->Scale;
  best.SquaredDistance /= this->Scale * this->Scale;
  return best;
}
}
