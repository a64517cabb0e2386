// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The smoothest line field of a PLY file.

#include "FieldReport.h"

#include <vtkNew.h>
#include <vtkPLYReader.h>

int main(int argc, char* argv[])
{
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(FileArgument(argc, argv));
  vtkNew<vtkDirectionField> field;
  field->SetInputConnection(reader->GetOutputPort());
  field->SetDegree(2);
  return Report(field);
}
