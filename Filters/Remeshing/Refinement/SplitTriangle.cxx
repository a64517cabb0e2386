// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Refinement/SplitTriangle.h"

#include "Support/SortedEnds.h"

#include <algorithm>

namespace DirectionFields::Internal
{
std::array<Index, 2> EndsOf(const TriangleMesh& mesh, Index h)
{
  return SortedEnds(mesh.Point(mesh.Tail(h)), mesh.Point(mesh.Head(h)));
}

SplitTriangle::SplitTriangle(
  const TriangleMesh& mesh, Index t, const std::map<std::array<Index, 2>, Index>& middles)
{
  for (Index h = 3 * t; h < 3 * t + 3; ++h)
  {
    this->Points.push_back(mesh.Point(mesh.Tail(h)));
    this->IsMiddle.push_back(0);
    const auto found = middles.find(EndsOf(mesh, h));
    if (found != middles.end())
    {
      this->Points.push_back(found->second);
      this->IsMiddle.push_back(1);
    }
  }
}

void SplitTriangle::Cut(std::vector<Triangle>& triangles) const
{
  const std::size_t count = this->Points.size();
  std::vector<Index> rest;
  std::size_t start = 0;
  bool hasStart = false;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t before = (i + count - 1) % count;
    const std::size_t after = (i + 1) % count;
    if (this->IsMiddle[i] == 0 && this->IsMiddle[before] != 0 && this->IsMiddle[after] != 0)
    {
      triangles.push_back({ this->Points[before], this->Points[i], this->Points[after] });
      continue;
    }
    if (this->IsMiddle[i] != 0 && !hasStart)
    {
      start = rest.size();
      hasStart = true;
    }
    rest.push_back(this->Points[i]);
  }
  for (std::size_t i = 1; i + 1 < rest.size(); ++i)
  {
    triangles.push_back(
      { rest[start], rest[(start + i) % rest.size()], rest[(start + i + 1) % rest.size()] });
  }
}
}
