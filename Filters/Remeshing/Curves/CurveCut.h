// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CurveCut_h
#define DirectionFields_CurveCut_h

#include "Progress.h"
#include "Surface.h"

#include <array>
#include <string>
#include <vector>

namespace DirectionFields::Internal
{
/// Lines and points that a mesh is to have.
struct GivenLines
{
  std::vector<std::vector<Vector3>> Curves;
  std::vector<Vector3> Points;

  bool IsEmpty() const { return this->Curves.empty() && this->Points.empty(); }
};

/// A surface whose triangles are cut such that curves run along their edges, and points are corners
/// of them.
struct CurveCut
{
  /// The points given, in their order, and then those of cuts.
  Surface Cut;
  /// The triangle given that each one is a part of.
  std::vector<Index> Parents;
  /// The edges along curves, the lower point first, each once.
  std::vector<std::array<Index, 2>> Edges;
  /// The curve of each of them, the first one where several are there.
  std::vector<Index> CurveOf;
  /// The point of the cut surface that stands for each point given, and the place there that is
  /// closest to that one; None for those that are left out.
  std::vector<Index> Points;
  std::vector<Vector3> Places;
  /// Sentences for the user, on parts of curves that are left out. Curves are numbered from 0 on.
  std::vector<std::string> Notes;
};

/// Curves are projected to the surface, and run from point to point in the planes through both
/// that are at right angles to the triangles. They take points of the surface that they pass
/// closely: by less than a twentieth of the edges there and, at a point of the curve, a quarter of
/// the way to those before and after it. Where curves cross there is a point.
/// Points come first, and take those of the surface that are closer than a hundredth of the edges
/// there. Parts of curves between points that are farther from the surface than a hundredth of its
/// diagonal are left out, and so are those that do not come to their end on it, and curves without
/// length. Points at the same
/// place across seams are one. Takes time by the number of triangles that come about, but for
/// points that lie far from those before them in one triangle.
/// Throws MeshError for a surface that cannot be processed, and Stopped.
/// @param given in the unit of the surface; places that have overflowed in it are far away
CurveCut CutAlong(const Surface& surface, const GivenLines& given, const Progress& progress = {});
}

#endif
