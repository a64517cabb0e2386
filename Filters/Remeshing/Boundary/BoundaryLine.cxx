// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Boundary/BoundaryLine.h"

#include "Mesh/MergePoints.h"
#include "Support/SortedEnds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Places that are closer to a point of the line than this part of an edge are that point.
constexpr double AtPoint = 1e-9;

/// The edges that are there once, at each of their ends. They are put in order by their first ends,
/// of which each has a few: most are there twice, as many as a closed surface has.
std::map<Index, std::vector<Index>> SingleEdges(
  const std::vector<std::array<Index, 2>>& edges, std::size_t points)
{
  std::vector<std::size_t> end(points + 1, 0);
  for (const std::array<Index, 2>& edge : edges)
  {
    ++end[edge[0] + 1];
  }
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Index> seconds(edges.size());
  for (const std::array<Index, 2>& edge : edges)
  {
    seconds[end[edge[0]]++] = edge[1];
  }
  std::map<Index, std::vector<Index>> next;
  for (std::size_t p = 0, k = 0; p < points; ++p)
  {
    const auto last = seconds.begin() + static_cast<std::ptrdiff_t>(end[p]);
    auto at = seconds.begin() + static_cast<std::ptrdiff_t>(k);
    std::sort(at, last);
    while (at != last)
    {
      const Index first = static_cast<Index>(p);
      const Index second = *at;
      const auto same = at;
      at = std::find_if(at, last, [&](Index other) { return other != second; });
      if (at - same == 1 && first != second)
      {
        next[first].push_back(second);
        next[second].push_back(first);
      }
    }
    k = end[p];
  }
  return next;
}

std::vector<ClosestPoints::Corners> SegmentsBetween(const std::vector<Vector3>& corners)
{
  std::vector<ClosestPoints::Corners> segments;
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
  {
    segments.push_back({ corners[k], corners[k + 1], corners[k + 1] });
  }
  return segments;
}

std::vector<Vector3> CornersOf(const Surface& surface, const BoundaryPath& path)
{
  std::vector<Vector3> corners;
  for (const Index p : path.Points)
  {
    corners.push_back(surface.Points[p]);
  }
  if (path.IsClosed)
  {
    corners.push_back(corners.front());
  }
  return corners;
}
}

std::vector<BoundaryPath> BoundaryPathsOf(
  const std::vector<std::array<Index, 2>>& edges, const std::vector<char>& isMarked)
{
  std::map<Index, std::vector<Index>> next = SingleEdges(edges, isMarked.size());
  std::vector<char> isEnd = isMarked;
  for (const auto& [point, others] : next)
  {
    isEnd[point] = isEnd[point] != 0 || others.size() != 2 ? 1 : 0;
  }
  // Takes an edge away, from both of its ends.
  const auto take = [&](Index from, Index to)
  {
    for (const auto& [own, other] : { std::pair(from, to), std::pair(to, from) })
    {
      std::vector<Index>& ends = next[own];
      ends.erase(std::find(ends.begin(), ends.end(), other));
    }
  };
  std::vector<BoundaryPath> paths;
  const auto follow = [&](Index first)
  {
    BoundaryPath path;
    path.Points.push_back(first);
    Index at = first;
    do
    {
      const Index to = next[at].front();
      take(at, to);
      path.Points.push_back(to);
      at = to;
    } while (at != first && isEnd[at] == 0);
    path.IsClosed = at == first && isEnd[at] == 0;
    if (path.IsClosed)
    {
      path.Points.pop_back();
    }
    paths.push_back(std::move(path));
  };
  for (const bool areEnds : { true, false })
  {
    for (const auto& item : next)
    {
      while ((isEnd[item.first] != 0) == areEnds && !item.second.empty())
      {
        follow(item.first);
      }
    }
  }
  return paths;
}

BoundaryLine::BoundaryLine(const Surface& surface, BoundaryPath&& path)
  : Path(std::move(path))
  , Corners(CornersOf(surface, this->Path))
  , Segments(SegmentsBetween(this->Corners))
{
  this->Lengths.push_back(0.0);
  for (std::size_t k = 0; k + 1 < this->Corners.size(); ++k)
  {
    this->Lengths.push_back(
      this->Lengths.back() + (this->Corners[k + 1] - this->Corners[k]).norm());
  }
}

std::size_t BoundaryLine::InLine(Index place) const
{
  const Index edges = this->GetNumberOfEdges();
  return this->IsClosed() ? static_cast<std::size_t>((place % edges + edges) % edges)
                          : static_cast<std::size_t>(std::clamp<Index>(place, 0, edges));
}

Index BoundaryLine::PointAt(Index place) const
{
  return this->Path.Points[this->InLine(place)];
}

Vector3 BoundaryLine::PositionAt(double place) const
{
  const double whole = std::floor(place);
  const auto k = static_cast<Index>(whole);
  const double part = place - whole;
  const Vector3& from = this->PositionAt(k);
  return part == 0.0 ? from : Vector3((1.0 - part) * from + part * this->PositionAt(k + 1));
}

double BoundaryLine::ValueAt(double place, const std::vector<double>& values) const
{
  const double whole = std::floor(place);
  const auto k = static_cast<Index>(whole);
  const double part = place - whole;
  return (1.0 - part) * values[this->PointAt(k)] + part * values[this->PointAt(k + 1)];
}

double BoundaryLine::LengthTo(double place) const
{
  const auto edges = static_cast<double>(this->GetNumberOfEdges());
  const double rounds = this->IsClosed() ? std::floor(place / edges) : 0.0;
  const double own = std::clamp(place - rounds * edges, 0.0, edges);
  const auto k = std::min(static_cast<std::size_t>(own), this->Lengths.size() - 2);
  const double part = own - static_cast<double>(k);
  return rounds * this->Lengths.back() + (1.0 - part) * this->Lengths[k] +
    part * this->Lengths[k + 1];
}

double BoundaryLine::PlaceAt(double length) const
{
  const double all = this->Lengths.back();
  const double rounds = this->IsClosed() && all > 0.0 ? std::floor(length / all) : 0.0;
  const double own = std::clamp(length - rounds * all, 0.0, all);
  const auto above = std::upper_bound(this->Lengths.begin() + 1, this->Lengths.end() - 1, own);
  const auto k = static_cast<std::size_t>(above - this->Lengths.begin()) - 1;
  const double edge = this->Lengths[k + 1] - this->Lengths[k];
  return rounds * static_cast<double>(this->GetNumberOfEdges()) + static_cast<double>(k) +
    (edge > 0.0 ? (own - this->Lengths[k]) / edge : 0.0);
}

double BoundaryLine::Find(const Vector3& position) const
{
  const ClosestPoints::Answer answer = this->Segments.Find(position);
  const double place = static_cast<double>(std::max<Index>(answer.Triangle, 0)) +
    std::clamp(answer.Weights[1] + answer.Weights[2], 0.0, 1.0);
  const double whole = std::round(place);
  return std::abs(place - whole) < AtPoint ? whole : place;
}

std::vector<BoundaryLine> BoundaryLinesOf(const Surface& surface, const std::vector<char>& isUsed)
{
  const std::vector<Index> first = FirstAtSamePlace(surface);
  std::vector<std::array<Index, 2>> edges;
  edges.reserve(3 * surface.Triangles.size());
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Triangle& corners = surface.Triangles[t];
    for (int c = 0; c < 3 && isUsed[t] != 0; ++c)
    {
      const Index a = first[corners[c]];
      const Index b = first[corners[(c + 1) % 3]];
      edges.push_back(SortedEnds(a, b));
    }
  }
  std::vector<BoundaryLine> lines;
  for (BoundaryPath& path : BoundaryPathsOf(edges, std::vector<char>(surface.Points.size(), 0)))
  {
    lines.emplace_back(surface, std::move(path));
  }
  return lines;
}
}
