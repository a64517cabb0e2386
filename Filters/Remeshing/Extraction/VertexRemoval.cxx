// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Extraction/VertexRemoval.h"

#include "Extraction/DelaunayFlips.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace DirectionFields::Internal
{
namespace
{
/// The quality of a triangle two corners of which are at the same place.
constexpr double NoArea = 1e-9;
}

double VertexRemoval::QualityOf(int i, int j, int k, Mode mode) const
{
  if (mode != Mode::Relaxed)
  {
    const GridPoint& p = this->Star.Places[i];
    const GridPoint& q = this->Star.Places[j];
    const GridPoint& r = this->Star.Places[k];
    const int orientation = IntegerGrid::Orientation(p, q, r);
    if (orientation <= 0)
    {
      const bool isAllowed =
        mode == Mode::Joining && orientation == 0 && (p == q || q == r || r == p);
      return isAllowed ? NoArea : -1.0;
    }
    const IntegerGrid& plane = this->Mesh.GetPlane();
    const Complex u = plane.Place(q - p);
    const Complex v = plane.Place(r - p);
    return (std::conj(u) * v).imag() / (std::norm(u) + std::norm(v) + std::norm(v - u));
  }
  const Vector3& p = this->Mesh.Position(this->Star.Ring[i]);
  const Vector3 u = this->Mesh.Position(this->Star.Ring[j]) - p;
  const Vector3 v = this->Mesh.Position(this->Star.Ring[k]) - p;
  const double squares = u.squaredNorm() + v.squaredNorm() + (v - u).squaredNorm();
  const double quality = u.cross(v).dot(this->Normal) / squares;
  return quality > 0.01 ? quality : -1.0;
}

bool VertexRemoval::Triangulate(
  const std::vector<int>& polygon, Mode mode, std::vector<Triangle>& triangles)
{
  const int count = static_cast<int>(polygon.size());
  if (count < 3)
  {
    return true;
  }
  const auto ringSize = this->Star.Ring.size();
  this->Best.assign(static_cast<std::size_t>(count) * count, -1.0);
  this->Choice.assign(static_cast<std::size_t>(count) * count, -1);
  const auto at = [&](int i, int j) { return static_cast<std::size_t>(i) * count + j; };
  for (int i = 0; i + 1 < count; ++i)
  {
    this->Best[at(i, i + 1)] = std::numeric_limits<double>::infinity();
  }
  for (int length = 2; length < count; ++length)
  {
    for (int i = 0; i + length < count; ++i)
    {
      const int j = i + length;
      if (length < count - 1 && this->Joined[polygon[i] * ringSize + polygon[j]] != 0)
      {
        continue;
      }
      for (int k = i + 1; k < j; ++k)
      {
        const double sides = std::min(this->Best[at(i, k)], this->Best[at(k, j)]);
        if (sides <= this->Best[at(i, j)])
        {
          continue;
        }
        const double quality =
          std::min(sides, this->QualityOf(polygon[i], polygon[k], polygon[j], mode));
        if (quality > this->Best[at(i, j)])
        {
          this->Best[at(i, j)] = quality;
          this->Choice[at(i, j)] = k;
        }
      }
    }
  }
  if (this->Best[at(0, count - 1)] <= 0.0)
  {
    return false;
  }
  std::vector<std::pair<int, int>> open = { { 0, count - 1 } };
  while (!open.empty())
  {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j - i < 2)
    {
      continue;
    }
    const int k = this->Choice[at(i, j)];
    triangles.push_back({ polygon[i], polygon[k], polygon[j] });
    open.emplace_back(i, k);
    open.emplace_back(k, j);
  }
  return true;
}

bool VertexRemoval::FindFeature(std::array<Index, 2>& feature) const
{
  feature = { None, None };
  int spokes = 0;
  for (std::size_t i = 0; i < this->Star.Star.size(); ++i)
  {
    if (this->Mesh.IsFeature(this->Star.Star[i]))
    {
      if (spokes < 2)
      {
        feature[spokes] = static_cast<Index>(i);
      }
      ++spokes;
    }
  }
  if (this->Star.IsOpen)
  {
    // The last edge of the boundary, which no outgoing half-edge stands for.
    feature[1] = static_cast<Index>(this->Star.Ring.size()) - 1;
    return spokes == 1;
  }
  return spokes == 0 || spokes == 2;
}

void VertexRemoval::FindJoined()
{
  const std::size_t count = this->Star.Ring.size();
  this->Joined.assign(count * count, 0);
  this->Stamp.resize(this->Mesh.GetNumberOfVertices(), None);
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Stamp[this->Star.Ring[i]] = static_cast<Index>(i);
  }
  const bool isOpen = this->Star.IsOpen;
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Mesh.GetStar(this->Star.Ring[i], this->Scratch);
    const auto mark = [&](Index w)
    {
      const Index j = this->Stamp[w];
      if (j == None)
      {
        return;
      }
      const std::size_t distance = (j + count - i) % count;
      const bool areNext = (distance == 1 && !(isOpen && i == count - 1)) ||
        (distance == count - 1 && !(isOpen && i == 0));
      if (!areNext)
      {
        this->Joined[i * count + j] = this->Joined[j * count + i] = 1;
      }
    };
    for (const Index h : this->Scratch)
    {
      mark(this->Mesh.Head(h));
      mark(this->Mesh.Tail(ExtractionMesh::Previous(h)));
    }
  }
}

/// Whether no vertex is twice in the ring, and the star is not all but one triangle of a
/// tetrahedron.
bool VertexRemoval::IsSimple()
{
  std::vector<Index> ring = this->Star.Ring;
  std::sort(ring.begin(), ring.end());
  if (std::adjacent_find(ring.begin(), ring.end()) != ring.end())
  {
    return false;
  }
  if (this->Star.Star.size() == 3 && !this->Star.IsOpen)
  {
    std::array<Index, 3> beyond{};
    for (int i = 0; i < 3; ++i)
    {
      const Index twin = this->Mesh.Twin(ExtractionMesh::Next(this->Star.Star[i]));
      beyond[i] = twin == None ? None : twin / 3;
    }
    return beyond[0] == None || beyond[0] != beyond[1] || beyond[0] != beyond[2];
  }
  return true;
}

/// Whether two vertices of the ring are at the same place.
bool VertexRemoval::HasCoincidence() const
{
  for (std::size_t i = 0; i < this->Star.Places.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      if (this->Star.Places[i] == this->Star.Places[j])
      {
        return true;
      }
    }
  }
  return false;
}

bool VertexRemoval::KeepsOrientations(const std::vector<Triangle>& triangles) const
{
  Index wrong = 0;
  for (const Triangle& t : triangles)
  {
    wrong += IntegerGrid::Orientation(
               this->Star.Places[t[0]], this->Star.Places[t[1]], this->Star.Places[t[2]]) > 0
      ? 0
      : 1;
  }
  return wrong <= static_cast<Index>(this->Star.Star.size()) - this->Star.Positive;
}

bool VertexRemoval::Remove(Index v, Mode mode)
{
  this->Mesh.LayOut(v, this->Star);
  const auto count = static_cast<Index>(this->Star.Ring.size());
  std::array<Index, 2> feature{};
  if (!this->Star.IsFlat || count > LargestRing || !this->FindFeature(feature) ||
    !this->IsSimple() || (mode == Mode::Joining && !this->HasCoincidence()))
  {
    return false;
  }
  if (this->Star.IsOpen && count == 2 &&
    (this->Mesh.Twin(ExtractionMesh::Next(this->Star.Star[0])) == None ||
      this->Mesh.IsFeature(ExtractionMesh::Next(this->Star.Star[0]))))
  {
    return false;
  }
  this->FindJoined();
  const auto joined = [&](Index a, Index b) { return this->Joined[a * count + b] != 0; };
  const auto isNext = [&](Index a, Index b) { return b == (a + 1) % count; };
  bool isPossible = true;
  std::vector<Triangle> triangles;
  if (mode == Mode::Relaxed)
  {
    this->Normal.setZero();
    const Vector3& center = this->Mesh.Position(v);
    for (std::size_t i = 0; i < this->Star.Star.size(); ++i)
    {
      const Vector3 u = this->Mesh.Position(this->Star.Ring[i]) - center;
      this->Normal += u.cross(this->Mesh.Position(this->Star.Ring[(i + 1) % count]) - center);
    }
    this->Normal.normalize();
  }
  const auto range = [&](Index from, Index to)
  {
    std::vector<int> polygon;
    for (Index i = from;; i = (i + 1) % count)
    {
      polygon.push_back(i);
      if (i == to)
      {
        return polygon;
      }
    }
  };
  if (feature[0] == None || this->Star.IsOpen)
  {
    isPossible = !(this->Star.IsOpen && count > 2 && joined(0, count - 1)) &&
      this->Triangulate(range(0, count - 1), mode, triangles);
  }
  else
  {
    const Index a = feature[0];
    const Index b = feature[1];
    if (isNext(a, b) || isNext(b, a))
    {
      const Index first = isNext(a, b) ? a : b;
      isPossible = !this->Mesh.IsFeature(ExtractionMesh::Next(this->Star.Star[first]));
    }
    isPossible = isPossible && !joined(a, b) && this->Triangulate(range(a, b), mode, triangles) &&
      this->Triangulate(range(b, a), mode, triangles);
  }
  for (const Index w : this->Star.Ring)
  {
    this->Stamp[w] = None;
  }
  if (!isPossible || (mode == Mode::Relaxed && !this->KeepsOrientations(triangles)))
  {
    return false;
  }
  std::vector<Index> changed;
  const Index line = feature[0] == None ? 0 : this->Mesh.Feature(this->Star.Star[feature[0]]);
  this->Mesh.RemoveVertex(v, this->Star, triangles, feature, line, changed);
  MakeDelaunay(this->Mesh, changed);
  return true;
}

Index VertexRemoval::RemoveAll(Mode mode)
{
  std::vector<Index> left;
  for (Index v = 0; v < this->Mesh.GetNumberOfVertices(); ++v)
  {
    if (this->Mesh.IsVertex(v) && !this->Mesh.GetRole(v).IsKept)
    {
      left.push_back(v);
    }
  }
  // A vertex that could not be removed is tried again after a change around it.
  std::vector<char> isDue(this->Mesh.GetNumberOfVertices(), 1);
  bool hasChanged = true;
  while (hasChanged)
  {
    hasChanged = false;
    std::size_t count = 0;
    for (const Index v : left)
    {
      if (isDue[v] != 0)
      {
        isDue[v] = 0;
        if (this->Remove(v, mode))
        {
          hasChanged = true;
          for (const Index w : this->Star.Ring)
          {
            isDue[w] = 1;
          }
          continue;
        }
      }
      left[count++] = v;
    }
    left.resize(count);
  }
  return static_cast<Index>(left.size());
}
}
