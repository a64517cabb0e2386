// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Glyphs_h
#define DirectionFields_Glyphs_h

#include "Glyphs/GlyphOptions.h"
#include "Glyphs/GlyphShapes.h"
#include "Glyphs/GlyphSurface.h"
#include "Interpolation/FieldInterpolation.h"
#include "Progress.h"
#include "Surface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Glyphs and where they are.
struct Glyphs
{
  /// What is on both sides of a place is one glyph.
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
/// in the middle of a singularity and at points that no triangle uses, have none. The places depend on the
/// surface only, and are there already if glyphs were drawn on it before.
///
/// Throws std::invalid_argument for options out of their ranges.
/// @param progress stops the drawing: no glyphs are returned then
Glyphs MakeGlyphs(GlyphSurface& surface, const PointDirections& field, const GlyphOptions& options,
  const ProgressFunction& progress = {});

/// The same for a surface that is drawn on once.
/// @param excludedTriangles not 0 for triangles without glyphs; empty for none
/// @param excludedPoints    not 0 for points without glyphs; empty for none
Glyphs MakeGlyphs(const Surface& surface, const PointDirections& field,
  const std::vector<char>& excludedTriangles, const std::vector<char>& excludedPoints,
  const GlyphOptions& options, const ProgressFunction& progress = {});
}

#endif
