// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Glyphs/Glyphs.h"

#include "Tracing/SurfacePath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace DirectionFields::Internal
{
namespace
{
/// The share of reading the surface and of sampling in the progress.
constexpr double ProgressRead = 0.3;
constexpr double ProgressSampled = 0.7;
constexpr std::size_t GlyphsPerReport = 1024;
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

  /// @param triangle of the place; None for a point of the surface
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
      this->Result.Direction.push_back(at.Turned(k, this->Degree));
      this->Shapes.Draw(glyph, k, SimplifiedPath(this->Paths[k], ArmStations), length, height);
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
    return this->Degree > 1 ? forward
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

SurfaceSamples Places(const SurfaceIncidence& surface, const std::vector<char>& excludedTriangles,
  const std::vector<char>& excludedPoints, const GlyphOptions& options, const Progress& progress)
{
  if (options.Mode == GlyphMode::AllPoints)
  {
    return SamplePoints(surface, excludedPoints, options.MaximumNumber, progress);
  }
  SamplingOptions sampling;
  sampling.Spacing = options.Spacing;
  sampling.MaximumNumber = options.MaximumNumber;
  return SampleSurface(surface, excludedTriangles, sampling, progress);
}

/// The point of the surface that a place is.
Index PointAt(const Surface& surface, const SurfacePoint& place)
{
  const auto corner = std::max_element(place.Weights.begin(), place.Weights.end());
  return surface.Triangles[place.Triangle][corner - place.Weights.begin()];
}

/// Throws Stopped.
Glyphs Draw(const SurfaceIncidence& surface, const PointDirections& field,
  const SurfaceSamples& samples, const GlyphOptions& options, const Progress& progress)
{
  const bool allPoints = options.Mode == GlyphMode::AllPoints;
  Glyphs glyphs;
  glyphs.Degree = field.Degree;
  const FieldInterpolation interpolation(surface, field);
  Drawing drawing(surface, field.Degree, options, glyphs);
  for (std::size_t i = 0; i < samples.Points.size(); ++i)
  {
    if (i % GlyphsPerReport == 0)
    {
      progress.Report(static_cast<double>(i) / samples.Points.size());
    }
    const SurfacePoint& place = samples.Points[i];
    DirectionsAt at;
    double spacing = samples.Spacing;
    if (allPoints)
    {
      const Index point = PointAt(surface.GetSurface(), place);
      at = interpolation.AtPoint(point);
      spacing = spacing > 0.0 ? spacing : surface.ShortestEdge(point);
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

/// Throws std::invalid_argument with a sentence for the user; NaN is in no range.
void Check(const GlyphOptions& options)
{
  const auto require = [](bool condition, const char* message)
  {
    if (!condition)
    {
      throw std::invalid_argument(message);
    }
  };
  require(options.Spacing >= 0.0, "Spacing must be 0 or more.");
  require(options.MaximumNumber >= 1 && options.MaximumNumber <= 1000000,
    "MaximumNumberOfGlyphs must be 1 to 1000000.");
  require(options.Scale >= 0.01 && options.Scale <= 10.0, "Scale must be 0.01 to 10.");
  require(options.Offset >= -1.0 && options.Offset <= 1.0, "Offset must be -1 to 1.");
}

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

/// A number times a power of two, but finite.
double Times(double number, int exponent)
{
  constexpr double most = std::numeric_limits<double>::max();
  return std::isfinite(number) ? std::clamp(std::ldexp(number, exponent), -most, most) : number;
}

void Multiply(std::vector<Vector3>& points, int exponent)
{
  for (Vector3& point : points)
  {
    point = point.unaryExpr([exponent](double number) { return Times(number, exponent); });
  }
}

Glyphs MakeGlyphsOf(const SurfaceIncidence& surface, const PointDirections& field,
  const std::vector<char>& excludedTriangles, const std::vector<char>& excludedPoints,
  const GlyphOptions& options, const Progress& progress)
{
  progress.Report(ProgressRead);
  const SurfaceSamples samples = Places(surface, excludedTriangles, excludedPoints, options,
    progress.Part(ProgressRead, ProgressSampled));
  return Draw(surface, field, samples, options, progress.Part(ProgressSampled, 1.0));
}
}

Glyphs MakeGlyphs(const Surface& surface, const PointDirections& field,
  const std::vector<char>& excludedTriangles, const std::vector<char>& excludedPoints,
  const GlyphOptions& options, const ProgressFunction& progress)
{
  Check(options);
  const Progress steps(progress);
  try
  {
    const SurfaceIncidence incidence(surface);
    if (incidence.HasUsualSize())
    {
      return MakeGlyphsOf(incidence, field, excludedTriangles, excludedPoints, options, steps);
    }
    // In another unit of length, a power of two, which rounds nothing.
    const int exponent = ExponentOf(surface);
    Surface scaled = surface;
    Multiply(scaled.Points, -exponent);
    GlyphOptions scaledOptions = options;
    scaledOptions.Spacing = Times(options.Spacing, -exponent);
    Glyphs glyphs = MakeGlyphsOf(
      SurfaceIncidence(scaled), field, excludedTriangles, excludedPoints, scaledOptions, steps);
    Multiply(glyphs.Mesh.Points, exponent);
    glyphs.Spacing = Times(glyphs.Spacing, exponent);
    return glyphs;
  }
  catch (const Stopped&)
  {
    Glyphs nothing;
    nothing.Aborted = true;
    return nothing;
  }
}
}
