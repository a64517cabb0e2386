// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CurveCut_h
#define DirectionFields_CurveCut_h

#include "Surface.h"

#include <array>
#include <string>
#include <vector>

namespace DirectionFields::Internal
{
/// A surface whose triangles are cut such that curves run along their edges.
struct CurveCut
{
  /// The points given, in their order, and then those of cuts.
  Surface Cut;
  /// The triangle given that each one is a part of.
  std::vector<Index> Parents;
  /// The edges along curves, the lower point first, each once.
  std::vector<std::array<Index, 2>> Edges;
  /// Sentences for the user, on parts of curves that are left out. Curves are numbered from 0 on.
  std::vector<std::string> Notes;
};

/// Curves are projected to the surface, and run from point to point in the planes through both
/// that are at right angles to the triangles. They take points of the surface that they pass
/// closely: by less than a twentieth of the edges there. Where curves cross there is a
/// point. Parts of curves between points that are farther from the surface than a hundredth of its
/// diagonal are left out, and so are those that do not come to their end on it. Points at the same
/// place across seams are one.
/// Throws MeshError for a surface that cannot be processed.
/// @param curves in the unit of the surface; points that have overflowed in it are far away
CurveCut CutAlong(const Surface& surface, const std::vector<std::vector<Vector3>>& curves);
}

#endif
