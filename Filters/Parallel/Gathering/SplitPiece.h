// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SplitPiece_h
#define SplitPiece_h

#include "Gathering/GatheredSurface.h"
#include "Processes.h"

#include "vtkType.h"

#include <vector>

class vtkPolyData;

namespace DirectionFields::Parallel
{
/// Whether a surface was split because it is no manifold.
bool IsSplit(vtkPolyData* whole);

/// The points of all pieces after they have been split, as GatheredSurface has them.
struct SplitPiece
{
  std::vector<vtkIdType> PointsOf;
  std::vector<vtkIdType> FirstPointOf;
  /// Where this piece has its points.
  std::vector<vtkIdType> Places;
};

/// Splits each piece where the gathered surface was split: appends the points that were split off,
/// each with the point data of its original, gives the polygons and strips the points of the
/// surface's, and adds the array OriginalPointIds. All processes call it; throws ProcessesError.
/// @param whole  the split surface, only where it is
/// @param output a copy of the piece
SplitPiece SplitAsGathered(
  Processes& processes, const GatheredSurface& gathered, vtkPolyData* whole, vtkPolyData* output);
}

#endif
