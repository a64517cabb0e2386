// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Hatching of a PLY file along its greatest curvature, as in engravings, written to Hatching.obj: lines for a plotter, each
// as long as can be.

#include "FieldReport.h"

#include <vtkCellData.h>
#include <vtkDirectionField.h>
#include <vtkNew.h>
#include <vtkOBJWriter.h>
#include <vtkPLYReader.h>
#include <vtkStripePattern.h>

int main(int argc, char* argv[])
{
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(FileArgument(argc, argv));
  vtkNew<vtkDirectionField> field;
  field->SetInputConnection(reader->GetOutputPort());
  field->SetDegree(2);
  field->SetAlignment(vtkDirectionField::ALIGN_PRINCIPAL_CURVATURE);
  field->SetAlignmentStrength(0.5);
  vtkNew<vtkStripePattern> hatching;
  hatching->SetInputConnection(field->GetOutputPort());
  hatching->SetSpacing(0.2);
  hatching->BandsOff();
  hatching->Update();

  vtkPolyData* lines = hatching->GetOutput();
  vtkDataArray* lengths = lines->GetCellData()->GetArray("Length");
  double length = 0.0;
  for (vtkIdType i = 0; lengths && i < lengths->GetNumberOfTuples(); ++i)
  {
    length += lengths->GetTuple1(i);
  }
  if (!(length > 0.0))
  {
    return EXIT_FAILURE;
  }
  std::cout << "about " << 100 * static_cast<int>(length / 100.0 + 0.5) << " long in all, in "
            << (lines->GetNumberOfLines() < 300 ? "less" : "more") << " than 300 strokes"
            << std::endl;
  vtkNew<vtkOBJWriter> writer;
  writer->SetInputData(lines);
  writer->SetFileName("Hatching.obj");
  return writer->Write() == 1 ? EXIT_SUCCESS : EXIT_FAILURE;
}
