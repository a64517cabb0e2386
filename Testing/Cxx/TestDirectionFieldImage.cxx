// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A picture of the field against a baseline:
//
//   TestDirectionFieldImage MESH DEGREE BASELINE OUTPUT [boundary|sharp|curvature] [turned]
//
// MESH is "pebble", "torus", "disk", "icosahedron" or a PLY file. The picture is written to OUTPUT.
// "boundary" and "sharp" constrain the field to the boundary and to sharp edges, "curvature" aligns
// it. With "turned" the field is turned by 10 degrees before it is drawn, and the test passes if
// the comparison fails.

#include "Checks.h"
#include "Meshes/PolyData.h"
#include "Meshes/Surfaces.h"
#include "Pictures.h"

#include "vtkDirectionField.h"

#include "vtkActor.h"
#include "vtkGlyph3D.h"
#include "vtkImageData.h"
#include "vtkPLYReader.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <cstdlib>
#include <set>

using namespace Checks;

namespace
{
constexpr int WindowSize = 400;
constexpr Pictures::Limits Limits{ 0.5, 1.0 };

struct Scene
{
  PolyMeshes::Mesh Mesh;
  double Position[3];
  double FocalPoint[3];
  double ViewUp[3];
  /// Half the height of the view.
  double Scale;
};

Scene MakeScene(const std::string& mesh)
{
  if (mesh == "pebble")
  {
    return { PolyMeshes::Pebble(2), { 4.0, -6.0, 3.0 }, { 0.15, 0.0, 0.0 }, { 0.0, 0.0, 1.0 },
      1.12 };
  }
  if (mesh == "torus")
  {
    return { PolyMeshes::QuadTorus(28, 12), { 2.0, -3.0, 6.0 }, { 0.0, 0.0, 0.0 },
      { 0.0, 1.0, 0.0 }, 1.55 };
  }
  if (mesh == "disk")
  {
    // It has the symmetries of the square.
    return { Meshes::ToPolyData(Meshes::FourfoldDisk(7)), { 0.0, 0.0, 5.0 }, { 0.0, 0.0, 0.0 },
      { 0.0, 1.0, 0.0 }, 1.05 };
  }
  if (mesh == "icosahedron")
  {
    return { Meshes::ToPolyData(Meshes::FlatlySubdivided(Meshes::Icosahedron(), 2)),
      { 2.0, 2.5, 4.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, 1.06 };
  }
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(mesh.c_str());
  reader->Update();
  Scene scene = { reader->GetOutput(), {}, {}, { 0.0, 1.0, 0.0 }, 0.0 };
  // The view shows a part of the side, from near enough to see the glyphs.
  double bounds[6];
  scene.Mesh->GetBounds(bounds);
  const double height = bounds[3] - bounds[2];
  for (int c = 0; c < 3; ++c)
  {
    scene.FocalPoint[c] = (bounds[2 * c] + bounds[2 * c + 1]) / 2.0;
    scene.Position[c] = scene.FocalPoint[c];
  }
  scene.Position[2] += 5.0 * height;
  scene.Position[0] += 1.0 * height;
  scene.Scale = 0.15 * height;
  return scene;
}

/// Thick blades in all n directions at every point, or an arrow for n = 1, a little above the
/// surface.
vtkSmartPointer<vtkPolyData> MakeGlyphs(vtkPolyData* field, int degree, double turn)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(field);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  const auto normals = Normals(triangles->GetOutput());

  // The shortest edge at each point: no glyph reaches another.
  std::vector<double> size(normals.size(), 0.0);
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < triangles->GetOutput()->GetNumberOfPolys(); ++t)
  {
    triangles->GetOutput()->GetCellPoints(t, ids);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      double a[3], b[3];
      const vtkIdType i = ids->GetId(k);
      const vtkIdType j = ids->GetId((k + 1) % 3);
      field->GetPoint(i, a);
      field->GetPoint(j, b);
      const double length = std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
      for (const vtkIdType end : { i, j })
      {
        double& shortest = size[static_cast<size_t>(end)];
        shortest = shortest == 0.0 ? length : std::min(shortest, length);
      }
    }
  }

  // Convex polygons: along the direction and to its left, in units of the size.
  using Corners = std::vector<std::array<double, 2>>;
  const std::vector<Corners> arrow = {
    { { -0.5, -0.14 }, { 0.05, -0.14 }, { 0.05, 0.14 }, { -0.5, 0.14 } },
    { { 0.05, -0.32 }, { 0.55, 0.0 }, { 0.05, 0.32 } },
  };
  const std::vector<Corners> blade = {
    { { 0.0, -0.1 }, { 0.5, -0.1 }, { 0.5, 0.1 }, { 0.0, 0.1 } },
  };
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polys;
  for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
  {
    const auto index = static_cast<size_t>(i);
    const double* normal = normals[index].data();
    double center[3];
    field->GetPoint(i, center);
    for (int k = 0; k < degree; ++k)
    {
      double d[3], side[3];
      Direction(field, k)->GetTuple(i, d);
      vtkMath::Cross(normal, d, side);
      for (const Corners& polygon : degree == 1 ? arrow : blade)
      {
        vtkNew<vtkIdList> corners;
        for (const auto& corner : polygon)
        {
          const double along = corner[0] * std::cos(turn) - corner[1] * std::sin(turn);
          const double left = corner[0] * std::sin(turn) + corner[1] * std::cos(turn);
          double p[3];
          for (int c = 0; c < 3; ++c)
          {
            p[c] = center[c] + size[index] * (along * d[c] + left * side[c] + 0.1 * normal[c]);
          }
          corners->InsertNextId(points->InsertNextPoint(p));
        }
        polys->InsertNextCell(corners);
      }
    }
  }
  auto glyphs = vtkSmartPointer<vtkPolyData>::New();
  glyphs->SetPoints(points);
  glyphs->SetPolys(polys);
  return glyphs;
}

/// Balls, red for positive and blue for negative indices.
vtkSmartPointer<vtkPolyData> MakeBalls(vtkPolyData* singularities, double radius)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("colors");
  colors->SetNumberOfComponents(3);
  vtkDataArray* index = singularities->GetPointData()->GetArray("SingularityIndex");
  for (vtkIdType i = 0; i < singularities->GetNumberOfPoints(); ++i)
  {
    const bool positive = index->GetTuple1(i) > 0.0;
    const unsigned char color[3] = { static_cast<unsigned char>(positive ? 255 : 0), 0,
      static_cast<unsigned char>(positive ? 0 : 255) };
    colors->InsertNextTypedTuple(color);
  }
  vtkNew<vtkPolyData> colored;
  colored->ShallowCopy(singularities);
  colored->GetPointData()->SetScalars(colors);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(radius);
  ball->SetThetaResolution(16);
  ball->SetPhiResolution(12);
  vtkNew<vtkGlyph3D> glyph;
  glyph->SetInputData(colored);
  glyph->SetSourceConnection(ball->GetOutputPort());
  glyph->ScalingOff();
  glyph->OrientOff();
  glyph->SetColorModeToColorByScalar();
  glyph->Update();
  return glyph->GetOutput();
}

void Add(vtkRenderer* renderer, vtkPolyData* shape, double gray, bool lit)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shape);
  if (shape->GetPointData()->GetScalars() &&
    std::string(shape->GetPointData()->GetScalars()->GetName()) != "colors")
  {
    mapper->ScalarVisibilityOff();
  }
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(gray, gray, gray);
  actor->GetProperty()->SetLighting(lit);
  actor->GetProperty()->SetInterpolationToFlat();
  renderer->AddActor(actor);
}

vtkSmartPointer<vtkImageData> Draw(const Scene& scene, vtkDirectionField* filter, double turn)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.45, 0.5, 0.6);
  Add(renderer, filter->GetOutput(), 1.0, false);
  Add(renderer, MakeGlyphs(filter->GetOutput(), filter->GetDegree(), turn), 0.0, false);
  Add(renderer, MakeBalls(filter->GetOutput(1), 0.045 * scene.Scale), 1.0, false);
  return Pictures::Draw(renderer.GetPointer(), scene, WindowSize);
}

/// The field is as constrained and as aligned as the options say.
void CheckOptions(vtkPolyData* field, int degree, const std::set<std::string>& options)
{
  vtkDataArray* kind = field->GetPointData()->GetArray("ConstraintKind");
  const bool constrained = options.count("boundary") + options.count("sharp") > 0;
  REQUIRE((kind != nullptr) == constrained);
  vtkIdType count = 0;
  double worst = 0.0;
  for (vtkIdType i = 0; kind && i < field->GetNumberOfPoints(); ++i)
  {
    if (kind->GetTuple1(i) > 0.0)
    {
      CHECK(kind->GetTuple1(i) == (options.count("boundary") ? 1.0 : 2.0));
      double given[3], d[3];
      field->GetPointData()->GetArray("ConstraintDirection")->GetTuple(i, given);
      double nearest = PolyMeshes::Pi;
      for (int k = 0; k < degree; ++k)
      {
        Direction(field, k)->GetTuple(i, d);
        nearest = std::min(nearest, vtkMath::AngleBetweenVectors(given, d));
      }
      worst = std::max(worst, vtkMath::DegreesFromRadians(nearest));
      ++count;
    }
  }
  CHECK(!constrained || count > 20);
  CHECK(worst < 0.1);

  vtkDataArray* principal = field->GetPointData()->GetArray("PrincipalDirection0");
  REQUIRE((principal != nullptr) == (options.count("curvature") > 0));
  std::vector<double> angles;
  for (vtkIdType i = 0; principal && i < field->GetNumberOfPoints(); ++i)
  {
    double wanted[3], d[3];
    principal->GetTuple(i, wanted);
    double nearest = PolyMeshes::Pi;
    for (int k = 0; k < degree; ++k)
    {
      Direction(field, k)->GetTuple(i, d);
      nearest = std::min(nearest, vtkMath::AngleBetweenVectors(wanted, d));
    }
    angles.push_back(vtkMath::DegreesFromRadians(nearest));
  }
  std::sort(angles.begin(), angles.end());
  CHECK(angles.empty() || angles[angles.size() / 2] < 5.0);
}
}

int TestDirectionFieldImage(int argc, char* argv[])
{
  if (argc < 5)
  {
    std::cerr << "Arguments: MESH DEGREE BASELINE OUTPUT [OPTION]..." << std::endl;
    return EXIT_FAILURE;
  }
  const Scene scene = MakeScene(argv[1]);
  const int degree = std::atoi(argv[2]);
  const std::string baseline = argv[3];
  const std::string output = argv[4];
  const std::set<std::string> options(argv + 5, argv + argc);
  const bool turned = options.count("turned") > 0;

  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(scene.Mesh);
  filter->SetDegree(degree);
  // The eigenvalue of a plane vanishes, and there is no finer residual relative to it.
  filter->SetTolerance(std::string(argv[1]) == "disk" ? 1e-6 : 1e-9);
  filter->SetConstrainBoundary(options.count("boundary") > 0);
  filter->SetConstrainSharpEdges(options.count("sharp") > 0);
  if (options.count("curvature") > 0)
  {
    filter->SetAlignment(vtkDirectionField::ALIGN_PRINCIPAL_CURVATURE);
  }
  filter->Update();
  vtkPolyData* field = filter->GetOutput();
  CHECK(field->GetNumberOfPoints() > 100);
  CHECK(FieldValue(field, "IndexSum") == SumOfIndices(field->GetCellData()));
  CHECK(SumOfIndices(filter->GetOutput(1)->GetPointData()) == FieldValue(field, "IndexSum"));
  if (FieldValue(field, "EulerCharacteristic") != 1.0)
  {
    CHECK(FieldValue(field, "IndexSum") == degree * FieldValue(field, "EulerCharacteristic"));
  }
  else
  {
    // Only the disk has this Euler characteristic.
    CHECK(FieldValue(field, "IndexSum") == (options.count("boundary") > 0 ? degree : 0));
  }
  CheckOptions(field, degree, options);
  for (int k = 0; k < degree; ++k)
  {
    for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
    {
      CHECK(std::abs(vtkMath::Norm(Direction(field, k)->GetTuple3(i)) - 1.0) < 1e-6);
    }
  }

  auto image = Draw(scene, filter, turned ? vtkMath::RadiansFromDegrees(10.0) : 0.0);
  Pictures::CheckPicture(image, baseline, output, turned, Limits);
  return Result();
}
