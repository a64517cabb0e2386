// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef PolyDataCheck_h
#define PolyDataCheck_h

#include "vtkType.h"

class vtkCellArray;
class vtkPolyData;

namespace DirectionFields
{
/// Throws std::invalid_argument or std::out_of_range with a sentence for the user where polydata
/// contradicts itself, as damaged files do: offsets of cells that do not ascend from 0 to the
/// number of corners, vertices and lines at points that are not there, point or cell arrays with
/// too few tuples, invalid ghost marks. Takes no longer than reading the offsets.
///
/// The corners of polygons and strips are left to CheckCorners.
void CheckPolyData(vtkPolyData* polyData);

/// Throws std::out_of_range where cells use points that are not there.
/// @param cells     have passed CheckPolyData
/// @param firstCell the number of the first of them, for the sentence
void CheckCorners(vtkCellArray* cells, vtkIdType firstCell, vtkIdType points);

/// Throws std::out_of_range with a sentence for the user: a cell has the id of a point that is not
/// there.
[[noreturn]] void RefuseId(vtkIdType cell, vtkIdType id, vtkIdType points);
}

#endif
