// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Charts/FeatureIsolines.h"

#include <algorithm>

namespace DirectionFields::Internal
{
namespace
{
class Isolines
{
public:
  Isolines(const CutMesh& mesh, const std::vector<char>& isPoint)
    : Mesh(mesh)
    , IsPoint(isPoint)
    , EdgesAt(mesh.Positions.size())
    , IsSeen(mesh.Isolines.size(), 0)
  {
    for (std::size_t e = 0; e < mesh.Isolines.size(); ++e)
    {
      this->EdgesAt[this->End(e, false)].push_back(e);
      this->EdgesAt[this->End(e, true)].push_back(e);
    }
  }

  std::vector<FeatureIsoline> FollowAll()
  {
    std::vector<FeatureIsoline> isolines;
    // Isolines between grid points, then closed ones.
    for (const bool fromPoints : { true, false })
    {
      for (std::size_t v = 0; v < this->EdgesAt.size(); ++v)
      {
        if (this->IsEnd(static_cast<Index>(v)) != fromPoints)
        {
          continue;
        }
        for (const std::size_t e : this->EdgesAt[v])
        {
          if (this->IsSeen[e] == 0)
          {
            isolines.push_back(this->Follow(static_cast<Index>(v), e));
          }
        }
      }
    }
    return isolines;
  }

private:
  Index End(std::size_t e, bool atHead) const
  {
    return EndOf(this->Mesh, this->Mesh.Isolines[e], atHead);
  }
  bool IsEnd(Index v) const { return this->IsPoint[v] != 0 || this->EdgesAt[v].size() != 2; }

  FeatureIsoline Follow(Index start, std::size_t first)
  {
    FeatureIsoline isoline;
    Index v = start;
    std::size_t e = first;
    while (true)
    {
      this->IsSeen[e] = 1;
      const bool isReversed = this->End(e, false) != v;
      isoline.Steps.push_back({ e, isReversed });
      v = this->End(e, !isReversed);
      if (v == start || this->IsEnd(v))
      {
        return isoline;
      }
      const std::vector<std::size_t>& edges = this->EdgesAt[v];
      const auto next = std::find_if(
        edges.begin(), edges.end(), [&](std::size_t k) { return this->IsSeen[k] == 0; });
      if (next == edges.end())
      {
        return isoline;
      }
      e = *next;
    }
  }

  const CutMesh& Mesh;
  const std::vector<char>& IsPoint;
  /// The edges of isolines at each vertex.
  std::vector<std::vector<std::size_t>> EdgesAt;
  std::vector<char> IsSeen;
};
}

std::vector<FeatureIsoline> FindFeatureIsolines(
  const CutMesh& mesh, const std::vector<char>& isPoint)
{
  return Isolines(mesh, isPoint).FollowAll();
}
}
