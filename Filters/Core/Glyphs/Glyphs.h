// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Glyphs_h
#define DirectionFields_Glyphs_h

#include "Glyphs/GlyphShapes.h"
#include "Progress.h"
#include "Surface.h"
#include "Tracing/FieldInterpolation.h"
#include "Tracing/SurfaceSampling.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Where the glyphs are.
enum class GlyphMode
{
  /// Spread evenly over the surface.
  SpreadEvenly = 0,
  /// One on each point of the surface, or on an evenly spread part of them.
  AllPoints = 1
};

struct GlyphOptions
{
  GlyphType Type = GlyphType::Automatic;
  GlyphMode Mode = GlyphMode::SpreadEvenly;
  /// Least distance between glyphs that are spread evenly, not negative; 0: by MaximumNumber. What
  /// exceeds the diagonal of the box around the surface is taken for that.
  double Spacing = 0.0;
  /// Most glyphs, 1 to 1000000.
  Index MaximumNumber = 2000;
  /// Diameter of a glyph as a part of the spacing, 0.01 to 10.
  double Scale = 1.0;
  /// Height above the surface as a part of the spacing, -1 to 1.
  double Offset = 0.04;
  /// Arms follow the surface; else they are straight and lie in the tangent plane.
  bool FollowSurface = true;
};

/// Glyphs and where they are.
struct Glyphs
{
  GlyphMesh Mesh;
  /// For each glyph the point of the surface that is nearest, and |u|.
  std::vector<Index> Point;
  std::vector<double> Magnitude;
  /// The number of directions of each glyph, and their unit vectors: direction k of glyph g is the
  /// element g Degree + k.
  int Degree = 0;
  std::vector<Vector3> Direction;
  /// Mean over the glyphs of the spacing that their size goes by; 0 without glyphs.
  double Spacing = 0.0;
  /// Stopped by the progress callback; there are no glyphs.
  bool Aborted = false;
};

/// Draws all n directions of a field at many places, as one glyph each. Places without directions,
/// in the middle of a singularity and at points that no triangle uses, have none.
///
/// Throws std::invalid_argument for options out of their ranges.
/// @param excludedTriangles not 0 for triangles without glyphs; empty for none
/// @param excludedPoints    not 0 for points without glyphs; empty for none
/// @param progress          stops the drawing: no glyphs are returned then
Glyphs MakeGlyphs(const Surface& surface, const PointDirections& field,
  const std::vector<char>& excludedTriangles, const std::vector<char>& excludedPoints,
  const GlyphOptions& options, const ProgressFunction& progress = {});
}

#endif
