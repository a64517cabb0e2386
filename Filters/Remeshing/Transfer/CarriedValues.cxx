// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Transfer/CarriedValues.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace DirectionFields
{
namespace
{
/// In squares of a unit.
double AreaOf(const Vector3& a, const Vector3& b, const Vector3& c, double unit)
{
  const Vector3 ab = (b - a) / unit;
  return 0.5 * ab.cross((c - a) / unit).norm();
}

/// In squares of a unit.
std::vector<double> AreasIn(double unit, const RemeshResult& mesh)
{
  std::vector<double> areas;
  areas.reserve(mesh.Faces.size());
  for (const std::array<Index, 4>& face : mesh.Faces)
  {
    const Vector3& first = mesh.Points[face[0]];
    const Vector3& third = mesh.Points[face[2]];
    areas.push_back(AreaOf(first, mesh.Points[face[1]], third, unit) +
      (face[3] == None ? 0.0 : AreaOf(first, third, mesh.Points[face[3]], unit)));
  }
  return areas;
}

/// The first number of a row of several.
std::size_t At(Index row, int components)
{
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(components);
}

/// The integrals of all components, and that of the magnitude, over triangles or faces.
struct Integrals
{
  explicit Integrals(int components)
    : Of(static_cast<std::size_t>(components), 0.0)
  {
  }

  /// Leaves out values that are no numbers.
  void Add(const double* values, double area)
  {
    double square = 0.0;
    for (std::size_t c = 0; c < this->Of.size(); ++c)
    {
      square += values[c] * values[c];
    }
    if (std::isfinite(square))
    {
      for (std::size_t c = 0; c < this->Of.size(); ++c)
      {
        this->Of[c] += area * values[c];
      }
      this->OfMagnitude += area * std::sqrt(square);
      this->Area += area;
    }
  }

  std::vector<double> Of;
  double OfMagnitude = 0.0;
  double Area = 0.0;
};

/// Adds a multiple of the magnitude to the values of some faces, so that they have the integrals.
/// @return the length of the vector of the multiples
double Correct(const Integrals& wanted, const std::vector<Index>& faces,
  const std::vector<double>& areas, std::vector<double>& values)
{
  const auto components = static_cast<int>(wanted.Of.size());
  Integrals there(components);
  for (const Index f : faces)
  {
    there.Add(&values[At(f, components)], areas[f]);
  }
  const bool isZero = !(there.OfMagnitude > 0.0);
  const double total = isZero ? there.Area : there.OfMagnitude;
  if (!(total > 0.0))
  {
    return 0.0;
  }
  double square = 0.0;
  std::vector<double> multiple;
  for (int c = 0; c < components; ++c)
  {
    multiple.push_back((wanted.Of[c] - there.Of[c]) / total);
    square += multiple[c] * multiple[c];
  }
  for (const Index f : faces)
  {
    double* const own = &values[At(f, components)];
    double ownSquare = 0.0;
    for (int c = 0; c < components; ++c)
    {
      ownSquare += own[c] * own[c];
    }
    for (int c = 0; c < components && std::isfinite(ownSquare); ++c)
    {
      own[c] += multiple[c] * (isZero ? 1.0 : std::sqrt(ownSquare));
    }
  }
  return isZero ? 0.0 : std::sqrt(square);
}
}

CarriedValues::CarriedValues(const Surface& surface, const RemeshResult& mesh,
  const std::vector<Index>& regions, const FaceOverlaps& overlaps)
  : Given(surface)
  , Mesh(mesh)
  , Regions(regions)
  , Overlaps(overlaps)
{
}

std::vector<double> CarriedValues::Means(const std::vector<double>& values, int components) const
{
  const std::size_t faces = this->Mesh.Faces.size();
  std::vector<double> means(faces * static_cast<std::size_t>(components));
  for (std::size_t f = 0; f < faces; ++f)
  {
    const std::size_t begin = this->Overlaps.Offsets[f];
    const std::size_t end = this->Overlaps.Offsets[f + 1];
    for (int c = 0; c < components; ++c)
    {
      double sum = 0.0;
      double ofNumbers = 0.0;
      double ofAll = 0.0;
      const double closest = values[At(this->Mesh.FaceSource[f], components) + c];
      double least = std::numeric_limits<double>::infinity();
      double largest = -least;
      for (std::size_t k = begin; k < end; ++k)
      {
        const double value = values[At(this->Overlaps.Triangles[k], components) + c];
        const double area = this->Overlaps.Areas[k];
        ofAll += area;
        if (std::isfinite(value))
        {
          sum += area * value;
          ofNumbers += area;
          least = std::min(least, value);
          largest = std::max(largest, value);
        }
      }
      // Rounding does not take a mean out of its range: that of a constant is the constant.
      means[f * static_cast<std::size_t>(components) + c] =
        ofNumbers > 0.5 * ofAll ? std::clamp(sum / ofNumbers, least, largest) : closest;
    }
  }
  return means;
}

std::vector<double> CarriedValues::Conserved(
  const std::vector<double>& values, int components, double* change) const
{
  std::vector<double> carried = this->Means(values, components);
  const double unit = this->Overlaps.Unit;
  const std::vector<double> areas = AreasIn(unit, this->Mesh);
  const bool hasRegions = !this->Mesh.Regions.empty();
  // Regions without faces leave their share to all others, in a second step.
  std::map<Index, std::pair<Integrals, std::vector<Index>>> parts;
  Integrals whole(components);
  std::vector<Index> all;
  for (std::size_t f = 0; f < areas.size(); ++f)
  {
    all.push_back(static_cast<Index>(f));
    const Index region = hasRegions ? this->Mesh.Regions[f] : 0;
    parts.try_emplace(region, Integrals(components), std::vector<Index>())
      .first->second.second.push_back(all.back());
  }
  for (std::size_t t = 0; t < this->Given.Triangles.size(); ++t)
  {
    const Triangle& corners = this->Given.Triangles[t];
    const double area = AreaOf(this->Given.Points[corners[0]], this->Given.Points[corners[1]],
      this->Given.Points[corners[2]], unit);
    const double* const own = &values[At(static_cast<Index>(t), components)];
    whole.Add(own, area);
    const auto part = parts.find(hasRegions ? this->Regions[t] : 0);
    if (part != parts.end())
    {
      part->second.first.Add(own, area);
    }
  }
  double largest = 0.0;
  for (const auto& [region, part] : parts)
  {
    largest = std::max(largest, Correct(part.first, part.second, areas, carried));
  }
  largest = std::max(largest, Correct(whole, all, areas, carried));
  if (change)
  {
    *change = largest;
  }
  return carried;
}

std::vector<Index> CarriedValues::LargestOverlaps(const std::vector<Index>& classes) const
{
  std::vector<Index> triangles = this->Mesh.FaceSource;
  std::vector<std::pair<Index, std::size_t>> row;
  for (std::size_t f = 0; f < triangles.size(); ++f)
  {
    row.clear();
    for (std::size_t k = this->Overlaps.Offsets[f]; k < this->Overlaps.Offsets[f + 1]; ++k)
    {
      row.emplace_back(classes[this->Overlaps.Triangles[k]], k);
    }
    std::sort(row.begin(), row.end());
    const Index closest = classes[triangles[f]];
    double most = 0.0;
    for (std::size_t begin = 0; begin < row.size();)
    {
      double area = 0.0;
      std::size_t end = begin;
      for (; end < row.size() && row[end].first == row[begin].first; ++end)
      {
        area += this->Overlaps.Areas[row[end].second];
      }
      const bool isClosest = row[begin].first == closest;
      if (area > most || (isClosest && area == most))
      {
        most = area;
        triangles[f] =
          isClosest ? this->Mesh.FaceSource[f] : this->Overlaps.Triangles[row[begin].second];
      }
      begin = end;
    }
  }
  return triangles;
}

std::vector<double> CarriedValues::AreasOf(const RemeshResult& mesh)
{
  return AreasIn(1.0, mesh);
}
}
