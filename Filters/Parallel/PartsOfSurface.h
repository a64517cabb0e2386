// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef PartsOfSurface_h
#define PartsOfSurface_h

#include "GatheredSurface.h"
#include "Processes.h"

class vtkPolyData;

namespace DirectionFields::Parallel
{
/// What the cells of another dataset belong to.
enum class PartsBelongTo
{
  /// Point `CellId` stands for the cell of this id.
  Cells,
  /// Cell `PointId` stands for the point of this id.
  Points
};

/// Shares the cells of a dataset that was made of a gathered surface, glyphs or singularities, out among the
/// processes whose pieces have what they belong to, the first of them where several have it. The ids become
/// those of the piece. All processes call it; throws ProcessesError.
/// @param whole has the array of ids; only where the surface is
/// @param own   an empty vtkPolyData
void ScatterParts(Processes& processes, const GatheredSurface& gathered, PartsBelongTo belong,
  vtkPolyData* whole, vtkPolyData* own);

}

#endif
