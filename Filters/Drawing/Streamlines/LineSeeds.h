// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LineSeeds_h
#define DirectionFields_LineSeeds_h

#include "Streamlines/StreamlineTrace.h"

#include <vector>

namespace DirectionFields::Internal
{
/// A place where lines may start.
struct SeedPlace
{
  Index Triangle = None;
  /// The vertex that it is beside; None in the middle of a large triangle.
  Index Vertex = None;
  Complex Place;
  /// A direction that does not depend on numbers: direction 0 is the one nearest to it.
  Complex Along = 1.0;
  /// How early it has its turn: the larger, the earlier.
  double Rank = 0.0;
};

/// Places on a component of the surface, no point of which is farther than a fraction of the
/// spacing from one: the vertices, and more in triangles that are large. Their ranks are |u|, and
/// where that is the same everywhere the area around them: that does not depend on how the surface
/// lies or is numbered; only of the places along triangles much narrower than the spacing, a grid
/// in space leaves one in each cell. Takes time linear in triangles and places, on the threads of
/// the scope, and memory linear in triangles and area.
/// @param excluded not 0 for triangles of the mesh without places; empty for none
std::vector<SeedPlace> SeedPlaces(
  const GivenField& field, Index component, double spacing, const std::vector<char>& excluded);

/// How many squares of the side of the spacing evenly spaced lines of one family fill on a
/// component, about: those of its area, and where triangles are narrower than the spacing, the
/// cells of a grid in space that these lie in, as lines keep their distance in space. Takes time
/// linear in triangles and squares, and memory for as many squares as there may be.
/// @param spacing in the unit of the component
/// @param most    it stops counting where there are more
double FilledSquares(const GivenField& field, Index component, double spacing, double most);

/// The start of the line along direction k at a place.
LineStart StartAt(const GivenField& field, const SeedPlace& place, int k);
}

#endif
