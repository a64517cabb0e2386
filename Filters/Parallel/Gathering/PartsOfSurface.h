// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef PartsOfSurface_h
#define PartsOfSurface_h

#include "Gathering/GatheredSurface.h"
#include "Processes.h"

class vtkPolyData;

namespace DirectionFields::Parallel
{
/// Whether another dataset's cells belong to cells or points of the surface.
enum class PartsBelongTo
{
  /// Point `CellId` stands for the cell of this id.
  Cells,
  /// Cell `PointId` stands for the point of this id.
  Points
};

/// Distributes the cells of a dataset that was made of a gathered surface, glyphs or singularities,
/// to the processes whose pieces have the point or cell that they belong to, the first of them
/// where several have it. The ids become the piece's. All processes call it; throws ProcessesError.
/// @param whole has the array of ids; only where the surface is
/// @param own   an empty vtkPolyData
void ScatterParts(Processes& processes, const GatheredSurface& gathered, PartsBelongTo belong,
  vtkPolyData* whole, vtkPolyData* own);

}

#endif
