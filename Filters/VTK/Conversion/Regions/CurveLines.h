// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef CurveLines_h
#define CurveLines_h

#include <DirectionFields/Types.h>

#include <vector>

class vtkDataObject;

namespace DirectionFields
{
using Curves = std::vector<std::vector<Vector3>>;

/// The lines of polydata, or of all polydata in a composite dataset; none for null. Throws
/// std::invalid_argument or std::out_of_range for damaged data, and for lines with coordinates that
/// are no finite numbers, with a sentence that names the second input.
Curves LinesOf(vtkDataObject* data);
}

#endif
