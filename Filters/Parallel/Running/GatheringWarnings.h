// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef GatheringWarnings_h
#define GatheringWarnings_h

#include "vtkType.h"

#include <string>

class vtkPolyData;

namespace DirectionFields::Parallel
{
/// The warning about a surface of more polygons than Gather Limit.
std::string DescribeLargeSurface(vtkIdType polygons);

/// The warning about polygons that are copies of nothing.
std::string DescribeLostCopies(vtkIdType count);

/// Adds a warning to the field data.
void AddWarning(const std::string& warning, vtkPolyData* output);
}

#endif
