// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef EditedPolyData_h
#define EditedPolyData_h

#include "Conversion/Input/PolyDataToSurface.h"

#include <DirectionFields/PrescribedSingularities/SingularityEditor.h>
#include <DirectionFields/Progress.h>
#include <DirectionFields/Result.h>

#include <string>
#include <vector>

class vtkCompositeDataSet;
class vtkDataObject;
class vtkPolyData;

namespace DirectionFields
{
/// The points of a vtkPointSet, or of all in a composite dataset, with their array
/// SingularityIndex; 1 where there is none. Throws std::invalid_argument where it has more
/// components or numbers that are not whole.
std::vector<WantedSingularity> WantedSingularities(vtkDataObject* points);

/// The same for each block of an input: the points of the same block where there are equally many
/// blocks, else the points that are nearer to this block than to any other.
/// @param blocks of the input, in their order; null for a block that is no polydata
std::vector<std::vector<WantedSingularity>> WantedOfBlocks(
  const std::vector<vtkPolyData*>& blocks, vtkCompositeDataSet* input, vtkDataObject* points);

/// Adds the edited field's arrays to a copy of the input, and makes its singularities. Throws
/// Stopped.
/// @param field of the edit (ToResult)
void AddEditedField(const TriangulatedPolyData& surface, const EditedField& edited,
  const Result& field, const std::vector<std::string>& warnings, vtkPolyData* input,
  vtkPolyData* output, vtkPolyData* singularities, const Progress& progress);
}

#endif
