// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The field of a sphere, in a VTK pipeline.

#include <vtkDirectionField.h>

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>

#include <cstdlib>
#include <iostream>

// These names may be the consumer's own. Options.h is in newer versions of ParaView.
#if __has_include(<MeshError.h>) || __has_include(<Types.h>) || __has_include(<DirectionField.h>)
#error "Headers of Direction Fields lie bare on the include path."
#endif

int main()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(16);
  vtkNew<vtkDirectionField> filter;
  filter->SetInputConnection(sphere->GetOutputPort());
  for (int degree = 1; degree <= 6; ++degree)
  {
    filter->SetDegree(degree);
    filter->Update();
    vtkDataArray* sum = filter->GetOutput()->GetFieldData()->GetArray("IndexSum");
    if (!sum || sum->GetTuple1(0) != 2 * degree)
    {
      std::cerr << "Degree " << degree << ": " << (sum ? sum->GetTuple1(0) : 0.0) << std::endl;
      return EXIT_FAILURE;
    }
  }
  std::cout << "Index sums: 2 n" << std::endl;
  return EXIT_SUCCESS;
}
