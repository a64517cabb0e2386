// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A knit pattern on a sleeve: two stripe patterns on one line field, courses around the arm and wales along it, written to
// Courses.obj and Wales.obj. The sleeve is narrower at the wrist, so that wales have to end on the way.

#include "FieldReport.h"

#include <vtkCellArray.h>
#include <vtkDirectionField.h>
#include <vtkNew.h>
#include <vtkOBJWriter.h>
#include <vtkPoints.h>
#include <vtkStripePattern.h>

#include <cmath>

namespace
{
/// A bent tube of quads that gets narrower.
vtkNew<vtkPolyData> MakeSleeve(int around, int along)
{
  constexpr double pi = 3.14159265358979323846;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  for (int j = 0; j <= along; ++j)
  {
    // The elbow is an arc of 70 degrees about the z axis.
    const double part = static_cast<double>(j) / along;
    const double bend = 70.0 / 180.0 * pi * part;
    const double radius = 1.0 - 0.5 * part;
    for (int i = 0; i < around; ++i)
    {
      const double angle = 2.0 * pi * i / around;
      const double reach = 4.0 + radius * std::cos(angle);
      points->InsertNextPoint(
        reach * std::cos(bend), reach * std::sin(bend), radius * std::sin(angle));
      if (j < along)
      {
        const vtkIdType a = j * around + i;
        const vtkIdType b = j * around + (i + 1) % around;
        quads->InsertNextCell({ a, a + around, b + around, b });
      }
    }
  }
  vtkNew<vtkPolyData> sleeve;
  sleeve->SetPoints(points);
  sleeve->SetPolys(quads);
  return sleeve;
}
}

int main()
{
  auto sleeve = MakeSleeve(100, 120);
  vtkNew<vtkDirectionField> field;
  field->SetInputData(sleeve);
  field->SetDegree(2);
  field->ConstrainBoundaryOn();
  for (const bool isCourse : { true, false })
  {
    vtkNew<vtkStripePattern> stripes;
    stripes->SetInputConnection(field->GetOutputPort());
    stripes->SetStripeDirection(
      isCourse ? vtkStripePattern::ALONG_FIELD : vtkStripePattern::ACROSS_FIELD);
    stripes->SetSpacing(0.12);
    stripes->Update();
    vtkDataArray* misfit = stripes->GetOutput()->GetFieldData()->GetArray("Misfit");
    if (!misfit || misfit->GetTuple1(0) > 0.2)
    {
      return EXIT_FAILURE;
    }
    const int branchPoints = Sum(stripes->GetOutput()->GetFieldData(), "BranchPoints");
    std::cout << (isCourse ? "Courses" : "Wales")
              << (branchPoints == 0 ? " without branches" : " that branch or end") << std::endl;
    vtkNew<vtkOBJWriter> writer;
    writer->SetInputData(stripes->GetOutput());
    writer->SetFileName(isCourse ? "Courses.obj" : "Wales.obj");
    if (writer->Write() != 1)
    {
      return EXIT_FAILURE;
    }
  }
  return EXIT_SUCCESS;
}
