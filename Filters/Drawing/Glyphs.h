// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Glyphs_h
#define DirectionFields_Glyphs_h

#include "Interpolation/GivenField.h"
#include "Progress.h"
#include "Surface.h"
#include "Types.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace DirectionFields
{
/// The shape of glyphs.
enum class GlyphType
{
  /// Arrows for one direction, else Ribbons.
  Automatic = 0,
  /// A line for each direction.
  Lines = 1,
  /// Flat arrows that face the normal.
  Arrows = 2,
  /// Flat bands that face the normal and taper towards the tip.
  Ribbons = 3,
  /// Round bars with pointed tips.
  Tubes = 4
};

/// Where glyphs are.
enum class GlyphMode
{
  /// Spread evenly over the surface.
  SpreadEvenly = 0,
  /// One on each point of the surface, or on an evenly spread part of them.
  AllPoints = 1
};

/// The side of the surface that glyphs are on.
enum class GlyphSide
{
  /// Outside of connected components that are closed, whatever their winding; on both sides of
  /// others.
  Automatic = 0,
  /// Where the normals point, as the triangles are wound. A field of more than two directions
  /// defines them by its own order.
  Front = 1,
  Back = 2,
  Both = 3
};

struct GlyphOptions
{
  GlyphType Type = GlyphType::Automatic;
  GlyphMode Mode = GlyphMode::SpreadEvenly;
  GlyphSide Side = GlyphSide::Automatic;
  /// Least distance between glyphs that are spread evenly, in the unit of the surface, 0 or more; 0
  /// is as small as MaximumNumber allows. It is at most the diagonal of the box around the surface.
  double Spacing = 0.0;
  /// Greatest number of glyphs, 1 to 1000000. 0 is automatic: 2000, or where they are spread evenly
  /// and Spacing is 0, too, 500, the arms of which are told apart where the surface fills a view of
  /// 530 pixels.
  Index MaximumNumber = 0;
  /// Diameter of a glyph as a part of the spacing, 0.01 to 10.
  double Scale = 1.0;
  /// Height above the surface, on the side of the glyph, as a part of the spacing, -1 to 1.
  double Offset = 0.04;
  /// Whether arms follow the surface; else they are straight and lie in the tangent plane.
  bool FollowSurface = true;
};

/// Points and cells of many glyphs: all cells are polygons, or all are lines.
struct GlyphMesh
{
  std::vector<Vector3> Points;
  /// Over the points: unit normals.
  std::vector<Vector3> Normals;
  /// Cell i has the points Connectivity[Offsets[i]] ... Connectivity[Offsets[i + 1] - 1].
  std::vector<std::int64_t> Offsets = { 0 };
  std::vector<std::int64_t> Connectivity;
  bool AreLines = false;
  /// Over the cells: the glyph that the cell belongs to, and the number k of the direction that it
  /// shows.
  std::vector<Index> Glyph;
  std::vector<int> Branch;
};

/// Glyphs and where they are.
struct Glyphs
{
  /// The shapes on both sides of a place are one glyph.
  GlyphMesh Mesh;
  /// Over the glyphs: the nearest point of the surface, and |u|, the magnitude of the field.
  std::vector<Index> Point;
  std::vector<double> Magnitude;
  /// n, the number of directions of each glyph, and their unit vectors: direction k of glyph g is
  /// Direction[g Degree + k].
  int Degree = 0;
  std::vector<Vector3> Direction;
  /// Mean over the glyphs of the spacing that sets their size, in the unit of the surface; 0
  /// without glyphs.
  double Spacing = 0.0;
  /// The progress function stopped the computation; there are no glyphs.
  bool Aborted = false;
};

namespace Internal
{
class GlyphSurfaceData;
}

/// A surface that several fields are drawn on, or one field with several options. All that depends
/// on the surface only is computed once: the triangles at each point, normals, the places of the
/// glyphs, and which side is outside.
class GlyphSurface
{
public:
  /// Anything may be wrong with the surface: triangles with ids of no point or without area have no
  /// glyphs.
  /// @param excludedTriangles not 0 for triangles without glyphs; empty for none
  /// @param excludedPoints    not 0 for points without glyphs; empty for none
  explicit GlyphSurface(std::shared_ptr<const Surface> surface,
    std::vector<char> excludedTriangles = {}, std::vector<char> excludedPoints = {});
  ~GlyphSurface();
  GlyphSurface(const GlyphSurface&) = delete;
  GlyphSurface& operator=(const GlyphSurface&) = delete;

  /// How often places were computed: again whenever mode, spacing or maximum number have changed.
  int GetNumberOfSamplings() const;

private:
  friend Glyphs MakeGlyphs(
    GlyphSurface&, const PointDirections&, const GlyphOptions&, const ProgressFunction&);

  std::unique_ptr<Internal::GlyphSurfaceData> Data;
};

/// Draws all n directions of a field at many places of a surface, as one glyph each, on the threads
/// of the calling thread's Threads::Scope. Places without directions have no glyphs: the middles of
/// singularities, and points that no triangle uses. Places that are spread evenly have a
/// Poisson-disk distribution, improved by Lloyd's iteration; there is no randomness, and the result
/// does not depend on the number of threads.
///
/// @param field    the n directions at each point of the surface
/// @param progress returns false to stop: Glyphs::Aborted is set then
/// @throw std::invalid_argument for options out of their ranges
Glyphs MakeGlyphs(GlyphSurface& surface, const PointDirections& field,
  const GlyphOptions& options = {}, const ProgressFunction& progress = {});

/// The same for a surface that is drawn on once.
/// @param excludedTriangles not 0 for triangles without glyphs; empty for none
/// @param excludedPoints    not 0 for points without glyphs; empty for none
Glyphs MakeGlyphs(const Surface& surface, const PointDirections& field,
  const std::vector<char>& excludedTriangles, const std::vector<char>& excludedPoints,
  const GlyphOptions& options = {}, const ProgressFunction& progress = {});
}

#endif
