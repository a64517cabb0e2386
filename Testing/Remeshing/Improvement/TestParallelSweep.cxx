// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Improvement/ParallelSweep.h"

#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <random>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
/// A grid of quads in the plane, with every vertex free.
struct Grid
{
  explicit Grid(int cells)
  {
    for (int j = 0; j <= cells; ++j)
    {
      for (int i = 0; i <= cells; ++i)
      {
        this->Points.emplace_back(i, j, 0.0);
        if (i < cells && j < cells)
        {
          const Index v = j * (cells + 1) + i;
          this->Cover.Corners.push_back({ v, v + 1, v + cells + 2, v + cells + 1 });
          this->Cover.IsRegular.push_back(1);
        }
      }
    }
    this->Domain.Line.assign(this->Points.size(), 0);
    this->Domain.EdgeLength.assign(this->Points.size(), 1.0);
  }

  std::vector<ClosestPoints> NoLines;
  ClosestPoints NoSurface{ std::vector<ClosestPoints::Corners>() };
  SmoothingDomain Domain{ this->NoSurface, this->NoLines, {}, {} };
  Faces Cover;
  std::vector<Vector3> Points;
};
}

/// Each value becomes that of a sum of the values around it, which differs with the order of the
/// vertices to the last bit: those of any number of threads are as in the given order.
TEST(ParallelSweep, IsAsOneVertexAfterTheOther)
{
  constexpr int cells = 40;
  Grid grid(cells);
  const VertexStars stars(grid.Cover, static_cast<Index>(grid.Points.size()));
  const MovableFaces faces(stars, grid.Domain, grid.Points);
  std::vector<Index> vertices(grid.Points.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  for (unsigned seed = 0; seed < 4; ++seed)
  {
    std::mt19937 engine(seed);
    if (seed > 0)
    {
      std::shuffle(vertices.begin(), vertices.end(), engine);
    }
    // Some are no part of the sweep.
    vertices.resize(vertices.size() - 100 * (seed % 2));
    const auto visit = [&](std::vector<double>& values, Index v)
    {
      // Long enough for the other threads to begin meanwhile.
      const auto end = std::chrono::steady_clock::now() + std::chrono::microseconds(3);
      while (std::chrono::steady_clock::now() < end)
      {
      }
      double sum = 0.0;
      for (const Index f : faces.FacesAt(v))
      {
        for (const Index w : faces.Face(f))
        {
          sum += values[w];
        }
      }
      values[v] = 0.3 * values[v] + 0.17 * sum;
    };
    std::vector<double> expected(grid.Points.size(), 1.0);
    for (int k = 0; k < 3; ++k)
    {
      for (const Index v : vertices)
      {
        visit(expected, v);
      }
    }
    for (const int number : { 1, 2, 4 })
    {
      Threads threads(number);
      const Threads::Scope scope(threads);
      std::vector<double> values(grid.Points.size(), 1.0);
      const ParallelSweep sweep(faces, vertices);
      for (int k = 0; k < 3; ++k)
      {
        sweep.Run([&](Index v) { visit(values, v); });
      }
      EXPECT_EQ(values, expected) << seed << ", " << number;
    }
  }
}

TEST(ParallelSweep, OfNoVerticesVisitsNone)
{
  Grid grid(2);
  const VertexStars stars(grid.Cover, static_cast<Index>(grid.Points.size()));
  const MovableFaces faces(stars, grid.Domain, grid.Points);
  ParallelSweep(faces, {}).Run([](Index) { FAIL(); });
}
