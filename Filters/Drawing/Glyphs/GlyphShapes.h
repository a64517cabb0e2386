// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_GlyphShapes_h
#define DirectionFields_GlyphShapes_h

#include "Paths/SurfacePath.h"
#include "Types.h"

#include <cstdint>
#include <vector>

namespace DirectionFields::Internal
{
/// What the glyphs of a field are made of.
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

/// Points and cells of many glyphs; either all cells are polygons or all are lines.
struct GlyphMesh
{
  std::vector<Vector3> Points;
  /// Unit normals of the points.
  std::vector<Vector3> Normals;
  /// The points of cell i: Connectivity[Offsets[i]] ... Connectivity[Offsets[i + 1] - 1].
  std::vector<std::int64_t> Offsets = { 0 };
  std::vector<std::int64_t> Connectivity;
  bool AreLines = false;
  /// The number of each cell's glyph, and which of the n directions the cell shows.
  std::vector<Index> Glyph;
  std::vector<int> Branch;
};

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
