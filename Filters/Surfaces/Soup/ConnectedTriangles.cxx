// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Soup/ConnectedTriangles.h"

#include "Soup/JoinedSets.h"
#include "Support/Threads.h"

#include <vector>

namespace DirectionFields::Internal
{
ConnectedTriangles::ConnectedTriangles(const LargeArray<Index>& twins)
  : Component(twins.size() / 3)
{
  const auto triangles = static_cast<Index>(this->Component.size());
  JoinedSets sets(triangles);
  // Within pieces at once, then over their borders.
  std::vector<std::vector<Index>> across(NumberOfPieces(triangles, LightPiece));
  ParallelFor(triangles, LightPiece,
    [&](Index begin, Index end)
    {
      for (Index h = 3 * begin; h < 3 * end; ++h)
      {
        const Index twin = twins[h];
        if (twin >= 3 * begin && twin < h)
        {
          sets.Join(h / 3, twin / 3);
        }
        else if (twin < 3 * begin && twin != None)
        {
          across[begin / LightPiece].push_back(h);
        }
      }
    });
  for (const std::vector<Index>& halfEdges : across)
  {
    for (const Index h : halfEdges)
    {
      sets.Join(h / 3, twins[h] / 3);
    }
  }
  for (Index t = 0; t < triangles; ++t)
  {
    const Index first = sets.Find(t);
    this->Component[t] = first == t ? this->Count++ : this->Component[first];
  }
}
}
