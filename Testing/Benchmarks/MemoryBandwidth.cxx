// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "MemoryBandwidth.h"

#include "Support/Threads.h"

#include <algorithm>
#include <chrono>

double MemoryBandwidth(int numberOfThreads)
{
  using namespace DirectionFields;
  constexpr Index Size = 1 << 25;
  constexpr Index Piece = 1 << 16;
  constexpr int Passes = 6;
  Threads threads(numberOfThreads);
  const Threads::Scope scope(threads);
  std::vector<double> a(Size, 0.0);
  const std::vector<double> b(Size, 1.0);
  const std::vector<double> c(Size, 2.0);
  double best = 0.0;
  for (int pass = 0; pass < Passes; ++pass)
  {
    const auto begin = std::chrono::steady_clock::now();
    ParallelFor(Size, Piece,
      [&, factor = 1.0 + pass](Index first, Index end)
      {
        for (Index i = first; i < end; ++i)
        {
          a[i] = b[i] + factor * c[i];
        }
      });
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    best = std::max(best, 24.0 * Size / time.count());
  }
  return best;
}
