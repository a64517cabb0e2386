// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Boundary/BoundaryMatch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace DirectionFields::Internal
{
namespace
{
/// How many points beyond its neighbours' places a vertex may move.
constexpr double Reach = 16.0;
/// The price of a vertex without a point, or of a point without a vertex. The two together cost
/// more than any distance.
constexpr double PerUnmatched = 2.0;
constexpr double MostForDistance = 3.0;
constexpr double Never = std::numeric_limits<double>::infinity();

/// How the best way came to a vertex and a point: from one vertex and one point less, from one
/// vertex less, or from one point less.
enum class Step : char
{
  Both,
  Vertex,
  Point
};

/// The best ways for the first vertices of a side and the points up to some places.
struct Row
{
  Index First = 0;
  std::vector<double> Cost;
  std::vector<Step> From;

  double At(Index place) const
  {
    const Index k = place - this->First;
    return k < 0 || k >= static_cast<Index>(this->Cost.size()) ? Never : this->Cost[k];
  }
};

double PriceOf(const BoundaryLine& line, double place, Index point)
{
  const auto at = static_cast<double>(point);
  const double edges = 0.5 * (line.LengthTo(at + 1.0) - line.LengthTo(at - 1.0));
  const double way = line.LengthTo(place) - line.LengthTo(at);
  const double price = edges > 0.0 ? way * way / (edges * edges) : MostForDistance;
  return std::min(price, MostForDistance);
}

/// The places up to which the ways of a vertex go.
std::vector<std::array<Index, 2>> RangesOf(const BoundarySide& side, Index begin, Index end)
{
  const std::size_t count = side.Places.size();
  std::vector<double> highest = side.Places;
  std::vector<double> lowest = side.Places;
  for (std::size_t j = 1; j < count; ++j)
  {
    highest[j] = std::max(highest[j], highest[j - 1]);
    lowest[count - 1 - j] = std::min(lowest[count - 1 - j], lowest[count - j]);
  }
  std::vector<std::array<Index, 2>> ranges;
  for (std::size_t j = 0; j < count; ++j)
  {
    const double low = std::floor(lowest[j == 0 ? 0 : j - 1] - Reach);
    const double high = std::ceil(highest[std::min(j + 1, count - 1)] + Reach);
    ranges.push_back(
      { std::max(begin, static_cast<Index>(low)), std::min(end, static_cast<Index>(high)) });
  }
  ranges.front()[0] = begin;
  ranges.back()[1] = end;
  return ranges;
}
}

std::vector<Index> MatchBoundary(
  const BoundarySide& side, const BoundaryLine& line, const std::vector<char>& stays)
{
  const std::size_t count = side.Vertices.size();
  const auto begin = static_cast<Index>(std::lround(side.Places.front()));
  const Index end = begin + line.GetNumberOfEdges();
  const std::vector<std::array<Index, 2>> ranges = RangesOf(side, begin, end);
  std::vector<Row> rows(count);
  for (std::size_t j = 0; j < count; ++j)
  {
    Row& row = rows[j];
    row.First = ranges[j][0];
    const auto size = static_cast<std::size_t>(ranges[j][1] - ranges[j][0] + 1);
    row.Cost.assign(size, Never);
    row.From.assign(size, Step::Both);
    const bool isFixed = j == 0 || j + 1 == count || stays[j] != 0;
    const Index own = j == 0 ? begin
      : j + 1 == count       ? end
                             : static_cast<Index>(std::lround(side.Places[j]));
    for (Index i = ranges[j][0]; i <= ranges[j][1]; ++i)
    {
      const Index k = i - row.First;
      const auto take = [&](double cost, Step from)
      {
        if (cost < row.Cost[k])
        {
          row.Cost[k] = cost;
          row.From[k] = from;
        }
      };
      if (!isFixed || i == own)
      {
        const double price = isFixed ? 0.0 : PriceOf(line, side.Places[j], i);
        take(j == 0 ? 0.0 : rows[j - 1].At(i - 1) + price, Step::Both);
      }
      if (!isFixed)
      {
        take(rows[j - 1].At(i) + PerUnmatched, Step::Vertex);
      }
      take(row.At(i - 1) + PerUnmatched, Step::Point);
    }
  }
  std::vector<Index> match(count, None);
  Index i = end;
  for (auto j = static_cast<std::ptrdiff_t>(count) - 1; j >= 0;)
  {
    const Row& row = rows[j];
    if (row.At(i) == Never)
    {
      // Vertices that stay contradict each other.
      return {};
    }
    const Step from = row.From[i - row.First];
    if (from == Step::Both)
    {
      match[j] = i;
    }
    i -= from == Step::Vertex ? 0 : 1;
    j -= from == Step::Point ? 0 : 1;
  }
  return match;
}
}
