// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A picture of the glyphs on their surface against a baseline:
//
//   TestDirectionFieldGlyphsImage MESH DEGREE GLYPHS BASELINE OUTPUT [turned]
//
// MESH is "bumpy", "valley" or a PLY file, GLYPHS the type of the glyphs: Automatic, Lines, Arrows,
// Ribbons or Tubes. The picture is written to OUTPUT. With "turned" the field is turned by 10
// degrees before the glyphs are made, and the test passes if the comparison fails.

#include "Checks.h"
#include "FieldScenes.h"
#include "Pictures.h"

#include "vtkDirectionFieldGlyphs.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkPLYReader.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cstdlib>

using namespace Checks;
using namespace FieldScenes;

namespace
{
constexpr int WindowSize = 600;
constexpr Pictures::Limits Limits{ 0.25, 0.5 };

struct Scene
{
  PolyMeshes::Mesh Mesh;
  int Glyphs;
  FieldScenes::View View;
};

/// A coarse surface with a sharp valley and a sharp ridge.
PolyMeshes::Mesh Valley()
{
  return PolyMeshes::Make(
    { { -1.6, -1, 0.8 }, { -0.8, -1, 0 }, { 0, -1, 0.8 }, { 0.8, -1, 0 }, { 1.6, -1, 0.8 },
      { -1.6, 1, 0.8 }, { -0.8, 1, 0 }, { 0, 1, 0.8 }, { 0.8, 1, 0 }, { 1.6, 1, 0.8 } },
    { { 0, 1, 6 }, { 0, 6, 5 }, { 1, 2, 7 }, { 1, 7, 6 }, { 2, 3, 8 }, { 2, 8, 7 }, { 3, 4, 9 },
      { 3, 9, 8 } });
}

Scene MakeScene(const std::string& mesh)
{
  if (mesh == "bumpy")
  {
    return { BumpySphere(), 320, ViewOfBumpySphere };
  }
  if (mesh == "valley")
  {
    return { Valley(), 90, { { 0.5, -3.0, 5.0 }, { 0.0, 0.0, 0.35 }, { 0.0, 1.0, 0.0 }, 1.75 } };
  }
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(mesh.c_str());
  reader->Update();
  Scene scene = { reader->GetOutput(), 800, { {}, {}, { 0.0, 1.0, 0.0 }, 0.0 } };
  View& view = scene.View;
  double bounds[6];
  scene.Mesh->GetBounds(bounds);
  const double height = bounds[3] - bounds[2];
  for (int c = 0; c < 3; ++c)
  {
    view.FocalPoint[c] = (bounds[2 * c] + bounds[2 * c + 1]) / 2.0;
    view.Position[c] = view.FocalPoint[c];
  }
  view.Position[2] += 5.0 * height;
  view.Position[0] += 0.6 * height;
  view.Position[1] += 1.0 * height;
  view.Scale = 0.56 * height;
  return scene;
}

int TypeOf(const std::string& name)
{
  const std::vector<std::string> names = { "Automatic", "Lines", "Arrows", "Ribbons", "Tubes" };
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

vtkSmartPointer<vtkImageData> Draw(const Scene& scene, vtkPolyData* glyphs)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  AddSurface(renderer, scene.Mesh);
  auto shapes = Add(renderer, glyphs);
  shapes->GetProperty()->SetColor(0.0, 0.30, 0.40);
  shapes->GetProperty()->SetAmbient(0.3);
  shapes->GetProperty()->SetLineWidth(3.0);
  return Pictures::Draw(renderer.GetPointer(), scene.View, WindowSize);
}
}

int TestDirectionFieldGlyphsImage(int argc, char* argv[])
{
  if (argc < 6)
  {
    std::cerr << "Arguments: MESH DEGREE GLYPHS BASELINE OUTPUT [turned]" << std::endl;
    return EXIT_FAILURE;
  }
  const Scene scene = MakeScene(argv[1]);
  const int degree = std::atoi(argv[2]);
  const std::string baseline = argv[4];
  const std::string output = argv[5];
  const bool turned = argc > 6 && std::string(argv[6]) == "turned";

  const auto field = TurnedField(scene.Mesh, degree, 1e-8, turned);

  vtkNew<vtkDirectionFieldGlyphs> glyphs;
  glyphs->SetInputData(field);
  glyphs->SetGlyphType(TypeOf(argv[3]));
  glyphs->SetMaximumNumberOfGlyphs(scene.Glyphs);
  glyphs->Update();
  const double number = FieldValue(glyphs->GetOutput(), "NumberOfGlyphs");
  std::cout << number << " glyphs" << std::endl;
  CHECK(number <= scene.Glyphs);
  CHECK(number > 0.9 * scene.Glyphs);

  auto image = Draw(scene, glyphs->GetOutput());
  Pictures::CheckPicture(image, baseline, output, turned, Limits);
  return Result();
}
