// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A picture of stripes against a baseline:
//
//   TestStripePatternImage DEGREE DIRECTION BASELINE OUTPUT [turned]
//
// DIRECTION is Along or Across. The picture is written to OUTPUT. With "turned" the field is turned by 10
// degrees before, and the test passes if the comparison fails.

#include "Checks.h"
#include "FieldScenes.h"
#include "Pictures.h"

#include "vtkStripePattern.h"

#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkMassProperties.h"
#include "vtkTriangleFilter.h"

#include <cstdlib>

using namespace Checks;
using namespace FieldScenes;

namespace
{
constexpr int WindowSize = 600;
constexpr Pictures::Limits Limits{ 0.5, 3.0 };

vtkSmartPointer<vtkImageData> Draw(vtkPolyData* bands, vtkPolyData* lines)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  vtkNew<vtkLookupTable> colors;
  colors->SetNumberOfTableValues(2);
  colors->SetTableValue(0, 0.93, 0.91, 0.87);
  colors->SetTableValue(1, 0.24, 0.58, 0.62);
  auto surface = Add(renderer, bands);
  surface->GetMapper()->SetLookupTable(colors);
  surface->GetMapper()->SetScalarRange(0.0, 1.0);
  surface->GetMapper()->SetScalarModeToUseCellData();
  surface->GetMapper()->ScalarVisibilityOn();
  surface->GetProperty()->SetAmbient(0.15);
  surface->GetProperty()->SetDiffuse(0.85);
  auto drawn = Add(renderer, lines);
  drawn->GetProperty()->SetColor(0.0, 0.24, 0.30);
  drawn->GetProperty()->SetLineWidth(3.0);
  drawn->GetProperty()->RenderLinesAsTubesOn();
  return Pictures::Draw(renderer.GetPointer(), ViewOfBumpySphere, WindowSize);
}
}

int TestStripePatternImage(int argc, char* argv[])
{
  if (argc < 5)
  {
    std::cerr << "Arguments: DEGREE DIRECTION BASELINE OUTPUT [turned]" << std::endl;
    return EXIT_FAILURE;
  }
  const int degree = std::atoi(argv[1]);
  const bool turned = argc > 5 && std::string(argv[5]) == "turned";
  const auto field = TurnedField(BumpySphere(), degree, 1e-10, turned);

  vtkNew<vtkStripePattern> stripes;
  stripes->SetInputData(field);
  stripes->SetStripeDirection(std::string(argv[2]) == "Along" ? vtkStripePattern::ALONG_FIELD
                                                              : vtkStripePattern::ACROSS_FIELD);
  stripes->Update();
  vtkPolyData* lines = stripes->GetOutput(0);
  const double length = TotalLength(lines);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(stripes->GetOutput(1));
  vtkNew<vtkMassProperties> properties;
  properties->SetInputConnection(triangles->GetOutputPort());
  const double share = length * FieldValue(lines, "Spacing") / properties->GetSurfaceArea();
  std::cout << lines->GetNumberOfLines() << " lines, length times spacing over area " << share
            << ", misfit " << FieldValue(lines, "Misfit") << ", branch points "
            << FieldValue(lines, "BranchPoints") << std::endl;
  CHECK(std::abs(share - 1.0) < 0.06);
  CHECK(FieldValue(lines, "Misfit") < 0.25);
  auto image = Draw(stripes->GetOutput(1), lines);
  Pictures::CheckPicture(image, argv[3], argv[4], turned, Limits);
  return Result();
}
