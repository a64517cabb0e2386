// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Soup/SortedTriangles.h"

#include "Coordinates.h"
#include "MeshError.h"
#include "Soup/DuplicateTriangles.h"
#include "Support/MortonCurve.h"
#include "Support/RadixSort.h"
#include "Support/Threads.h"

#include <algorithm>
#include <atomic>
#include <string>

namespace DirectionFields::Internal
{
namespace
{
std::string Id(Index id)
{
  return std::to_string(id);
}

/// The number of faults of one kind, and the first of them.
struct Found
{
  Index Count = 0;
  Index First = None;

  void Add(Index id)
  {
    this->First = this->Count == 0 ? id : std::min(this->First, id);
    ++this->Count;
  }
  void operator+=(const Found& other)
  {
    if (other.Count > 0)
    {
      this->First = this->Count == 0 ? other.First : std::min(this->First, other.First);
      this->Count += other.Count;
    }
  }
};

bool IsValid(const Triangle& triangle, Index points)
{
  return std::all_of(triangle.begin(), triangle.end(),
    [points](Index point) { return point >= 0 && point < points; });
}

bool IsCollapsed(const Triangle& t)
{
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Which points the triangles use that are not collapsed. Throws MeshError for invalid ids.
std::vector<std::atomic<char>> UsedPoints(const Surface& surface)
{
  const auto points = static_cast<Index>(surface.Points.size());
  // Several threads may mark a point at once.
  std::vector<std::atomic<char>> used(points);
  const Found invalid =
    ParallelSum(static_cast<Index>(surface.Triangles.size()), LightPiece, Found{},
      [&](Index begin, Index end)
      {
        Found found;
        for (Index t = begin; t < end; ++t)
        {
          const Triangle& triangle = surface.Triangles[t];
          if (!IsValid(triangle, points))
          {
            found.Add(t);
          }
          else if (!IsCollapsed(triangle))
          {
            for (const Index point : triangle)
            {
              used[point].store(1, std::memory_order_relaxed);
            }
          }
        }
        return found;
      });
  if (invalid.Count > 0)
  {
    const Triangle& triangle = surface.Triangles[invalid.First];
    const Index point = *std::find_if(triangle.begin(), triangle.end(),
      [points](Index corner) { return corner < 0 || corner >= points; });
    throw MeshError(MeshError::Kind::InvalidPointId, point,
      "A triangle uses point " + Id(point) + ", but the points are 0 to " + Id(points - 1) +
        ". Correct the connectivity of the mesh.");
  }
  return used;
}

/// The ids of the points that are used. Throws MeshError for coordinates that are not finite or too
/// large.
LargeArray<Index> FinitePoints(const Surface& surface, const std::vector<std::atomic<char>>& used)
{
  LargeArray<Index> members;
  members.reserve(used.size());
  CoordinateCheck check(false);
  for (Index point = 0; point < static_cast<Index>(used.size()); ++point)
  {
    if (used[point].load(std::memory_order_relaxed))
    {
      members.push_back(point);
      const double* const place = surface.Points[point].data();
      if (!check.MayBe(place))
      {
        check.Refuse(static_cast<std::size_t>(point), place);
      }
    }
  }
  const std::string error = check.GetError();
  if (!error.empty())
  {
    throw MeshError(MeshError::Kind::NonFinitePoint, static_cast<Index>(check.GetFirst()), error);
  }
  return members;
}
}

SortedTriangles::SortedTriangles(const Surface& surface)
{
  this->Points = MortonCurve::Sorted(surface.Points, FinitePoints(surface, UsedPoints(surface)));
  LargeArray<Index> vertexOfPoint(surface.Points.size());
  ParallelFor(static_cast<Index>(this->Points.size()), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        vertexOfPoint[this->Points[v]] = v;
      }
    });
  this->Sort(surface, vertexOfPoint);
}

void SortedTriangles::Sort(const Surface& surface, const LargeArray<Index>& vertexOfPoint)
{
  const auto vertices = static_cast<Index>(this->Points.size());
  const auto triangles = static_cast<Index>(surface.Triangles.size());
  LargeArray<Keyed<std::uint32_t>> order(triangles);
  this->Collapsed = ParallelSum<Index>(triangles, LightPiece, 0,
    [&](Index begin, Index end)
    {
      Index collapsed = 0;
      for (Index t = begin; t < end; ++t)
      {
        const Triangle& triangle = surface.Triangles[t];
        const bool ignored = IsCollapsed(triangle);
        collapsed += ignored;
        // Ignored triangles come behind all others.
        order[t] = { static_cast<std::uint32_t>(ignored
                         ? vertices
                         : std::min({ vertexOfPoint[triangle[0]], vertexOfPoint[triangle[1]],
                             vertexOfPoint[triangle[2]] })),
          t };
      }
      return collapsed;
    });
  RadixSort(order, BitsBelow(vertices + 1));
  const Index kept = triangles - this->Collapsed;
  this->Corners.resize(3 * static_cast<std::size_t>(kept));
  this->Input.resize(kept);
  ParallelFor(kept, LightPiece,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        this->Input[t] = order[t].Item;
        for (int c = 0; c < 3; ++c)
        {
          this->Corners[3 * t + c] = vertexOfPoint[surface.Triangles[order[t].Item][c]];
        }
      }
    });
}

Index SortedTriangles::RemoveDuplicates()
{
  const Index triangles = static_cast<Index>(this->Input.size());
  const std::vector<char> duplicate = FindDuplicateTriangles(this->Corners);
  Index kept = 0;
  for (Index t = 0; t < triangles; ++t)
  {
    if (!duplicate[t])
    {
      std::copy_n(this->Corners.begin() + 3 * t, 3, this->Corners.begin() + 3 * kept);
      this->Input[kept++] = this->Input[t];
    }
  }
  this->Corners.resize(3 * kept);
  this->Input.resize(kept);
  return triangles - kept;
}
}
