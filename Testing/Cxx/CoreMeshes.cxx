// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CoreMeshes.h"

#include "Meshes/Surfaces.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

namespace CoreMeshes
{
namespace
{
vtkSmartPointer<vtkPolyData> Convert(const DirectionFields::Surface& surface)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& point : surface.Points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> polys;
  for (const auto& triangle : surface.Triangles)
  {
    polys->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return mesh;
}
}

vtkSmartPointer<vtkPolyData> Make(const std::string& name)
{
  if (name == "disk")
  {
    return Convert(Meshes::FourfoldDisk(7));
  }
  if (name == "icosahedron")
  {
    return Convert(Meshes::FlatlySubdivided(Meshes::Icosahedron(), 2));
  }
  return nullptr;
}
}
