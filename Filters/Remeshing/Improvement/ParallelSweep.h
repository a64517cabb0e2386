// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ParallelSweep_h
#define DirectionFields_ParallelSweep_h

#include "FaceMesh/MovableFaces.h"

#include <functional>
#include <vector>

namespace DirectionFields::Internal
{
/// A sweep over vertices that is shared among threads and ends with the same bytes as one vertex
/// after the other: a vertex waits for those before it that it shares a face with, and for no
/// others.
class ParallelSweep
{
public:
  /// @param vertices in the order in which they are visited, each once
  ParallelSweep(const MovableFaces& faces, const std::vector<Index>& vertices);

  /// Calls visit for each vertex. It may change the vertex, and read the corners of its faces.
  void Run(const std::function<void(Index)>& visit) const;

private:
  /// Those of one level share no face, and wait for vertices of the levels before.
  std::vector<Index> ByLevel;
  /// Where the levels begin, and the end.
  std::vector<Index> Begin;
};
}

#endif
