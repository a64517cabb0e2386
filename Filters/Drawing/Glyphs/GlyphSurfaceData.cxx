// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Glyphs/GlyphSurfaceData.h"

#include "Glyphs/OutwardSides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// The exponent of the power of two above all coordinates of finite points that triangles use.
int ExponentOf(const Surface& surface)
{
  const auto points = static_cast<Index>(surface.Points.size());
  double largest = 0.0;
  for (const Triangle& triangle : surface.Triangles)
  {
    for (const Index i : triangle)
    {
      if (i >= 0 && i < points && surface.Points[i].allFinite())
      {
        largest = std::max(largest, surface.Points[i].lpNorm<Eigen::Infinity>());
      }
    }
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return exponent;
}

/// The greatest number of glyphs, with 0 resolved.
Index MaximumNumberOf(const GlyphOptions& options)
{
  constexpr Index distinct = 500;
  constexpr Index most = 2000;
  if (options.MaximumNumber > 0)
  {
    return options.MaximumNumber;
  }
  return options.Mode == GlyphMode::SpreadEvenly && options.Spacing == 0.0 ? distinct : most;
}
}

double TimesPower(double number, int exponent)
{
  constexpr double most = std::numeric_limits<double>::max();
  return std::isfinite(number) ? std::clamp(std::ldexp(number, exponent), -most, most) : number;
}

GlyphSurfaceData::GlyphSurfaceData(std::shared_ptr<const Surface> surface,
  std::vector<char> excludedTriangles, std::vector<char> excludedPoints)
  : Triangles(std::move(surface))
  , ExcludedTriangles(std::move(excludedTriangles))
  , ExcludedPoints(std::move(excludedPoints))
{
  this->Incidence.emplace(*this->Triangles);
  if (!this->Incidence->HasUsualSize())
  {
    // In another unit of length, a power of two, which rounds nothing.
    this->Exponent = ExponentOf(*this->Triangles);
    auto scaled = std::make_shared<Surface>(*this->Triangles);
    for (Vector3& point : scaled->Points)
    {
      point = point.unaryExpr([this](double x) { return TimesPower(x, -this->Exponent); });
    }
    this->Triangles = std::move(scaled);
    this->Incidence.emplace(*this->Triangles);
  }
}

const SurfaceSamples& GlyphSurfaceData::GetPlaces(
  const GlyphOptions& options, const Progress& progress)
{
  const Index maximumNumber = MaximumNumberOf(options);
  const Key key = { options.Mode, options.Spacing, maximumNumber };
  if (this->PlacesKey == key)
  {
    return this->Places;
  }
  ++this->NumberOfSamplings;
  if (options.Mode == GlyphMode::AllPoints)
  {
    this->Places = SamplePoints(*this->Incidence, this->ExcludedPoints, maximumNumber, progress);
  }
  else
  {
    SamplingOptions sampling;
    sampling.Spacing = TimesPower(options.Spacing, -this->Exponent);
    sampling.MaximumNumber = maximumNumber;
    this->Places = SampleSurface(*this->Incidence, this->ExcludedTriangles, sampling, progress);
  }
  this->PlacesKey = key;
  return this->Places;
}

const std::shared_ptr<const FieldSurface>& GlyphSurfaceData::GetFieldSurface()
{
  if (!this->FieldMesh)
  {
    this->FieldMesh = std::make_shared<const FieldSurface>(*this->Triangles);
  }
  return this->FieldMesh;
}

const std::vector<signed char>& GlyphSurfaceData::GetOutwardSides()
{
  if (!this->Sides)
  {
    this->Sides = OutwardSides(*this->Triangles);
  }
  return *this->Sides;
}
}
