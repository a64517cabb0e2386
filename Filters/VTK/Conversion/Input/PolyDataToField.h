// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef PolyDataToField_h
#define PolyDataToField_h

#include <DirectionFields/Interpolation/GivenField.h>

class vtkPolyData;

namespace DirectionFields
{
/// The directions in the point data of a vtkPolyData, which must outlive them: the arrays of
/// Direction Field or of a reader. Degree is the number of the consecutive arrays Direction0,
/// Direction1, ...; 0 if there is none. Magnitude is 1 where there is no array
/// RepresentationMagnitude. Throws std::invalid_argument where a direction has not 3 components or
/// the magnitude not 1, and with the point where one is not finite.
///
/// GivenField makes a field of it and of the surface of PolyDataToSurface.
/// @param polyData has passed CheckPolyData
PointDirections FindDirections(vtkPolyData* polyData);

/// The same for input that must have a field: throws std::invalid_argument with a sentence for the
/// user where there is none.
PointDirections RequireDirections(vtkPolyData* polyData);
}

#endif
