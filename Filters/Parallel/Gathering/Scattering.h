// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Scattering_h
#define Scattering_h

#include "Gathering/GatheredSurface.h"
#include "Processes.h"

class vtkFieldData;
class vtkPolyData;

namespace DirectionFields::Parallel
{
/// Brings the results on a gathered surface to the pieces: point, cell and field data, and the
/// points that were split off. Points and cells that the surface does not have get zeros; a copied
/// cell that lies where the surface was split keeps its points. All processes call it; throws
/// ProcessesError.
/// @param whole  the result on the surface, with its cells in their order; only where the surface
/// is
/// @param output a copy of the piece without arrays of an earlier field
void ScatterData(
  Processes& processes, const GatheredSurface& gathered, vtkPolyData* whole, vtkPolyData* output);

/// Adds the point and cell arrays of another process's data that are missing here, without values:
/// messages leave out empty arrays.
/// @param whole only read on that process
void AddMissingArrays(Processes& processes, int from, vtkPolyData* whole, vtkPolyData* own);

/// Adds field data that one process has computed to the field data of all.
/// @param computed only read on that process
void BroadcastFieldData(
  Processes& processes, int from, vtkFieldData* computed, vtkFieldData* output);
}

#endif
