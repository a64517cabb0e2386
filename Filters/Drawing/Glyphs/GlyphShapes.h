// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_GlyphShapes_h
#define DirectionFields_GlyphShapes_h

#include "Glyphs.h"
#include "Paths/SurfacePath.h"
#include "Types.h"

#include <cstdint>
#include <vector>

namespace DirectionFields::Internal
{
/// Draws one direction after the other into a mesh.
class GlyphShapes
{
public:
  /// type: not Automatic.
  GlyphShapes(GlyphType type, int degree, GlyphMesh& mesh);

  /// Draws the branch of a glyph along a path from its centre to its tip; for one direction from
  /// tail to tip, the centre at distance 0. length: from centre to tip.
  /// height: above the path, along its normals.
  void Draw(Index glyph, int branch, const SurfacePath& path, double length, double height);

private:
  /// Half the width of the shape at a distance from the centre, both as parts of the length. It
  /// jumps where two follow at the same distance.
  struct Width
  {
    double Distance;
    double Half;
  };

  void MakeProfile(GlyphType type, int degree);
  void DrawLines(const SurfacePath& path, double length, double height);
  void DrawBand(const SurfacePath& path, double length, double height);
  void DrawTube(const SurfacePath& path, double length, double height);
  std::int64_t AddPoint(const Vector3& position, const Vector3& normal);
  void AddCell(std::initializer_list<std::int64_t> points);
  void EndCell();
  /// Distances along the path at which a part of the shape has points: its ends, and the bends of
  /// the path in between.
  void FindStations(const SurfacePath& path, double begin, double end);

  GlyphType Type;
  int Degree;
  GlyphMesh& Mesh;
  std::vector<Width> Profile;
  std::vector<double> Stations;
  Index Glyph = 0;
  int Branch = 0;
};
}

#endif
