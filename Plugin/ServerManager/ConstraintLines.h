// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef ConstraintLines_h
#define ConstraintLines_h

#include "vtkSmartPointer.h"

class vtkPolyData;

/// The edges that a field was made to follow: sharp edges, the boundary, and edges of more than two
/// triangles. These are told by the point array ConstraintKind of Direction Field: both ends have to
/// be constrained by such a line, and the edge has to be at least half as sharp as the sharpest such
/// edge of one of its ends, which edges across from line to line are not. Polygons of any kind, no
/// strips; empty without constraints. Takes time linear in the cells but for sorting the edges found.
vtkSmartPointer<vtkPolyData> ConstraintLines(vtkPolyData* field);

#endif
