// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef CurveLines_h
#define CurveLines_h

#include <DirectionFields/Types.h>

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkCellData;
class vtkDataObject;
class vtkPolyData;

namespace DirectionFields
{
/// A cell of polydata.
struct GivenCell
{
  vtkSmartPointer<vtkPolyData> Data;
  vtkIdType Cell;
};

using Curves = std::vector<std::vector<Vector3>>;

/// The lines and points that a mesh is to have.
struct KeptLines
{
  DirectionFields::Curves Curves;
  /// The cell that each of them is, or begins with.
  std::vector<GivenCell> OfCurves;
  std::vector<Vector3> Points;
  /// The cell that each of them is in; None where the data has points alone.
  std::vector<GivenCell> OfPoints;
  /// Whether there are faces, which are none of both.
  bool HasFaces = false;
};

/// The lines, and the points of the vertices, of polydata, or of all polydata in a composite
/// dataset; none for null. Polydata without any cells has its points. A point is taken once. Throws
/// std::invalid_argument or std::out_of_range for damaged data, and for coordinates that are no
/// finite numbers, with a sentence that names the second input.
/// @param isKept whether a mesh is to have them, which takes points, too, and makes one curve of
///               lines of two points that meet end to end where no other line is, unless integers
///               or texts of theirs differ
KeptLines LinesOf(vtkDataObject* data, bool isKept = true);

/// The strengths of curves, 0 to 1: the cell array "Strength" of one component of their data, 1 in
/// data without it; empty where none has it. Throws std::invalid_argument for other numbers.
std::vector<double> StrengthsOf(const KeptLines& lines);

/// Adds the cell arrays that all of these cells' data have, of the same type.
/// @param sources for each cell of the output the one whose values it has; with null data NaN, 0 or
///                an empty text
void CarryCellArrays(const std::vector<GivenCell>& sources, vtkCellData* output);
}

#endif
