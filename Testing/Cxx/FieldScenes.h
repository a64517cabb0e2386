// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The scenes that pictures of fields show.

#ifndef FieldScenes_h
#define FieldScenes_h

#include "Checks.h"

#include "vtkDirectionField.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <cstddef>

namespace FieldScenes
{
/// A sphere with bumps and hollows.
inline PolyMeshes::Mesh BumpySphere()
{
  auto mesh = PolyMeshes::Icosphere(4);
  vtkPoints* points = mesh->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    const double bump = 1.0 +
      0.09 * std::sin(4.0 * p[0] + 1.0) * std::sin(4.0 * p[1] + 0.5) * std::cos(4.0 * p[2]) +
      0.05 * p[0];
    points->SetPoint(i, bump * p[0], bump * p[1], bump * p[2]);
  }
  return mesh;
}

/// Turns all directions about the normals.
inline void Turn(vtkPolyData* field, int degree, double angle)
{
  const auto normals = Checks::Normals(field);
  for (int k = 0; k < degree; ++k)
  {
    vtkDataArray* direction = Checks::Direction(field, k);
    for (vtkIdType i = 0; i < direction->GetNumberOfTuples(); ++i)
    {
      double d[3], side[3];
      direction->GetTuple(i, d);
      vtkMath::Cross(normals[static_cast<std::size_t>(i)].data(), d, side);
      for (int c = 0; c < 3; ++c)
      {
        direction->SetComponent(i, c, std::cos(angle) * d[c] + std::sin(angle) * side[c]);
      }
    }
  }
}

/// A field to the given tolerance, turned by 10 degrees where a picture is to differ.
inline vtkSmartPointer<vtkPolyData> TurnedField(
  vtkPolyData* mesh, int degree, double tolerance, bool turned)
{
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(mesh);
  filter->SetDegree(degree);
  filter->SetTolerance(tolerance);
  filter->SetMaximumIterations(2000);
  filter->Update();
  auto field = vtkSmartPointer<vtkPolyData>::New();
  field->DeepCopy(filter->GetOutput());
  Turn(field, degree, turned ? vtkMath::RadiansFromDegrees(10.0) : 0.0);
  return field;
}

/// The sum of the lengths that lines have as cell data.
inline double TotalLength(vtkPolyData* lines)
{
  vtkDataArray* lengths = lines->GetCellData()->GetArray("Length");
  double total = 0.0;
  for (vtkIdType i = 0; lengths && i < lengths->GetNumberOfTuples(); ++i)
  {
    total += lengths->GetTuple1(i);
  }
  return total;
}

/// Where a surface is seen from.
struct View
{
  double Position[3];
  double FocalPoint[3];
  double ViewUp[3];
  /// Half the height of the view.
  double Scale;
};

constexpr View ViewOfBumpySphere{ { 4.0, -6.0, 3.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, 1.13 };

/// Adds a shape without colors.
inline vtkSmartPointer<vtkActor> Add(vtkRenderer* renderer, vtkPolyData* shape)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shape);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  return actor;
}

/// Adds a quiet surface from which glyphs and lines on it stand out.
inline void AddSurface(vtkRenderer* renderer, vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SetFeatureAngle(40.0);
  normals->Update();
  auto surface = Add(renderer, normals->GetOutput());
  surface->GetProperty()->SetColor(0.93, 0.91, 0.87);
  surface->GetProperty()->SetAmbient(0.15);
  surface->GetProperty()->SetDiffuse(0.85);
}
}

#endif
