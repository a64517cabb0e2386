// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Preparation/WantedSizes.h"

#include "Preparation/SurfaceUnit.h"
#include "Refinement/LongEdges.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
bool WantedSizes::AreUneven() const
{
  const auto [least, largest] = std::minmax_element(this->AtPoints.begin(), this->AtPoints.end());
  return least != largest && *largest > *least;
}

std::vector<double> WantedSizes::PerLength() const
{
  std::vector<double> perLength(this->AtVertices.size());
  for (std::size_t v = 0; v < perLength.size(); ++v)
  {
    perLength[v] = 1.0 / (this->MapLength * this->AtVertices[v]);
  }
  return perLength;
}

std::vector<double> WantedSizes::HalfLengths() const
{
  std::vector<double> lengths(this->AtVertices.size());
  for (std::size_t v = 0; v < lengths.size(); ++v)
  {
    lengths[v] = 0.5 * this->EdgeLength * this->AtVertices[v];
  }
  return lengths;
}

void WantedSizes::Shrink(
  const std::vector<double>& longest, const Surface& surface, double area, bool isFixed)
{
  if (longest.empty())
  {
    return;
  }
  // How much longer the other edges may get, and how many times as many faces there may be.
  constexpr double mostLonger = 1.4;
  constexpr double mostFaces = 1.25;
  constexpr double step = 1.08;
  constexpr int steps = 20;
  constexpr int rounds = 10;
  const std::vector<double> before = this->AtPoints;
  double longer = 1.0;
  double looser = 1.0;
  for (int k = 0; k < steps; ++k)
  {
    longer = 1.0;
    double faces = 1.0;
    for (int round = 0; round < (isFixed ? 1 : rounds); ++round)
    {
      for (std::size_t p = 0; p < before.size(); ++p)
      {
        this->AtPoints[p] = std::min(before[p], looser * longest[p] / (longer * this->EdgeLength));
      }
      const double more = RelativeArea(surface, this->AtPoints) / area;
      longer = isFixed ? 1.0 : std::min(mostLonger, std::sqrt(more));
      faces = more / (longer * longer);
    }
    if (isFixed || faces < mostFaces)
    {
      break;
    }
    looser *= step;
  }
  this->IsEven = false;
  this->LengthForArea *= longer;
  this->EdgeLength *= longer;
  this->MapLength *= longer;
}

void WantedSizes::LengthenFor(const SurfaceGeometry& geometry, Index faces)
{
  const double least = LeastEdgeLength(geometry, this->AtVertices, faces);
  // Where a surface has no area, there is no length to multiply.
  const double part = this->MapLength > 0.0 ? this->MapLength / this->EdgeLength : 1.0;
  this->EdgeLength = std::max(this->EdgeLength, least);
  this->MapLength = part * this->EdgeLength;
}

std::vector<double> ClampedSizes(const std::vector<double>& wanted, std::size_t points)
{
  std::vector<double> sizes(points, 1.0);
  for (std::size_t p = 0; p < wanted.size(); ++p)
  {
    const bool isSize = wanted[p] > 0.0 && std::isfinite(wanted[p]);
    sizes[p] = isSize ? std::clamp(wanted[p], 1.0 / LargestSize, LargestSize) : 1.0;
  }
  return sizes;
}

double RelativeArea(const Surface& surface, const std::vector<double>& sizes)
{
  double area = 0.0;
  for (const Triangle& t : surface.Triangles)
  {
    double perLength = 0.0;
    for (const Index p : t)
    {
      if (p < 0 || p >= static_cast<Index>(surface.Points.size()))
      {
        return 0.0;
      }
      perLength += 1.0 / (3.0 * sizes[p]);
    }
    const Vector3 u = surface.Points[t[1]] - surface.Points[t[0]];
    const Vector3 v = surface.Points[t[2]] - surface.Points[t[0]];
    area += 0.5 * u.stableNorm() *
      (v - v.dot(u.stableNormalized()) * u.stableNormalized()).stableNorm() * perLength * perLength;
  }
  return area;
}

WorkingLengths LengthsFor(
  const Surface& surface, const std::vector<double>& sizes, double area, double edgeLength)
{
  constexpr double usualFaces = 5000.0;
  constexpr double mostPerFace = 6.0;
  constexpr double longest = 0.9;
  constexpr double split = 1.4;
  constexpr double mostMiddlesPerFace = 4.0;
  constexpr double fewestAcross = 4.0;
  constexpr double mostPerFaces = 0.03;
  constexpr double fewestNeedless = 64.0;
  // There is no map of more cells than this.
  constexpr double mostCells = 1e8;
  const double squares = area / (edgeLength * edgeLength);
  if (!std::isfinite(squares) || !(squares > 0.0))
  {
    return {};
  }
  const double usual =
    usualFaces * std::pow(4.0, std::round(0.5 * std::log2(squares / usualFaces)));
  const auto times = [&](double factor)
  {
    std::vector<double> lengths(sizes.size());
    for (std::size_t p = 0; p < lengths.size(); ++p)
    {
      lengths[p] = factor * std::sqrt(area / usual) * sizes[p];
    }
    return lengths;
  };
  WorkingLengths lengths;
  lengths.Face = std::sqrt(area / usual);
  lengths.HasNeedles = HasNeedles(surface, lengths.Face);
  if (lengths.HasNeedles ||
    static_cast<double>(sizes.size()) > mostPerFace * std::max(usual, usualFaces))
  {
    lengths.Decimated = times(longest);
  }
  if (squares < mostCells && area > fewestAcross * edgeLength * Extent(surface))
  {
    lengths.Split = times(split);
    lengths.MostMiddles = static_cast<Index>(1000.0 + mostMiddlesPerFace * usual);
  }
  if (squares < mostCells)
  {
    lengths.MostNeedless = static_cast<Index>(std::max(fewestNeedless, mostPerFaces * usual));
  }
  return lengths;
}

double LeastEdgeLength(
  const SurfaceGeometry& geometry, const std::vector<double>& sizes, Index faces)
{
  // A strip has two of its edges on the boundary, a single face four.
  constexpr double mostPerFace = 8.0;
  const TriangleMesh& mesh = geometry.Mesh;
  double length = 0.0;
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = mesh.HalfEdge(e);
    if (mesh.Twin(h) == None)
    {
      const Index tail = mesh.Tail(h);
      const Index head = mesh.Head(h);
      length += 2.0 / (sizes[tail] + sizes[head]) *
        (geometry.Positions[head] - geometry.Positions[tail]).stableNorm();
    }
  }
  return length / (mostPerFace * static_cast<double>(faces));
}
}
