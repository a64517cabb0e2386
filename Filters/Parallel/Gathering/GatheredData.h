// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef GatheredData_h
#define GatheredData_h

#include "Gathering/GatheredSurface.h"
#include "Processes.h"

#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkPolyData;

namespace DirectionFields::Parallel
{
/// A surface with all of its data on one process.
struct WholeSurface
{
  /// Surface is this process's own piece where IsInPlace.
  GatheredSurface Gathered;
  /// Whether one process had all polygons before, so that nothing was moved.
  bool IsInPlace = false;
};

/// Gathers a surface with its arrays of numbers at points and cells and its field data, which are
/// those of the process that gathers. A point of several pieces has the values of the first. Left
/// out are ghost marks, global ids, and arrays that not all pieces have with as many components.
/// All processes call it; throws ProcessesError.
/// @param to the process that gets the surface; -1 for that with the largest piece
WholeSurface GatherWhole(Processes& processes, vtkPolyData* piece, int to = -1);

/// Gathers points or curves of all processes, in their order, as they are; what several processes
/// have alike counts once. All processes call it; throws ProcessesError.
/// @param own a vtkPointSet, a composite dataset of such, or null
/// @return null on the other processes
vtkSmartPointer<vtkPolyData> GatherParts(Processes& processes, vtkDataObject* own, int to);
}

#endif
