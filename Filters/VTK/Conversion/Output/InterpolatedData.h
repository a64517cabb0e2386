// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef InterpolatedData_h
#define InterpolatedData_h

class vtkDataSetAttributes;

namespace DirectionFields
{
/// Removes arrays that another mesh of the same surface cannot take over: directions, which are not
/// to be interpolated, and marks of the input's own points and cells.
void DropWhatIsNotToInterpolate(vtkDataSetAttributes* data);
}

#endif
