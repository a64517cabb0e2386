// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Output/SingularityPoints.h"

#include "Conversion/Input/FieldArrays.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace DirectionFields
{
namespace
{
/// The diameter of a ball of index 1 in parts of the diagonal of the box around the surface: large
/// enough to be seen from where the whole surface is in view.
constexpr double SizeOfDiagonal = 0.022;
/// The same in parts of the mean distance of the singularities, so that many of them, of a noisy
/// surface say, cover an eighth of it and not all.
constexpr double SizeOfSpacing = 0.4;

bool IsOwn(const Surface& mesh, Index t)
{
  return mesh.Ghost.empty() || mesh.Ghost[t] == 0;
}

/// The diameter of a ball that shows a singularity of index 1.
double BallSize(const SurfaceFigures& figures)
{
  const Index singularities = figures.Positive + figures.Negative;
  const double diagonal = figures.Diagonal();
  return diagonal == 0.0 || singularities == 0
    ? 0.0
    : diagonal * std::min(SizeOfDiagonal, SizeOfSpacing * std::sqrt(figures.Area / singularities));
}

/// The normal of a triangle on the side of its vertices' normals, which a triangle wound against
/// its neighbours or one without area does not give by itself.
Vector3 OutwardNormal(const Surface& mesh, std::size_t t, const Result& field)
{
  const Triangle& triangle = mesh.Triangles[t];
  const Triangle& vertices = field.SplitTriangles.empty() ? triangle : field.SplitTriangles[t];
  const Vector3& origin = mesh.Points[triangle[0]];
  const Vector3 normal = (mesh.Points[triangle[1]] - origin)
                           .stableNormalized()
                           .cross((mesh.Points[triangle[2]] - origin).stableNormalized())
                           .stableNormalized();
  const Vector3 outward =
    field.Normal[vertices[0]] + field.Normal[vertices[1]] + field.Normal[vertices[2]];
  if (normal.squaredNorm() < 0.5)
  {
    return outward.stableNormalized();
  }
  return normal.dot(outward) < 0.0 ? Vector3(-normal) : normal;
}
}

void MakeSingularPoints(const TriangulatedPolyData& input, const Result& field,
  const SurfaceFigures& figures, int pointDataType, vtkPolyData* singularities)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(pointDataType == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT);
  vtkNew<vtkCellArray> verts;
  auto index = MakeArray<vtkIntArray>(ArrayNames::SingularityIndex, 1, 0);
  auto fraction = MakeArray<vtkDoubleArray>("Index", 1, 0);
  auto cells = MakeArray<vtkIdTypeArray>("CellId", 1, 0);
  auto sizes = MakeArray<vtkFloatArray>("Size", 1, 0);
  auto normals = MakeArray<vtkFloatArray>("Normals", 3, 0);

  const Surface& mesh = input.Mesh;
  std::vector<Index> singular;
  for (Index t = 0; t < static_cast<Index>(field.SingularityIndex.size()); ++t)
  {
    if (field.SingularityIndex[t] != 0 && IsOwn(mesh, t))
    {
      singular.push_back(t);
    }
  }
  // Of all arrays above.
  RequireMemoryToGrow(128 * singular.size());
  const double ballSize = BallSize(figures);
  for (const Index t : singular)
  {
    const Triangle& triangle = mesh.Triangles[t];
    // Divided first: the sum of the largest coordinates would overflow.
    const Vector3 centroid = mesh.Points[triangle[0]] / 3.0 + mesh.Points[triangle[1]] / 3.0 +
      mesh.Points[triangle[2]] / 3.0;
    const vtkIdType id = points->InsertNextPoint(centroid.data());
    verts->InsertNextCell(1, &id);
    index->InsertNextValue(field.SingularityIndex[t]);
    fraction->InsertNextValue(static_cast<double>(field.SingularityIndex[t]) / field.Degree);
    cells->InsertNextValue(input.Cell(t));
    sizes->InsertNextValue(Narrowed<float>(std::abs(field.SingularityIndex[t]) * ballSize));
    normals->InsertNextTuple(OutwardNormal(mesh, t, field).data());
  }

  singularities->SetPoints(points);
  singularities->SetVerts(verts);
  vtkPointData* data = singularities->GetPointData();
  data->AddArray(index);
  data->AddArray(fraction);
  data->AddArray(cells);
  data->AddArray(sizes);
  data->SetNormals(normals);
}
}
