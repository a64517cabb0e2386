// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Sizes/BoundarySizes.h"

#include "Mesh/MergePoints.h"
#include "Preparation/WantedSizes.h"
#include "Sizes/SizeField.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace DirectionFields::Internal
{
namespace
{
/// Lengths of the boundary's edges within this factor of the wanted one are left to smoothing.
constexpr double Tolerance = 1.25;
/// By how much lengths of edges beside each other differ at most on the way to the wanted one: the
/// logarithm of a gradation of 1.3.
constexpr double Slope = 0.26;

/// The mean length of the edges at each point of the boundary, over two edges on either side; 0 at
/// others.
std::vector<double> BoundaryLengths(const Surface& surface, const std::vector<BoundaryLine>& lines)
{
  constexpr Index reach = 2;
  std::vector<double> lengths(surface.Points.size(), 0.0);
  for (const BoundaryLine& line : lines)
  {
    const Index edges = line.GetNumberOfEdges();
    for (Index k = 0; k < static_cast<Index>(line.GetPoints().size()); ++k)
    {
      const Index first = line.IsClosed() ? k - reach : std::max<Index>(0, k - reach);
      const Index last = line.IsClosed() ? k + reach : std::min(edges, k + reach);
      double sum = 0.0;
      for (Index e = first; e < last; ++e)
      {
        sum += (line.PositionAt(e + 1) - line.PositionAt(e)).norm();
      }
      lengths[line.PointAt(k)] = sum / static_cast<double>(last - first);
    }
  }
  return lengths;
}
}

std::vector<double> LengthsFromBoundary(const Surface& surface,
  const std::vector<BoundaryLine>& lines, std::vector<double> wanted, double slope)
{
  const std::vector<double> own = BoundaryLengths(surface, lines);
  const double largest = std::max(
    *std::max_element(own.begin(), own.end()), *std::max_element(wanted.begin(), wanted.end()));
  // The longest and, with the other sign, the shortest lengths that growth from the boundary
  // allows.
  std::vector<double> most(own.size(), std::numeric_limits<double>::max());
  std::vector<double> least(own.size(), 2.0 * largest);
  for (std::size_t p = 0; p < own.size(); ++p)
  {
    if (own[p] > 0.0)
    {
      most[p] = own[p];
      least[p] = 2.0 * largest - own[p];
    }
  }
  LimitGrowth(surface, slope, most);
  LimitGrowth(surface, slope, least);
  for (std::size_t p = 0; p < own.size(); ++p)
  {
    wanted[p] = std::min(most[p], std::max(wanted[p], 2.0 * largest - least[p]));
  }
  return wanted;
}

std::vector<double> LengthsForBoundary(
  const Surface& surface, const std::vector<double>& sizes, double edgeLength, bool isFixed)
{
  constexpr int rounds = 12;
  constexpr double mostLonger = 4.0;
  const std::vector<BoundaryLine> lines =
    BoundaryLinesOf(surface, std::vector<char>(surface.Triangles.size(), 1));
  const std::vector<double> own = BoundaryLengths(surface, lines);
  bool isAsWanted = true;
  for (std::size_t p = 0; p < own.size(); ++p)
  {
    const double ratio = own[p] / (edgeLength * sizes[p]);
    isAsWanted = isAsWanted && (own[p] == 0.0 || (ratio < Tolerance && ratio > 1.0 / Tolerance));
  }
  if (isAsWanted || !(edgeLength > 0.0) || !std::isfinite(edgeLength))
  {
    return {};
  }
  const double faces = RelativeArea(surface, sizes) / (edgeLength * edgeLength);
  std::vector<double> lengths;
  double factor = 1.0;
  for (int round = 0; round < (isFixed ? 1 : rounds); ++round)
  {
    std::vector<double> wanted = sizes;
    for (double& length : wanted)
    {
      length *= factor * edgeLength;
    }
    lengths = LengthsFromBoundary(surface, lines, std::move(wanted), Slope);
    factor = std::clamp(
      factor * std::sqrt(RelativeArea(surface, lengths) / faces), 1.0 / mostLonger, mostLonger);
  }
  return lengths;
}
}
