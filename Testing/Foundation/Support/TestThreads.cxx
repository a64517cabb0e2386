// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/Threads.h"

#include "DirectionField.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace DirectionFields;

TEST(Threads, ALoopVisitsEachNumberOnceForAnyNumberOfThreads)
{
  for (const int number : { 1, 2, 3, 8 })
  {
    Threads threads(number);
    EXPECT_EQ(threads.GetNumber(), number);
    const Threads::Scope scope(threads);
    for (const Index count : { 0, 1, 6, 7, 8, 1000 })
    {
      std::vector<int> visits(count, 0);
      ParallelFor(count, 7,
        [&](Index begin, Index end)
        {
          EXPECT_LE(end - begin, 7);
          EXPECT_LT(begin, end);
          for (Index k = begin; k < end; ++k)
          {
            ++visits[k];
          }
        });
      EXPECT_EQ(visits, std::vector<int>(count, 1));
    }
  }
}

TEST(Threads, LoopsRunOnSeveralThreadsWithinTheirScopeOnly)
{
  Threads threads(2);
  std::atomic<int> others{ 0 };
  const std::thread::id here = std::this_thread::get_id();
  const auto run = [&]
  {
    others = 0;
    ParallelFor(40, 1,
      [&](Index, Index)
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        others += std::this_thread::get_id() != here;
      });
    return others.load();
  };
  EXPECT_EQ(run(), 0);
  {
    const Threads::Scope scope(threads);
    EXPECT_GT(run(), 0);
  }
  EXPECT_EQ(run(), 0);
}

TEST(Threads, SumsHaveTheSameBytesForAnyNumberOfThreads)
{
  const auto sum = []
  {
    return ParallelSum<double>(100000, 512, 0.0,
      [](Index begin, Index end)
      {
        double part = 0.0;
        for (Index k = begin; k < end; ++k)
        {
          part += std::sin(k) / (k + 1.0);
        }
        return part;
      });
  };
  const double serial = sum();
  for (const int number : { 1, 2, 3, 5 })
  {
    Threads threads(number);
    const Threads::Scope scope(threads);
    for (int repetition = 0; repetition < 20; ++repetition)
    {
      EXPECT_EQ(sum(), serial);
    }
  }
}

TEST(Threads, LoopsInsideOfLoopsAndOfSeveralThreadsWork)
{
  const auto work = []
  {
    Threads threads(3);
    const Threads::Scope scope(threads);
    for (int repetition = 0; repetition < 200; ++repetition)
    {
      const auto sum = ParallelSum<Index>(10, 1, 0,
        [](Index begin, Index)
        { return ParallelSum<Index>(begin, 1, 0, [](Index inner, Index) { return inner; }); });
      // Sum over k < 10 of k (k - 1) / 2.
      EXPECT_EQ(sum, 120);
    }
  };
  std::thread other(work);
  work();
  other.join();
}

TEST(Threads, AnExceptionOfAPieceReachesTheCaller)
{
  for (const int number : { 1, 4 })
  {
    Threads threads(number);
    const Threads::Scope scope(threads);
    EXPECT_THROW(ParallelFor(100, 1,
                   [](Index begin, Index)
                   {
                     if (begin == 17)
                     {
                       throw std::runtime_error("piece 17");
                     }
                   }),
      std::runtime_error);
    EXPECT_EQ(ParallelSum<Index>(100, 1, 0, [](Index, Index) { return 1; }), 100);
  }
}

TEST(Threads, TwoFieldsInTwoThreadsAreThoseOfOne)
{
  const Surface surface = Meshes::Potato(3);
  Options options;
  options.ConstrainCurvature = true;
  options.Alignment = Alignment::PrincipalCurvature;
  const Result alone = DirectionField(surface).Compute(options);
  Result results[2];
  const auto work = [&](int k) { results[k] = DirectionField(surface).Compute(options); };
  std::thread other(work, 1);
  work(0);
  other.join();
  for (const Result& result : results)
  {
    EXPECT_EQ(result.Representation, alone.Representation);
    EXPECT_EQ(result.SingularityIndex, alone.SingularityIndex);
  }
}
