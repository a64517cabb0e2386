// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A cross field beside normals, on a surface whose faces had to be joined and turned.

#include "FieldReport.h"

#include <vtkCleanPolyData.h>
#include <vtkCylinderSource.h>
#include <vtkNew.h>
#include <vtkPolyDataNormals.h>

int main()
{
  // The side and the two lids are no neighbours until their points are merged.
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetResolution(24);
  vtkNew<vtkCleanPolyData> merge;
  merge->SetInputConnection(cylinder->GetOutputPort());
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(merge->GetOutputPort());
  normals->AutoOrientNormalsOn();
  // Else the surface falls apart at its sharp edges.
  normals->SplittingOff();
  vtkNew<vtkDirectionField> field;
  field->SetInputConnection(normals->GetOutputPort());
  field->SetDegree(4);
  return Report(field);
}
