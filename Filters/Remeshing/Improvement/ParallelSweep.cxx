// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Improvement/ParallelSweep.h"

#include "Support/Threads.h"

#include <algorithm>

namespace DirectionFields::Internal
{
namespace
{
/// A visit takes some microseconds, about as long as it takes to begin a loop of several threads.
constexpr Index PieceSize = 16;
}

ParallelSweep::ParallelSweep(const MovableFaces& faces, const std::vector<Index>& vertices)
  : ByLevel(vertices.size())
{
  // The number of levels up to the last visited corner of each face.
  std::vector<Index> levels(faces.GetNumberOfFaces(), 0);
  std::vector<Index> level;
  level.reserve(vertices.size());
  for (const Index v : vertices)
  {
    Index most = 0;
    for (const Index f : faces.FacesAt(v))
    {
      most = std::max(most, levels[f]);
    }
    level.push_back(most);
    for (const Index f : faces.FacesAt(v))
    {
      levels[f] = most + 1;
    }
    if (static_cast<Index>(this->Begin.size()) < most + 2)
    {
      this->Begin.resize(most + 2, 0);
    }
    ++this->Begin[most + 1];
  }
  for (std::size_t k = 1; k < this->Begin.size(); ++k)
  {
    this->Begin[k] += this->Begin[k - 1];
  }
  std::vector<Index> next = this->Begin;
  for (std::size_t k = 0; k < vertices.size(); ++k)
  {
    this->ByLevel[next[level[k]]++] = vertices[k];
  }
}

void ParallelSweep::Run(const std::function<void(Index)>& visit) const
{
  for (std::size_t k = 0; k + 1 < this->Begin.size(); ++k)
  {
    const Index first = this->Begin[k];
    ParallelFor(this->Begin[k + 1] - first, PieceSize,
      [&](Index begin, Index end)
      {
        for (Index j = begin; j < end; ++j)
        {
          visit(this->ByLevel[first + j]);
        }
      });
  }
}
}
