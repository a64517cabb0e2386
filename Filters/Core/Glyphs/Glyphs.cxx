// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Glyphs/Glyphs.h"

#include "Tracing/SurfacePath.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields
{
namespace
{
/// The share of reading the surface and of sampling in the progress.
constexpr double ProgressRead = 0.3;
constexpr double ProgressSampled = 0.7;
/// Places of a bent arm.
constexpr int ArmStations = 6;
/// A flat glyph is raised above a hollow surface by at most this part of its arms: a wall across it
/// would hide it at any height.
constexpr double MostRaised = 0.5;

/// One glyph after the other.
class Drawing
{
public:
  Drawing(const SurfaceIncidence& surface, int degree, const GlyphOptions& options, Glyphs& glyphs)
    : Surface(surface)
    , Degree(degree)
    , Options(options)
    , Result(glyphs)
    , Shapes(TypeFor(options.Type, degree), degree, glyphs.Mesh)
  {
  }

  /// triangle: of the place; None for a point of the surface.
  void Draw(const DirectionsAt& at, Index triangle, double spacing)
  {
    const auto glyph = static_cast<Index>(this->Result.Point.size());
    const double length = 0.5 * this->Options.Scale * spacing;
    this->Paths.clear();
    for (int k = 0; k < this->Degree; ++k)
    {
      this->Paths.push_back(this->Trace(at, triangle, at.Turned(k, this->Degree), length));
    }
    double height = this->Options.Offset * spacing;
    if (!this->Options.FollowSurface)
    {
      const double raised = this->Straighten(at, length);
      height += this->Options.Offset < 0.0 ? -raised : raised;
    }
    for (int k = 0; k < this->Degree; ++k)
    {
      this->Shapes.Draw(
        glyph, k, SimplifiedPath(this->Paths[k], ArmStations), length, height);
    }
    this->Result.Point.push_back(at.Point);
    this->Result.Magnitude.push_back(at.Magnitude);
    this->Result.Spacing += spacing;
  }

private:
  static GlyphType TypeFor(GlyphType type, int degree)
  {
    if (type != GlyphType::Automatic)
    {
      return type;
    }
    return degree == 1 ? GlyphType::Arrows : GlyphType::Ribbons;
  }

  SurfacePath Trace(
    const DirectionsAt& at, Index triangle, const Vector3& direction, double length) const
  {
    const Index point = triangle == None ? at.Point : None;
    const PathStart start = { at.Position, at.Normal, triangle, point };
    const SurfacePath forward = TracePath(this->Surface, start, direction, length);
    return this->Degree > 1
      ? forward
      : Joined(TracePath(this->Surface, start, -direction, length), forward);
  }

  /// Lays the paths into the tangent plane. Returns how high the surface rises above that.
  double Straighten(const DirectionsAt& at, double length)
  {
    const Vector3 side = this->Options.Offset < 0.0 ? Vector3(-at.Normal) : at.Normal;
    double raised = 0.0;
    for (int k = 0; k < this->Degree; ++k)
    {
      SurfacePath& path = this->Paths[k];
      raised = std::max(raised, HeightAbove(path, at.Position, side));
      const Vector3 direction = at.Turned(k, this->Degree);
      const double begin = path.Stations.front().Distance;
      path.Stations = { { begin, at.Position + begin * direction, at.Normal },
        { length, at.Position + length * direction, at.Normal } };
    }
    return std::min(raised, MostRaised * length);
  }

  const SurfaceIncidence& Surface;
  int Degree;
  const GlyphOptions& Options;
  Glyphs& Result;
  GlyphShapes Shapes;
  std::vector<SurfacePath> Paths;
};

Glyphs AbortedGlyphs()
{
  Glyphs glyphs;
  glyphs.Aborted = true;
  return glyphs;
}
}

Glyphs MakeGlyphs(const Surface& surface, const PointDirections& field,
  const std::vector<char>& excludedTriangles, const std::vector<char>& excludedPoints,
  const GlyphOptions& options, const SamplingProgress& progress)
{
  const SamplingProgress report = progress ? progress : [](double) { return true; };
  const bool allPoints = options.Mode == GlyphMode::AllPoints;
  const SurfaceIncidence incidence(surface);
  if (!report(ProgressRead))
  {
    return AbortedGlyphs();
  }
  const SamplingProgress sampling = [&](double done)
  { return report(ProgressRead + done * (ProgressSampled - ProgressRead)); };
  SamplingOptions samplingOptions;
  samplingOptions.Spacing = options.Spacing;
  samplingOptions.MaximumNumber = options.MaximumNumber;
  const SurfaceSamples samples = allPoints
    ? SamplePoints(incidence, excludedPoints, options.MaximumNumber, sampling)
    : SampleSurface(incidence, excludedTriangles, samplingOptions, sampling);
  if (samples.Aborted)
  {
    return AbortedGlyphs();
  }

  Glyphs glyphs;
  const FieldInterpolation interpolation(incidence, field);
  Drawing drawing(incidence, field.Degree, options, glyphs);
  for (std::size_t i = 0; i < samples.Points.size(); ++i)
  {
    const SurfacePoint& place = samples.Points[i];
    if (i % 1024 == 0 &&
      !report(ProgressSampled + (1.0 - ProgressSampled) * i / samples.Points.size()))
    {
      return AbortedGlyphs();
    }
    DirectionsAt at;
    double spacing = samples.Spacing;
    if (allPoints)
    {
      const auto corner = std::max_element(place.Weights.begin(), place.Weights.end());
      const Index point = surface.Triangles[place.Triangle][corner - place.Weights.begin()];
      at = interpolation.AtPoint(point);
      spacing = spacing > 0.0 ? spacing : incidence.ShortestEdge(point);
    }
    else
    {
      at = interpolation.At(place);
    }
    if (at.Magnitude > 0.0)
    {
      drawing.Draw(at, allPoints ? None : place.Triangle, spacing);
    }
  }
  if (!glyphs.Point.empty())
  {
    glyphs.Spacing = samples.Spacing > 0.0
      ? samples.Spacing
      : glyphs.Spacing / static_cast<double>(glyphs.Point.size());
  }
  return glyphs;
}
}
