// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Improvement/FoldedQuads.h"

#include "Support/SortedEnds.h"

#include <algorithm>
#include <set>

namespace DirectionFields::Internal
{
namespace
{
/// The two triangles that the diagonal from corner c on makes.
std::array<Faces::Face, 2> Halves(const Faces::Face& quad, int c)
{
  const Index a = quad[c];
  const Index b = quad[(c + 1) % 4];
  const Index d = quad[(c + 2) % 4];
  const Index e = quad[(c + 3) % 4];
  return { Faces::Face{ a, b, d, None }, Faces::Face{ a, d, e, None } };
}

/// The quality of the worse triangle, from 0 to 1, if both face the same way; else negative.
double QualityOf(const std::array<Faces::Face, 2>& halves, const std::vector<Vector3>& points)
{
  std::array<Vector3, 2> normal;
  double quality = 1.0;
  for (int i = 0; i < 2; ++i)
  {
    const Faces::Face& t = halves[i];
    normal[i] = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
    quality = std::min(quality, ScaledJacobian(points, t));
  }
  return normal[0].dot(normal[1]) > 0.0 ? quality : quality - 1.0;
}
}

Index CutFoldedQuads(Faces& faces, const std::vector<Vector3>& points, double quality)
{
  std::vector<std::size_t> folded;
  for (std::size_t f = 0; f < faces.Corners.size(); ++f)
  {
    if (Faces::Size(faces.Corners[f]) == 4 && ScaledJacobian(points, faces.Corners[f]) <= quality)
    {
      folded.push_back(f);
    }
  }
  if (folded.empty())
  {
    return 0;
  }
  const std::vector<std::array<Index, 2>> edges = EdgesOf(faces);
  std::set<std::array<Index, 2>> diagonals;
  Index cut = 0;
  for (const std::size_t f : folded)
  {
    const Faces::Face quad = faces.Corners[f];
    int best = -1;
    double bestQuality = -1.0;
    for (int c = 0; c < 2; ++c)
    {
      const std::array<Index, 2> diagonal = SortedEnds(quad[c], quad[c + 2]);
      const double both = QualityOf(Halves(quad, c), points);
      if (both > bestQuality && !std::binary_search(edges.begin(), edges.end(), diagonal) &&
        diagonals.count(diagonal) == 0)
      {
        best = c;
        bestQuality = both;
      }
    }
    if (best >= 0)
    {
      const std::array<Faces::Face, 2> halves = Halves(quad, best);
      diagonals.insert(SortedEnds(quad[best], quad[best + 2]));
      faces.Corners[f] = halves[0];
      faces.IsRegular[f] = 0;
      faces.Corners.push_back(halves[1]);
      faces.IsRegular.push_back(0);
      ++cut;
    }
  }
  return cut;
}
}
