// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A picture of lines on their surface against a baseline:
//
//   TestDirectionFieldStreamlinesImage DEGREE SEEDS BASELINE OUTPUT [turned]
//
// SEEDS is Evenly, Singularities or Graph. The picture is written to OUTPUT. With "turned" the field is
// turned by 10 degrees before the lines are traced, and the test passes if the comparison fails.

#include "Checks.h"
#include "FieldScenes.h"
#include "Pictures.h"

#include "vtkDirectionField.h"
#include "vtkDirectionFieldStreamlines.h"

#include "vtkImageData.h"
#include "vtkPolyDataNormals.h"

#include <cstdlib>

using namespace Checks;
using namespace FieldScenes;

namespace
{
constexpr int WindowSize = 600;
constexpr Pictures::Limits Limits{ 0.25, 0.5 };

struct Scene
{
  double Position[3];
  double FocalPoint[3];
  double ViewUp[3];
  /// Half the height of the view.
  double Scale;
};

vtkSmartPointer<vtkImageData> Draw(vtkPolyData* mesh, vtkPolyData* lines)
{
  const Scene scene = { { 4.0, -6.0, 3.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, 1.13 };
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->Update();
  auto surface = Add(renderer, normals->GetOutput());
  surface->GetProperty()->SetColor(0.93, 0.91, 0.87);
  surface->GetProperty()->SetAmbient(0.15);
  surface->GetProperty()->SetDiffuse(0.85);
  auto drawn = Add(renderer, lines);
  drawn->GetProperty()->SetColor(0.0, 0.30, 0.40);
  drawn->GetProperty()->LightingOff();
  drawn->GetProperty()->SetLineWidth(2.0);
  return Pictures::Draw(renderer.GetPointer(), scene, WindowSize);
}
}

int TestDirectionFieldStreamlinesImage(int argc, char* argv[])
{
  if (argc < 5)
  {
    std::cerr << "Arguments: DEGREE SEEDS BASELINE OUTPUT [turned]" << std::endl;
    return EXIT_FAILURE;
  }
  const int degree = std::atoi(argv[1]);
  const std::string seeds = argv[2];
  const bool turned = argc > 5 && std::string(argv[5]) == "turned";
  const auto mesh = BumpySphere();
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(mesh);
  filter->SetDegree(degree);
  filter->SetTolerance(1e-10);
  filter->SetMaximumIterations(2000);
  filter->Update();
  vtkNew<vtkPolyData> field;
  field->DeepCopy(filter->GetOutput());
  Turn(field, degree, turned ? vtkMath::RadiansFromDegrees(10.0) : 0.0);

  vtkNew<vtkDirectionFieldStreamlines> lines;
  lines->SetInputData(field);
  lines->SetSeedType(seeds == "Evenly" ? vtkDirectionFieldStreamlines::EVENLY_SPACED
                                       : vtkDirectionFieldStreamlines::SINGULARITIES);
  lines->SetStopAtCrossings(seeds == "Graph");
  lines->SetMaximumStreamlineLength(seeds == "Singularities" ? 4.0 : 0.0);
  lines->Update();
  vtkPolyData* output = lines->GetOutput(0);
  double length = 0.0;
  vtkDataArray* lengths = output->GetCellData()->GetArray("Length");
  for (vtkIdType i = 0; i < lengths->GetNumberOfTuples(); ++i)
  {
    length += lengths->GetTuple1(i);
  }
  std::cout << output->GetNumberOfLines() << " lines of length " << length << std::endl;
  if (seeds == "Evenly")
  {
    // So much of each family as the spacing says, nearly.
    const int families = degree % 2 == 0 ? degree / 2 : degree;
    const double whole = families * 4.0 * vtkMath::Pi() / FieldValue(output, "SeparatingDistance");
    CHECK(length > 0.8 * whole && length < 1.8 * whole);
  }
  auto image = Draw(mesh, output);
  Pictures::CheckPicture(image, argv[3], argv[4], turned, Limits);
  return Result();
}
