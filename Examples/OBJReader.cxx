// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The cross field of an OBJ file.

#include "FieldReport.h"

#include <vtkNew.h>
#include <vtkOBJReader.h>

int main(int argc, char* argv[])
{
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(FileArgument(argc, argv));
  // With texture coordinates or normals the reader gives each face points of its own: the filter connects
  // them by their places.
  vtkNew<vtkDirectionField> field;
  field->SetInputConnection(reader->GetOutputPort());
  field->SetDegree(4);
  return Report(field);
}
