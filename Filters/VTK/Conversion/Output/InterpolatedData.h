// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef InterpolatedData_h
#define InterpolatedData_h

class vtkDataSetAttributes;

namespace DirectionFields
{
/// Removes what points and cells of another mesh of the same surface cannot have: directions, which are not to be
/// interpolated, and marks of the input's own points and cells.
void DropWhatIsNotToInterpolate(vtkDataSetAttributes* data);
}

#endif
