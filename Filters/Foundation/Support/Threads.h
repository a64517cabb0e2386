// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Threads_h
#define DirectionFields_Threads_h

#include "Types.h"

#include <functional>
#include <memory>
#include <vector>

namespace DirectionFields
{
/// The threads that one computation runs its loops on. While a Threads::Scope is alive, ParallelFor
/// and ParallelSum of the thread that made it are shared out among them; without one, and inside of
/// a loop that is shared out already, they run where they are called.
///
/// Loops are cut into the same pieces and sums are added up in the same order for any number of
/// threads: results have the same bytes.
class Threads
{
public:
  /// @param number of threads, the calling one included; 0 for as many as the process may run at
  ///               once, but no more than the environment variable OMP_NUM_THREADS says
  explicit Threads(int number = 0);
  ~Threads();
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

  int GetNumber() const;
  /// The number that 0 stands for; at least 1.
  static int GetDefaultNumber();

  /// Makes the threads those of the calling thread's loops, until it is destroyed.
  class Scope
  {
  public:
    explicit Scope(Threads& threads);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

  private:
    Threads* Outer;
  };

  /// Calls body(k) once for each piece k = 0 ... pieces - 1, in no particular order. The first
  /// exception that a piece throws is thrown again once all that have begun are done.
  static void Run(Index pieces, const std::function<void(Index)>& body);

private:
  class Pool;
  std::unique_ptr<Pool> Workers;
};

/// How many items of a loop a thread takes at a time: the more there is to do for each, the fewer.
/// These are for a few operations each, as in a copy;
constexpr Index LightPiece = 1 << 13;
/// for some dozens, as for the angles around a vertex;
constexpr Index MediumPiece = 1 << 12;
/// and for hundreds, as for a column of a matrix.
constexpr Index HeavyPiece = 1 << 11;

/// How many pieces of at most the given size a loop has.
inline Index NumberOfPieces(Index count, Index size)
{
  return count / size + (count % size != 0 ? 1 : 0);
}

/// Calls body(begin, end) for pieces of [0, count) of the given size. The pieces must not touch
/// each other's results.
template <typename Body>
void ParallelFor(Index count, Index size, const Body& body)
{
  if (count <= size)
  {
    if (count > 0)
    {
      body(Index(0), count);
    }
    return;
  }
  Threads::Run(NumberOfPieces(count, size),
    [&](Index piece)
    {
      const Index begin = piece * size;
      body(begin, count - begin < size ? count : begin + size);
    });
}

/// The sum of body(begin, end) over pieces of [0, count), added up in their order to zero.
template <typename Sum, typename Body>
Sum ParallelSum(Index count, Index size, const Sum& zero, const Body& body)
{
  std::vector<Sum> parts(NumberOfPieces(count, size), zero);
  ParallelFor(count, size, [&](Index begin, Index end) { parts[begin / size] = body(begin, end); });
  Sum sum = zero;
  for (const Sum& part : parts)
  {
    sum += part;
  }
  return sum;
}
}

#endif
