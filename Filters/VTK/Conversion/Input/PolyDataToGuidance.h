// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef PolyDataToGuidance_h
#define PolyDataToGuidance_h

#include <DirectionFields/Options.h>

#include <vector>

class vtkPolyData;

namespace DirectionFields
{
/// The guidance in the point data of a vtkPolyData.
/// @param vectors name of the array of 3 components that holds the vectors
/// @param weights name of the array of 1 component that holds the weights
///
/// Where a name is null, empty, or "None" with no array of that name, the guidance lacks the part.
/// Throws std::invalid_argument where there is no array of the name and the number of components.
Guidance PolyDataToGuidance(vtkPolyData* polyData, const char* vectors, const char* weights);

/// The values of the point array of a name, of one component; none where the name is null, empty,
/// or ParaView's "None". Throws std::invalid_argument where there is no such array.
/// @param property of the filter, for the sentence of the error
std::vector<double> PointValues(vtkPolyData* polyData, const char* name, const char* property);
}

#endif
