// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The cross field of a subdivision surface.

#include "FieldReport.h"

#include <vtkLoopSubdivisionFilter.h>
#include <vtkNew.h>
#include <vtkPlatonicSolidSource.h>

int main()
{
  vtkNew<vtkPlatonicSolidSource> solid;
  solid->SetSolidTypeToOctahedron();
  vtkNew<vtkLoopSubdivisionFilter> subdivision;
  subdivision->SetInputConnection(solid->GetOutputPort());
  subdivision->SetNumberOfSubdivisions(4);
  vtkNew<vtkDirectionField> field;
  field->SetInputConnection(subdivision->GetOutputPort());
  field->SetDegree(4);
  return Report(field);
}
