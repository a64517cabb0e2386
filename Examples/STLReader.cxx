// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A cross field along the edges of a part from a CAD system.

#include "FieldReport.h"

#include <vtkNew.h>
#include <vtkSTLReader.h>

int main(int argc, char* argv[])
{
  // STL files know no shared points; the reader merges those in the same place.
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(FileArgument(argc, argv));
  vtkNew<vtkDirectionField> field;
  field->SetInputConnection(reader->GetOutputPort());
  field->SetDegree(4);
  field->ConstrainSharpEdgesOn();
  return Report(field);
}
