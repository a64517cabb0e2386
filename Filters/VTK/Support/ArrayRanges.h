// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef ArrayRanges_h
#define ArrayRanges_h

class vtkDataObject;

namespace DirectionFields
{
/// Computes the ranges of the components and of the lengths of all arrays that nothing but this
/// output holds, on the threads of the computation, and keeps them where vtkDataArray::GetRange and
/// GetFiniteRange look for them, until an array is modified. VTK takes ten times as long for them,
/// and ParaView asks for all of them before it shows a surface. Nothing is kept for arrays with
/// values that are not finite or exceed 1e38, where VTK's own rules hold, nor for those of more
/// than three components or of other types than float, double, int and vtkIdType. Only a
/// vtkPolyData is looked at. The finite lengths' range VTK computes itself.
void KeepRanges(vtkDataObject* output);
}

#endif
