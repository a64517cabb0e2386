// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FaceCounts_h
#define DirectionFields_FaceCounts_h

#include "FaceMesh/FaceMesh.h"

namespace DirectionFields::Internal
{
struct FaceCounts
{
  Index Quads = 0;
  Index Triangles = 0;
  /// Interior vertices with another number of faces than regular ones.
  Index IrregularVertices = 0;

  /// @param degree the faces at a regular vertex
  FaceCounts(const FaceMesh& mesh, int degree);
};
}

#endif
