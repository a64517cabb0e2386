// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curves/SplittableMesh.h"

#include <algorithm>
#include <cstddef>

namespace DirectionFields::Internal
{
SplittableMesh::SplittableMesh(const Surface& surface)
  : Points(surface.Points)
  , Triangles(surface.Triangles)
  , PartsOf(surface.Triangles.size())
  , Stars(surface.Points.size())
{
  const auto isThere = [&](Index p)
  { return p >= 0 && p < static_cast<Index>(this->Points.size()); };
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    const Triangle& corners = this->Triangles[t];
    this->Parents.push_back(static_cast<Index>(t));
    this->PartsOf[t].push_back(static_cast<Index>(t));
    if (std::all_of(corners.begin(), corners.end(), isThere) && corners[0] != corners[1] &&
      corners[1] != corners[2] && corners[2] != corners[0])
    {
      for (const Index p : corners)
      {
        this->Stars[p].push_back(static_cast<Index>(t));
      }
    }
  }
}

std::vector<Index> SplittableMesh::Between(Index p, Index q) const
{
  std::vector<Index> between;
  for (const Index t : this->Stars[p])
  {
    const Triangle& corners = this->Triangles[t];
    if (std::find(corners.begin(), corners.end(), q) != corners.end())
    {
      between.push_back(t);
    }
  }
  return between;
}

Index SplittableMesh::AddPoint(const Vector3& place)
{
  this->Points.push_back(place);
  this->Stars.emplace_back();
  return static_cast<Index>(this->Points.size()) - 1;
}

void SplittableMesh::AddPart(Index of, const Triangle& corners)
{
  const auto t = static_cast<Index>(this->Triangles.size());
  this->Triangles.push_back(corners);
  this->Parents.push_back(this->Parents[of]);
  this->PartsOf[this->Parents[of]].push_back(t);
  for (const Index p : corners)
  {
    this->Stars[p].push_back(t);
  }
}

Index SplittableMesh::SplitEdge(Index p, Index q, const Vector3& place)
{
  const std::vector<Index> between = this->Between(p, q);
  const Index middle = this->AddPoint(place);
  for (const Index t : between)
  {
    // What was at q is at the new point, and another triangle takes its place at q.
    Triangle other = this->Triangles[t];
    std::replace(other.begin(), other.end(), p, middle);
    std::replace(this->Triangles[t].begin(), this->Triangles[t].end(), q, middle);
    this->Stars[middle].push_back(t);
    std::vector<Index>& star = this->Stars[q];
    star.erase(std::find(star.begin(), star.end(), t));
    this->AddPart(t, other);
  }
  return middle;
}

Index SplittableMesh::SplitInside(Index t, const Vector3& place)
{
  const Triangle corners = this->Triangles[t];
  const Index middle = this->AddPoint(place);
  this->Triangles[t][2] = middle;
  this->Stars[middle].push_back(t);
  std::vector<Index>& star = this->Stars[corners[2]];
  star.erase(std::find(star.begin(), star.end(), t));
  this->AddPart(t, { corners[1], corners[2], middle });
  this->AddPart(t, { corners[2], corners[0], middle });
  return middle;
}
}
