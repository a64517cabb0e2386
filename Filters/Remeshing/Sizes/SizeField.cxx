// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Sizes/SizeField.h"

#include "Mesh/MergePoints.h"
#include "Preparation/WantedSizes.h"
#include "Support/Sentences.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <queue>
#include <stdexcept>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// How often sizes are limited for an edge length that depends on them.
constexpr int GradationRounds = 4;

/// The edges that leave each point, as pairs of a length and a point, and where those of a point
/// begin.
struct Edges
{
  Edges(const Surface& surface, const std::vector<Index>& place)
    : Begin(surface.Points.size() + 1, 0)
  {
    const auto points = static_cast<Index>(surface.Points.size());
    const auto forEach = [&](const auto& take)
    {
      for (const Triangle& t : surface.Triangles)
      {
        for (int c = 0; c < 3; ++c)
        {
          const Index a = t[c];
          const Index b = t[(c + 1) % 3];
          if (a >= 0 && b >= 0 && a < points && b < points)
          {
            take(place[a], place[b]);
            take(place[b], place[a]);
          }
        }
      }
    };
    forEach([&](Index from, Index) { ++this->Begin[from + 1]; });
    std::partial_sum(this->Begin.begin(), this->Begin.end(), this->Begin.begin());
    this->Ends.resize(this->Begin.back());
    std::vector<std::size_t> next = this->Begin;
    forEach(
      [&](Index from, Index to) {
        this->Ends[next[from]++] = { (surface.Points[to] - surface.Points[from]).norm(), to };
      });
  }

  std::vector<std::size_t> Begin;
  std::vector<std::pair<double, Index>> Ends;
};

[[noreturn]] void RefuseLength(double length, std::size_t point)
{
  throw std::invalid_argument("The wanted length of edges at point " + std::to_string(point) +
    " is " + (std::isnan(length) ? std::string("no number") : Figure(length)) +
    ". All lengths of the Sizing Array have to be finite and above 0.");
}
}

RelativeSizes SizesFor(
  const Surface& surface, const std::vector<double>& lengths, double unit, const std::string& name)
{
  RelativeSizes result;
  result.Sizes = lengths;
  std::vector<double>& sizes = result.Sizes;
  for (std::size_t p = 0; p < sizes.size(); ++p)
  {
    if (!(sizes[p] > 0.0) || !std::isfinite(sizes[p]))
    {
      RefuseLength(sizes[p], p);
    }
    sizes[p] /= unit;
  }
  if (sizes.empty())
  {
    return result;
  }
  const double least = *std::min_element(sizes.begin(), sizes.end());
  const double largest = *std::max_element(sizes.begin(), sizes.end());
  // As many faces of even size cover the surface.
  const double area = RelativeArea(surface, std::vector<double>(sizes.size(), 1.0));
  const double even = std::sqrt(area / RelativeArea(surface, sizes));
  const double typical = std::isfinite(even) && even > 0.0 ? even : least;
  const double low = largest / LargestSize;
  const double high = least * LargestSize;
  result.EdgeLength = low <= high ? std::clamp(typical, low, high) : typical;
  for (double& size : sizes)
  {
    size /= result.EdgeLength;
  }
  const auto outside = static_cast<std::size_t>(std::count_if(sizes.begin(), sizes.end(),
    [&](double size) { return low > high && (size > LargestSize || size < 1.0 / LargestSize); }));
  if (outside > 0)
  {
    const double inUnit = unit * result.EdgeLength;
    result.Notes.push_back(name + " are from " + Figure(unit * least) + " to " +
      Figure(unit * largest) + ", but edges of one mesh from " + Figure(inUnit / LargestSize) +
      " to " + Figure(inUnit * LargestSize) + " only: " + Count(outside, "point") +
      " cannot have the wanted length.");
  }
  return result;
}

void LimitGrowth(const Surface& surface, double slope, std::vector<double>& sizes)
{
  const std::vector<Index> place = FirstAtSamePlace(surface);
  const Edges edges(surface, place);
  for (std::size_t p = 0; p < sizes.size(); ++p)
  {
    sizes[place[p]] = std::min(sizes[place[p]], sizes[p]);
  }
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::size_t p = 0; p < sizes.size(); ++p)
  {
    if (place[p] == static_cast<Index>(p))
    {
      queue.emplace(sizes[p], static_cast<Index>(p));
    }
  }
  while (!queue.empty())
  {
    const auto [size, p] = queue.top();
    queue.pop();
    if (size > sizes[p])
    {
      continue;
    }
    for (std::size_t k = edges.Begin[p]; k < edges.Begin[p + 1]; ++k)
    {
      const auto& [length, q] = edges.Ends[k];
      const double most = size + slope * length;
      if (most < sizes[q])
      {
        sizes[q] = most;
        queue.emplace(most, q);
      }
    }
  }
  for (std::size_t p = 0; p < sizes.size(); ++p)
  {
    sizes[p] = sizes[place[p]];
  }
}

void LimitGradation(const Surface& surface, double gradation,
  const std::function<double(double)>& edgeLengthFor, std::vector<double>& sizes)
{
  const std::vector<double> wanted = sizes;
  double before = 0.0;
  // The length may depend on the sizes.
  for (int round = 0; round < GradationRounds; ++round)
  {
    const double length = edgeLengthFor(RelativeArea(surface, sizes));
    if (length == before)
    {
      break;
    }
    before = length;
    sizes = wanted;
    if (length > 0.0 && std::isfinite(length))
    {
      LimitGrowth(surface, std::log(gradation) / length, sizes);
    }
  }
}
}
