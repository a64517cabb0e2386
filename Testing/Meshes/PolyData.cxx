// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/PolyData.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <cstddef>

using DirectionFields::Index;
using DirectionFields::Surface;

namespace Meshes
{
vtkSmartPointer<vtkPolyData> ToPolyData(const Surface& surface, int precision)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(precision);
  points->SetNumberOfPoints(static_cast<vtkIdType>(surface.Points.size()));
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), surface.Points[i].data());
  }
  vtkNew<vtkCellArray> polys;
  for (const DirectionFields::Triangle& triangle : surface.Triangles)
  {
    polys->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return mesh;
}

Surface ToSurface(vtkPolyData* mesh)
{
  Surface surface;
  surface.Points.resize(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    mesh->GetPoint(static_cast<vtkIdType>(i), surface.Points[i].data());
  }
  surface.Triangles.reserve(static_cast<std::size_t>(mesh->GetNumberOfPolys()));
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
  {
    mesh->GetPolys()->GetCellAtId(t, corners);
    surface.Triangles.push_back({ static_cast<Index>(corners->GetId(0)),
      static_cast<Index>(corners->GetId(1)), static_cast<Index>(corners->GetId(2)) });
  }
  return surface;
}
}
