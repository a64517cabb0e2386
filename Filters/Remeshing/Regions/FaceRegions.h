// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FaceRegions_h
#define DirectionFields_FaceRegions_h

#include "FaceMesh/FaceMesh.h"
#include "Preparation/PreparedSurface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The region of each face. All faces that edges on borders enclose are in the region that most of
/// them are closest to; where none has 95 % of their area, since a border is missing there, each
/// face is in the region of its closest triangle.
/// @param regions  of each triangle of the input
/// @param closest  triangle of the input to the middle of each face
/// @param isBorder not 0 for the lines, from 1 on, that no region crosses
std::vector<Index> RegionsOfFaces(const FaceMesh& mesh, const std::vector<Index>& regions,
  const std::vector<Index>& closest, const std::vector<char>& isBorder);

/// For the faces whose closest triangle is of another region the closest one of their own.
/// @param closest of each face, which is replaced
void FindInRegions(const PreparedSurface& surface, const FaceMesh& mesh,
  const std::vector<Index>& regions, const std::vector<Index>& ofFaces,
  std::vector<Index>& closest);
}

#endif
