// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef CellDirections_h
#define CellDirections_h

class vtkPolyData;

namespace DirectionFields
{
/// Adds the directions of polydata's field at the centroids of its cells as cell arrays Direction0,
/// Direction1, ..., unit vectors in the plane of the cell's triangle there, double if the points
/// are, else float; zero for vertices, lines and cells that take no part. And the point array
/// FaceSingularityIndex, the indices found by programs that know only these directions
/// (FaceSingularityIndices, of the triangles' directions); at points that became one it stands at
/// the first.
/// @param polyData whose field was computed
void AddCellDirections(vtkPolyData* polyData);
}

#endif
