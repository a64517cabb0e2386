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
  , First(surface.Points.size(), None)
  , Last(surface.Points.size(), None)
  , Next(3 * surface.Triangles.size(), None)
  , Previous(3 * surface.Triangles.size(), None)
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
      for (Index c = 0; c < 3; ++c)
      {
        this->Append(static_cast<Index>(3 * t) + c);
      }
    }
  }
}

std::vector<Index> SplittableMesh::At(Index p) const
{
  std::vector<Index> triangles;
  for (Index corner = this->First[p]; corner != None; corner = this->Next[corner])
  {
    triangles.push_back(corner / 3);
  }
  return triangles;
}

bool SplittableMesh::Has(Index t, Index p) const
{
  const Triangle& corners = this->Triangles[t];
  return std::find(corners.begin(), corners.end(), p) != corners.end();
}

std::vector<Index> SplittableMesh::Between(Index p, Index q) const
{
  Index a = this->First[p];
  Index b = this->First[q];
  while (a != None && b != None)
  {
    a = this->Next[a];
    b = this->Next[b];
  }
  const bool isShorterAtFirst = a == None;
  const Index other = isShorterAtFirst ? q : p;
  std::vector<Index> between;
  for (Index k = this->First[isShorterAtFirst ? p : q]; k != None; k = this->Next[k])
  {
    if (this->Has(k / 3, other))
    {
      between.push_back(k / 3);
    }
  }
  return between;
}

Index SplittableMesh::CornerAt(Index t, Index p) const
{
  const Triangle& corners = this->Triangles[t];
  return 3 * t + static_cast<Index>(std::find(corners.begin(), corners.end(), p) - corners.begin());
}

void SplittableMesh::Append(Index corner)
{
  const Index p = this->Triangles[corner / 3][corner % 3];
  this->Next[corner] = None;
  this->Previous[corner] = this->Last[p];
  (this->Last[p] == None ? this->First[p] : this->Next[this->Last[p]]) = corner;
  this->Last[p] = corner;
}

void SplittableMesh::Remove(Index corner)
{
  const Index p = this->Triangles[corner / 3][corner % 3];
  const Index before = this->Previous[corner];
  const Index after = this->Next[corner];
  (before == None ? this->First[p] : this->Next[before]) = after;
  (after == None ? this->Last[p] : this->Previous[after]) = before;
}

Index SplittableMesh::AddPoint(const Vector3& place)
{
  this->Points.push_back(place);
  this->First.push_back(None);
  this->Last.push_back(None);
  return static_cast<Index>(this->Points.size()) - 1;
}

void SplittableMesh::AddPart(Index of, const Triangle& corners)
{
  const auto t = static_cast<Index>(this->Triangles.size());
  this->Triangles.push_back(corners);
  this->Parents.push_back(this->Parents[of]);
  this->PartsOf[this->Parents[of]].push_back(t);
  this->Next.resize(this->Next.size() + 3, None);
  this->Previous.resize(this->Previous.size() + 3, None);
  for (Index c = 0; c < 3; ++c)
  {
    this->Append(3 * t + c);
  }
}

Index SplittableMesh::SplitEdge(Index p, Index q, const Vector3& place)
{
  const std::vector<Index> between = this->Between(p, q);
  const Index middle = this->AddPoint(place);
  for (const Index t : between)
  {
    // The corner at q moves to the new point, and another triangle takes its place at q.
    Triangle other = this->Triangles[t];
    std::replace(other.begin(), other.end(), p, middle);
    const Index corner = this->CornerAt(t, q);
    this->Remove(corner);
    this->Triangles[t][corner % 3] = middle;
    this->Append(corner);
    this->AddPart(t, other);
  }
  return middle;
}

Index SplittableMesh::SplitInside(Index t, const Vector3& place)
{
  const Triangle corners = this->Triangles[t];
  const Index middle = this->AddPoint(place);
  this->Remove(3 * t + 2);
  this->Triangles[t][2] = middle;
  this->Append(3 * t + 2);
  this->AddPart(t, { corners[1], corners[2], middle });
  this->AddPart(t, { corners[2], corners[0], middle });
  return middle;
}

Index SplittableMesh::WorseAcross(Index t, Index p, Index q) const
{
  constexpr double rounding = 1e-9;
  const std::vector<Index> between = this->Between(p, q);
  if (between.size() != 2)
  {
    return None;
  }
  const Index other = between[between[0] == t ? 1 : 0];
  if (this->Parents[other] != this->Parents[t])
  {
    return None;
  }
  const auto apex = [&](Index triangle)
  {
    const Triangle& c = this->Triangles[triangle];
    return this->Points[*std::find_if(
      c.begin(), c.end(), [&](Index corner) { return corner != p && corner != q; })];
  };
  const Vector3& from = this->Points[p];
  const Vector3& to = this->Points[q];
  const Vector3 a = apex(t);
  const Vector3 b = apex(other);
  const Vector3 atA = (from - a).cross(to - a);
  const Vector3 atB = (to - b).cross(from - b);
  const Vector3 normal = atA + atB;
  const double least = rounding * normal.squaredNorm();
  // The angles across from the edge are more than 180 degrees together.
  const double sine =
    atA.dot(normal) * (to - b).dot(from - b) + atB.dot(normal) * (from - a).dot(to - a);
  const bool isWorse = sine < -least * (to - from).squaredNorm();
  const bool isConvex =
    normal.dot((b - from).cross(a - from)) > least && normal.dot((a - to).cross(b - to)) > least;
  return isWorse && isConvex ? other : None;
}

void SplittableMesh::Turn(Index t, Index other, Index p, Index q)
{
  const auto replace = [this](Index triangle, Index old, Index fresh)
  {
    const Index corner = this->CornerAt(triangle, old);
    this->Remove(corner);
    this->Triangles[triangle][corner % 3] = fresh;
    this->Append(corner);
  };
  const auto apex = [&](Index triangle)
  {
    const Triangle& c = this->Triangles[triangle];
    return *std::find_if(
      c.begin(), c.end(), [&](Index corner) { return corner != p && corner != q; });
  };
  const Index a = apex(t);
  const Index b = apex(other);
  replace(t, q, b);
  replace(other, p, a);
}

void SplittableMesh::TurnEdges(Index p, const std::function<bool(Index, Index)>& isFixed)
{
  std::vector<Index> triangles = this->At(p);
  while (!triangles.empty())
  {
    const Index t = triangles.back();
    triangles.pop_back();
    const Triangle corners = this->Triangles[t];
    const auto c = std::find(corners.begin(), corners.end(), p) - corners.begin();
    const Index from = corners[(c + 1) % 3];
    const Index to = corners[(c + 2) % 3];
    const Index other = isFixed(from, to) ? None : this->WorseAcross(t, from, to);
    if (other != None)
    {
      this->Turn(t, other, from, to);
      triangles.insert(triangles.end(), { t, other });
    }
  }
}
}
