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

#include "vtkDirectionFieldStreamlines.h"

#include "vtkImageData.h"

#include <cstdlib>

using namespace Checks;
using namespace FieldScenes;

namespace
{
constexpr int WindowSize = 600;
constexpr Pictures::Limits Limits{ 0.25, 0.5 };

vtkSmartPointer<vtkImageData> Draw(vtkPolyData* mesh, vtkPolyData* lines)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  AddSurface(renderer, mesh);
  auto drawn = Add(renderer, lines);
  drawn->GetProperty()->SetColor(0.0, 0.30, 0.40);
  drawn->GetProperty()->LightingOff();
  drawn->GetProperty()->SetLineWidth(2.0);
  return Pictures::Draw(renderer.GetPointer(), ViewOfBumpySphere, WindowSize);
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
  const auto field = TurnedField(mesh, degree, 1e-10, turned);

  vtkNew<vtkDirectionFieldStreamlines> lines;
  lines->SetInputData(field);
  lines->SetSeedType(seeds == "Evenly" ? vtkDirectionFieldStreamlines::EVENLY_SPACED
                                       : vtkDirectionFieldStreamlines::SINGULARITIES);
  lines->SetStopAtCrossings(seeds == "Graph");
  lines->SetMaximumStreamlineLength(seeds == "Singularities" ? 4.0 : 0.0);
  lines->Update();
  vtkPolyData* output = lines->GetOutput(0);
  const double length = TotalLength(output);
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
