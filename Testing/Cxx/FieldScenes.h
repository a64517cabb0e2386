// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What pictures of fields show.

#ifndef FieldScenes_h
#define FieldScenes_h

#include "Checks.h"

#include "vtkActor.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
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
}

#endif
