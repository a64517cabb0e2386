// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RegionReport_h
#define DirectionFields_RegionReport_h

#include "FaceMesh/FaceMesh.h"
#include "Preparation/PreparedSurface.h"
#include "Regions/RegionFigures.h"

#include <string>
#include <vector>

namespace DirectionFields::Internal
{
/// The features of a surface at which regions meet.
struct RegionLines
{
  /// Not 0 for the lines, from 1 on, that are borders of regions, or the boundary, where sheets may
  /// meet.
  std::vector<char> IsBorder;
  /// All segments of the borders, as triangles without area.
  std::vector<ClosestPoints::Corners> Segments;
  /// Where three regions meet, or two at the boundary.
  std::vector<Vector3> Corners;

  RegionLines(const PreparedSurface& surface, const FeatureLines& features);
};

/// How well a mesh shows the regions of a surface.
/// @param regions    of each triangle of the surface
/// @param ofFaces    the region of each face
/// @param hasCurves  all lines of the mesh count as borders
/// @param edgeLength wanted
RegionFigures FiguresOf(const Surface& surface, const std::vector<Index>& regions,
  const RegionLines& lines, const FaceMesh& mesh, const std::vector<Index>& ofFaces, bool hasCurves,
  double edgeLength);

/// The regions of the faces of a mesh, how well they are shown, and a sentence each about regions
/// and borders that are not, with its remedy.
struct RegionReport
{
  std::vector<Index> OfFaces;
  RegionFigures Shown;
  std::vector<std::string> Sentences;
};

/// @param regions    of each triangle of the input; empty for curves without regions
/// @param names      of the regions, by their numbers; empty for the numbers themselves
/// @param hasCurves  curves are hard, too, and count like borders
/// @param edgeLength wanted
/// @param closest    triangle of the input to each face; those of another region than the face are
///                   replaced by the closest one of its own
RegionReport ReportRegions(const Surface& input, const std::vector<Index>& regions,
  const std::vector<std::string>& names, bool hasCurves, const PreparedSurface& surface,
  const FeatureLines& features, const FaceMesh& mesh, double edgeLength,
  std::vector<Index>& closest);
}

#endif
