// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_GlyphOptions_h
#define DirectionFields_GlyphOptions_h

#include "Glyphs/GlyphShapes.h"
#include "Types.h"

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

/// Which side of the surface the glyphs are on.
enum class GlyphSide
{
  /// Outside where a connected component is closed, whatever its winding, else on both sides.
  Automatic = 0,
  /// Where the normals are, as the triangles are wound; the directions of a field of more than two know
  /// it by themselves.
  Front = 1,
  Back = 2,
  Both = 3
};

struct GlyphOptions
{
  GlyphType Type = GlyphType::Automatic;
  GlyphMode Mode = GlyphMode::SpreadEvenly;
  GlyphSide Side = GlyphSide::Automatic;
  /// Least distance between glyphs that are spread evenly, not negative; 0: by MaximumNumber. What
  /// exceeds the diagonal of the box around the surface is taken for that.
  double Spacing = 0.0;
  /// Most places of glyphs, 1 to 1000000.
  Index MaximumNumber = 2000;
  /// Diameter of a glyph as a part of the spacing, 0.01 to 10.
  double Scale = 1.0;
  /// Height above the surface, on the side of the glyph, as a part of the spacing, -1 to 1.
  double Offset = 0.04;
  /// Arms follow the surface; else they are straight and lie in the tangent plane.
  bool FollowSurface = true;
};
}

#endif
