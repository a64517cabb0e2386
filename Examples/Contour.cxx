// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The hex field of an isosurface.

#include "FieldReport.h"

#include <vtkContourFilter.h>
#include <vtkNew.h>
#include <vtkSampleFunction.h>
#include <vtkSuperquadric.h>

int main()
{
  vtkNew<vtkSuperquadric> pillow;
  pillow->SetPhiRoundness(0.8);
  pillow->SetThetaRoundness(0.6);
  vtkNew<vtkSampleFunction> sample;
  sample->SetImplicitFunction(pillow);
  sample->SetModelBounds(-0.8, 0.8, -0.8, 0.8, -0.8, 0.8);
  sample->SetSampleDimensions(24, 26, 28);
  vtkNew<vtkContourFilter> contour;
  contour->SetInputConnection(sample->GetOutputPort());
  contour->SetValue(0, 0.0);
  vtkNew<vtkDirectionField> field;
  field->SetInputConnection(contour->GetOutputPort());
  field->SetDegree(6);
  return Report(field);
}
