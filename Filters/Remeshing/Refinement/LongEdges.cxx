// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Refinement/LongEdges.h"

#include <algorithm>
#include <functional>

namespace DirectionFields::Internal
{
std::vector<char> FindLongEdges(
  const SurfaceGeometry& geometry, const std::vector<double>& longest, Index mostMiddles)
{
  const TriangleMesh& mesh = geometry.Mesh;
  // How many times as long as they may be.
  std::vector<double> excess(mesh.GetNumberOfEdges(), 0.0);
  std::vector<double> tooLong;
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index tail = mesh.Tail(mesh.HalfEdge(e));
    const Index head = mesh.Head(mesh.HalfEdge(e));
    const double most = std::min(longest[mesh.Point(tail)], longest[mesh.Point(head)]);
    excess[e] = (geometry.Positions[head] - geometry.Positions[tail]).stableNorm() / most;
    if (excess[e] > 1.0)
    {
      tooLong.push_back(excess[e]);
    }
  }
  double limit = 1.0;
  const auto room = static_cast<std::size_t>(std::max<Index>(0, mostMiddles));
  if (tooLong.size() > room)
  {
    const auto last = tooLong.begin() + static_cast<std::ptrdiff_t>(room);
    std::nth_element(tooLong.begin(), last, tooLong.end(), std::greater<>());
    limit = *last;
  }
  std::vector<char> isLong(excess.size(), 0);
  for (std::size_t e = 0; e < excess.size(); ++e)
  {
    isLong[e] = excess[e] > limit ? 1 : 0;
  }
  return isLong;
}
}
