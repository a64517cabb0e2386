// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A mesh of quads along the cross field of a PLY file, written to Quads.ply.

#include "FieldReport.h"

#include <vtkFieldAlignedRemesh.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPLYWriter.h>

int main(int argc, char* argv[])
{
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(FileArgument(argc, argv));
  vtkNew<vtkFieldAlignedRemesh> remesh;
  remesh->SetInputConnection(reader->GetOutputPort());
  remesh->SetNumberOfFaces(2000);
  remesh->Update();

  vtkPolyData* mesh = remesh->GetOutput();
  vtkFieldData* figures = mesh->GetFieldData();
  const int faces = Sum(figures, "Faces");
  vtkDataArray* euler = figures->GetArray("EulerCharacteristic");
  if (faces == 0 || !euler || euler->GetComponent(0, 0) != euler->GetComponent(0, 1))
  {
    return EXIT_FAILURE;
  }
  std::cout << 100 * Sum(figures, "Quads") / faces << "% quads, Euler characteristic "
            << euler->GetComponent(0, 1) << " as before" << std::endl;
  vtkNew<vtkPLYWriter> writer;
  writer->SetInputData(mesh);
  writer->SetFileName("Quads.ply");
  return writer->Write() == 1 ? EXIT_SUCCESS : EXIT_FAILURE;
}
