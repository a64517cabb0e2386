// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef CompositeOutputs_h
#define CompositeOutputs_h

class vtkInformationVector;

namespace DirectionFields
{
/// Makes each output a vtkPolyData, or a composite dataset of the input's class where the input is one: for filters that go
/// through the blocks themselves, since the pipeline does so for one of several composite inputs only.
void MakeOutputsLike(vtkInformationVector* input, vtkInformationVector* outputs);
}

#endif
