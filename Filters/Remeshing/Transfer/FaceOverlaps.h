// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FaceOverlaps_h
#define DirectionFields_FaceOverlaps_h

#include "Remesh.h"

#include <cstddef>
#include <vector>

namespace DirectionFields
{
/// Which triangles of a surface the faces of a mesh on it cover, and how much of them: a sparse
/// matrix with a row for each face. The columns sum up to the areas of the triangles.
struct FaceOverlaps
{
  /// Where the row of each face begins, and the end of the last one.
  std::vector<std::size_t> Offsets;
  /// Ascending in each row.
  std::vector<Index> Triangles;
  /// In squares of Unit; above 0.
  std::vector<double> Areas;
  /// A length, in the unit of the surface, and a power of two: about that of the wanted edges, so
  /// that areas are numbers however large or small the surface is.
  double Unit = 1.0;
};

/// The unit of areas on a mesh, as in FaceOverlaps.
double UnitOfAreas(const RemeshResult& mesh);

/// Triangles are halved until their parts are smaller than a sixteenth of the faces around, and
/// each part belongs to the face closest to its middle, of those that look the same way: sheets of
/// a thin part keep apart. Takes a search for each part, of which there are about 24 a face, and
/// one a triangle at least. Runs on the threads of the calling thread's Threads::Scope.
/// @param regions of the triangles, as the mesh was made with; parts belong to faces of their own
///                region. Triangles of regions without faces belong to none
FaceOverlaps FindOverlaps(
  const Surface& surface, const RemeshResult& mesh, const std::vector<Index>& regions = {});
}

#endif
