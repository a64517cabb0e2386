// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Glyphs.h"
#include "Glyphs/GlyphShapes.h"
#include "Glyphs/GlyphSurfaceData.h"
#include "Interpolation/FieldInterpolation.h"
#include "Paths/SurfacePath.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <utility>

namespace DirectionFields
{
namespace
{
/// The share of sampling in the progress.
constexpr double ProgressSampled = 0.7;
/// How many places a thread takes at a time, and how many of such pieces there are between reports.
constexpr Index PlacesPerPiece = 32;
constexpr Index PiecesPerReport = 16;
/// Places of a bent arm.
constexpr int ArmStations = 6;
/// A flat glyph is raised above a hollow surface by at most this part of its arms: a wall across it
/// would hide it at any height.
constexpr double MostRaised = 0.5;

/// On which sides of a place there are arms.
struct Sides
{
  bool Front;
  bool Back;
};

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
    glyphs.Degree = degree;
  }

  /// @param triangle of the place; None for a point of the surface
  void Draw(const DirectionsAt& at, Index triangle, double spacing, const Sides& sides)
  {
    const double length = 0.5 * this->Options.Scale * spacing;
    this->Paths.clear();
    for (int k = 0; k < this->Degree; ++k)
    {
      const Vector3 direction = at.Turned(k, this->Degree);
      this->Result.Direction.push_back(direction);
      this->Paths.push_back(this->Trace(at, triangle, direction, length));
    }
    if (sides.Front)
    {
      this->DrawSide(at, 1.0, length, spacing);
    }
    if (sides.Back)
    {
      this->DrawSide(at, -1.0, length, spacing);
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

  /// Draws the arms on the side that the normal points to, or on the other one.
  /// @param side 1 or -1
  void DrawSide(const DirectionsAt& at, double side, double length, double spacing)
  {
    const auto glyph = static_cast<Index>(this->Result.Point.size());
    double height = this->Options.Offset * spacing;
    if (!this->Options.FollowSurface)
    {
      const double up = this->Options.Offset < 0.0 ? -1.0 : 1.0;
      height += up * this->Raised(at, side * up, length);
    }
    for (int k = 0; k < this->Degree; ++k)
    {
      SurfacePath arm = this->Options.FollowSurface ? SimplifiedPath(this->Paths[k], ArmStations)
                                                    : this->Straight(at, k, length);
      if (side < 0.0)
      {
        for (SurfacePath::Station& station : arm.Stations)
        {
          station.Normal = -station.Normal;
        }
      }
      this->Shapes.Draw(glyph, k, arm, length, height);
    }
  }

  /// An arm in the tangent plane.
  SurfacePath Straight(const DirectionsAt& at, int k, double length) const
  {
    const Vector3 direction = at.Turned(k, this->Degree);
    const double begin = this->Paths[k].Stations.front().Distance;
    return { { { begin, at.Position + begin * direction, at.Normal },
      { length, at.Position + length * direction, at.Normal } } };
  }

  /// How high the surface rises above the tangent plane on a side, along the arms.
  double Raised(const DirectionsAt& at, double side, double length) const
  {
    double raised = 0.0;
    for (const SurfacePath& path : this->Paths)
    {
      raised = std::max(raised, HeightAbove(path, at.Position, side * at.Normal));
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

/// The point of the surface that a place is.
Index PointAt(const Surface& surface, const SurfacePoint& place)
{
  const auto corner = std::max_element(place.Weights.begin(), place.Weights.end());
  return surface.Triangles[place.Triangle][corner - place.Weights.begin()];
}

/// The surface, the places on it and the field there, from which glyphs are drawn.
class GlyphPlaces
{
public:
  GlyphPlaces(GlyphSurfaceData& surface, const SurfaceSamples& samples,
    const PointDirections& field, const GlyphOptions& options)
    : Surface(surface.GetIncidence())
    , Samples(samples)
    , Options(options)
    , Given(this->Surface.GetSurface(), surface.GetFieldSurface(), field)
    , Interpolation(this->Surface, this->Given, field)
    , Degree(field.Degree)
  {
    if (options.Side == GlyphSide::Automatic)
    {
      this->Outward = &surface.GetOutwardSides();
    }
  }

  Index GetNumber() const { return static_cast<Index>(this->Samples.Points.size()); }

  /// The glyphs of the places begin ... end - 1.
  Glyphs Draw(Index begin, Index end) const
  {
    Glyphs glyphs;
    Drawing drawing(this->Surface, this->Degree, this->Options, glyphs);
    for (Index i = begin; i < end; ++i)
    {
      const SurfacePoint& place = this->Samples.Points[i];
      DirectionsAt at;
      double spacing = this->Samples.Spacing;
      const bool onPoint = this->Options.Mode == GlyphMode::AllPoints;
      if (onPoint)
      {
        const Index point = PointAt(this->Surface.GetSurface(), place);
        at = this->Interpolation.AtPoint(point);
        spacing = spacing > 0.0 ? spacing : this->Surface.ShortestEdge(point);
      }
      else
      {
        at = this->Interpolation.At(place);
      }
      if (at.Magnitude > 0.0)
      {
        drawing.Draw(at, onPoint ? None : place.Triangle, spacing, this->SidesOf(at, place));
      }
    }
    return glyphs;
  }

private:
  Sides SidesOf(const DirectionsAt& at, const SurfacePoint& place) const
  {
    if (!this->Outward)
    {
      return { this->Options.Side != GlyphSide::Back, this->Options.Side != GlyphSide::Front };
    }
    const signed char side = (*this->Outward)[place.Triangle];
    if (side == 0)
    {
      return { true, true };
    }
    Vector3 outward = side * this->Surface.Normal(place.Triangle);
    if (this->Options.Mode == GlyphMode::AllPoints)
    {
      // A single triangle may stand on edge beside the normal of its point.
      outward.setZero();
      const Index* const end = this->Surface.EndTriangles(at.Point);
      for (const Index* t = this->Surface.BeginTriangles(at.Point); t != end; ++t)
      {
        outward += (*this->Outward)[*t] * this->Surface.Area(*t) * this->Surface.Normal(*t);
      }
    }
    const bool front = outward.dot(at.Normal) >= 0.0;
    return { front, !front };
  }

  const SurfaceIncidence& Surface;
  const SurfaceSamples& Samples;
  const GlyphOptions& Options;
  GivenField Given;
  FieldInterpolation Interpolation;
  int Degree;
  /// Null where the outside does not matter.
  const std::vector<signed char>* Outward = nullptr;
};

/// The sizes of the arrays of glyphs.
struct Sizes
{
  std::size_t Places = 0;
  std::size_t Points = 0;
  std::size_t Cells = 0;
  std::size_t Corners = 0;

  void Add(const Glyphs& glyphs)
  {
    this->Places += glyphs.Point.size();
    this->Points += glyphs.Mesh.Points.size();
    this->Cells += glyphs.Mesh.Glyph.size();
    this->Corners += glyphs.Mesh.Connectivity.size();
  }
};

/// Makes room for glyphs.
void Resize(const Sizes& sizes, Glyphs& glyphs)
{
  glyphs.Point.resize(sizes.Places);
  glyphs.Magnitude.resize(sizes.Places);
  glyphs.Direction.resize(sizes.Places * glyphs.Degree);
  glyphs.Mesh.Points.resize(sizes.Points);
  glyphs.Mesh.Normals.resize(sizes.Points);
  glyphs.Mesh.Glyph.resize(sizes.Cells);
  glyphs.Mesh.Branch.resize(sizes.Cells);
  glyphs.Mesh.Offsets.resize(sizes.Cells + 1);
  glyphs.Mesh.Connectivity.resize(sizes.Corners);
}

/// Copies some of the glyphs to where they begin; they get the numbers that follow those before.
void Place(const Glyphs& part, const Sizes& begin, Glyphs& all)
{
  const auto copy = [](const auto& from, std::size_t first, auto& to)
  { std::copy(from.begin(), from.end(), to.begin() + static_cast<std::ptrdiff_t>(first)); };
  copy(part.Point, begin.Places, all.Point);
  copy(part.Magnitude, begin.Places, all.Magnitude);
  copy(part.Direction, begin.Places * all.Degree, all.Direction);
  copy(part.Mesh.Points, begin.Points, all.Mesh.Points);
  copy(part.Mesh.Normals, begin.Points, all.Mesh.Normals);
  copy(part.Mesh.Branch, begin.Cells, all.Mesh.Branch);
  for (std::size_t i = 0; i < part.Mesh.Glyph.size(); ++i)
  {
    all.Mesh.Glyph[begin.Cells + i] = static_cast<Index>(begin.Places) + part.Mesh.Glyph[i];
    all.Mesh.Offsets[begin.Cells + i + 1] =
      static_cast<std::int64_t>(begin.Corners) + part.Mesh.Offsets[i + 1];
  }
  for (std::size_t i = 0; i < part.Mesh.Connectivity.size(); ++i)
  {
    all.Mesh.Connectivity[begin.Corners + i] =
      static_cast<std::int64_t>(begin.Points) + part.Mesh.Connectivity[i];
  }
}

/// The glyphs of all parts, which are emptied, one behind the other.
/// @param glyphs without glyphs, for the degree and the kind of cells
Glyphs Joined(std::vector<Glyphs>& parts, Glyphs glyphs)
{
  std::vector<Sizes> begins;
  Sizes sizes;
  for (const Glyphs& part : parts)
  {
    begins.push_back(sizes);
    sizes.Add(part);
    glyphs.Spacing += part.Spacing;
  }
  Resize(sizes, glyphs);
  ParallelFor(static_cast<Index>(parts.size()), 1,
    [&](Index begin, Index end)
    {
      for (Index p = begin; p < end; ++p)
      {
        Place(parts[p], begins[p], glyphs);
        parts[p] = {};
      }
    });
  return glyphs;
}

/// Draws all places, on the threads of the computation. Throws Stopped.
Glyphs DrawAll(const GlyphPlaces& places, const Progress& progress)
{
  const Index pieces = NumberOfPieces(places.GetNumber(), PlacesPerPiece);
  std::vector<Glyphs> drawn(pieces);
  for (Index first = 0; first < pieces; first += PiecesPerReport)
  {
    progress.Report(static_cast<double>(first) / pieces);
    ParallelFor(std::min(PiecesPerReport, pieces - first), 1,
      [&](Index begin, Index end)
      {
        for (Index piece = first + begin; piece < first + end; ++piece)
        {
          const Index place = piece * PlacesPerPiece;
          drawn[piece] = places.Draw(place, std::min(place + PlacesPerPiece, places.GetNumber()));
        }
      });
  }
  return Joined(drawn, places.Draw(0, 0));
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
  require(options.MaximumNumber >= 0 && options.MaximumNumber <= 1000000,
    "Maximum Number Of Glyphs must be 0, which is automatic, to 1000000.");
  require(options.Scale >= 0.01 && options.Scale <= 10.0, "Scale must be 0.01 to 10.");
  require(options.Offset >= -1.0 && options.Offset <= 1.0, "Offset must be -1 to 1.");
}

/// Takes the glyphs from the unit of their surface to that of the user.
void Rescale(int exponent, Glyphs& glyphs)
{
  if (exponent != 0)
  {
    for (Vector3& point : glyphs.Mesh.Points)
    {
      point = point.unaryExpr([exponent](double x) { return TimesPower(x, exponent); });
    }
    glyphs.Spacing = TimesPower(glyphs.Spacing, exponent);
  }
}
}

GlyphSurface::GlyphSurface(std::shared_ptr<const Surface> surface,
  std::vector<char> excludedTriangles, std::vector<char> excludedPoints)
  : Data(std::make_unique<GlyphSurfaceData>(
      std::move(surface), std::move(excludedTriangles), std::move(excludedPoints)))
{
}

GlyphSurface::~GlyphSurface() = default;

int GlyphSurface::GetNumberOfSamplings() const
{
  return this->Data->GetNumberOfSamplings();
}

Glyphs MakeGlyphs(GlyphSurface& drawnOn, const PointDirections& field, const GlyphOptions& options,
  const ProgressFunction& progress)
{
  Check(options);
  GlyphSurfaceData& surface = *drawnOn.Data;
  const Progress steps(progress);
  try
  {
    const SurfaceSamples& samples = surface.GetPlaces(options, steps.Part(0.0, ProgressSampled));
    const GlyphPlaces places(surface, samples, field, options);
    Glyphs glyphs = DrawAll(places, steps.Part(ProgressSampled, 1.0));
    if (!glyphs.Point.empty())
    {
      glyphs.Spacing = samples.Spacing > 0.0
        ? samples.Spacing
        : glyphs.Spacing / static_cast<double>(glyphs.Point.size());
    }
    Rescale(surface.GetExponent(), glyphs);
    return glyphs;
  }
  catch (const Stopped&)
  {
    Glyphs nothing;
    nothing.Aborted = true;
    return nothing;
  }
}

Glyphs MakeGlyphs(const Surface& surface, const PointDirections& field,
  const std::vector<char>& excludedTriangles, const std::vector<char>& excludedPoints,
  const GlyphOptions& options, const ProgressFunction& progress)
{
  // The caller's surface lives as long as this.
  GlyphSurface once(std::shared_ptr<const Surface>(std::shared_ptr<void>(), &surface),
    excludedTriangles, excludedPoints);
  return MakeGlyphs(once, field, options, progress);
}
}
