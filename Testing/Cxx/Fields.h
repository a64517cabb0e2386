// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fields for the tests of the filters that take fields.

#ifndef Fields_h
#define Fields_h

#include "Checks.h"

#include "vtkDirectionField.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

/// The smoothest field on a mesh.
inline vtkSmartPointer<vtkPolyData> Field(vtkPolyData* mesh, int degree)
{
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(mesh);
  filter->SetDegree(degree);
  filter->Update();
  return filter->GetOutput();
}

/// The same of a mesh that nothing is to be said of.
inline vtkSmartPointer<vtkPolyData> QuietField(vtkPolyData* mesh, int degree = 4)
{
  vtkNew<vtkDirectionField> filter;
  vtkNew<Checks::Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(mesh);
  filter->SetDegree(degree);
  filter->Update();
  CHECK(messages->IsEmpty());
  return filter->GetOutput();
}

#endif
