// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Output/RemeshToPolyData.h"

#include "Conversion/Input/FieldArrays.h"
#include "Conversion/Output/FieldToPolyData.h"
#include "Conversion/Output/InterpolatedData.h"

#include <DirectionFields/Reports/RemeshReports.h>

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSignedCharArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

namespace DirectionFields
{
namespace
{
/// The diameter of the ball that shows a vertex of one edge more or less, in edges: it is seen, and
/// hides less than the faces around it.
constexpr double SizeOfBall = 1.2;

int SizeOf(const std::array<Index, 4>& face)
{
  return face[3] == None ? 3 : 4;
}

template <typename ArrayT>
void AddNumber(const char* name, typename ArrayT::ValueType value, vtkFieldData* data)
{
  auto array = MakeArray<ArrayT>(name, 1, 1);
  array->SetValue(0, value);
  data->AddArray(array);
}
}

void AddMesh(vtkPolyData* input, const TriangulatedPolyData& surface, const RemeshResult& mesh,
  vtkPolyData* output)
{
  const int type = input->GetPoints() ? input->GetPoints()->GetDataType() : VTK_FLOAT;
  output->SetPoints(MakePoints(mesh.Points, type));
  vtkNew<vtkCellArray> cells;
  RequireMemoryToGrow(5 * sizeof(vtkIdType) * mesh.Faces.size());
  for (const std::array<Index, 4>& face : mesh.Faces)
  {
    const std::array<vtkIdType, 4> ids = { face[0], face[1], face[2], face[3] };
    cells->InsertNextCell(SizeOf(face), ids.data());
  }
  output->SetPolys(cells);
  InterpolatePointData(
    input, mesh.Points.size(),
    [&](std::size_t v) {
      return WeightedPoints(surface.Mesh.Triangles[mesh.SourceTriangle[v]], mesh.SourceWeights[v]);
    },
    output->GetPointData());

  std::vector<int> kind(mesh.Kind.size());
  std::transform(mesh.Kind.begin(), mesh.Kind.end(), kind.begin(),
    [](VertexKind k) { return static_cast<int>(k); });
  output->GetPointData()->AddArray(MakeScalars<vtkSignedCharArray>("VertexKind", kind));
  output->GetPointData()->AddArray(MakeScalars<vtkIntArray>("FieldIndex", mesh.FieldIndex));
  output->GetCellData()->AddArray(MakeScalars<vtkSignedCharArray>("Regular", mesh.Regular));

  vtkFieldData* data = output->GetFieldData();
  AddNumber<vtkIntArray>("Faces", static_cast<int>(mesh.Faces.size()), data);
  AddNumber<vtkIntArray>("Quads", mesh.Quads, data);
  AddNumber<vtkIntArray>("Triangles", mesh.Triangles, data);
  AddNumber<vtkIntArray>("IrregularVertices", mesh.IrregularVertices, data);
  AddNumber<vtkIntArray>("KeptVertices", mesh.KeptVertices, data);
  AddNumber<vtkIntArray>("FlippedTriangles", mesh.FlippedTriangles, data);
  AddNumber<vtkIntArray>("TurnedFaces", mesh.TurnedFaces, data);
  AddNumber<vtkDoubleArray>("EdgeLength", mesh.EdgeLength, data);
  AddNumber<vtkDoubleArray>("MaximumDistance", mesh.MaximumDistance, data);
  AddNumber<vtkDoubleArray>("MaximumDistanceToMesh", mesh.MaximumDistanceToMesh, data);
  if (mesh.IsSized)
  {
    AddNumber<vtkDoubleArray>("EdgesAsWanted", mesh.EdgesAsWanted, data);
    if (mesh.ErrorOfSizes > 0.0)
    {
      AddNumber<vtkDoubleArray>("ErrorOfSizes", mesh.ErrorOfSizes, data);
    }
  }
  const BoundaryFigures& boundary = mesh.Boundary;
  if (boundary.Kept + boundary.Others > 0)
  {
    AddNumber<vtkIntArray>("BoundaryPoints", boundary.Points, data);
    AddNumber<vtkIntArray>("BoundaryPointsKept", boundary.Kept, data);
  }
  else if (boundary.Points > 0)
  {
    AddNumber<vtkDoubleArray>("BoundaryUnevenness", boundary.Unevenness, data);
  }
  if (!mesh.Regions.empty())
  {
    const RegionFigures& shown = mesh.RegionsShown;
    AddNumber<vtkIntArray>("Regions", shown.Regions, data);
    AddNumber<vtkIntArray>("RegionsLost", static_cast<int>(shown.Lost.size()), data);
    AddNumber<vtkDoubleArray>("BordersKept", shown.BordersKept, data);
    AddNumber<vtkIntArray>("CornersMissed", shown.MissedCorners, data);
    AddNumber<vtkDoubleArray>("LargestAreaError", shown.LargestAreaError, data);
  }
  auto euler = MakeArray<vtkIntArray>("EulerCharacteristic", 2, 1);
  euler->SetComponentName(0, "Input");
  euler->SetComponentName(1, "Output");
  euler->SetTypedComponent(0, 0, mesh.EulerCharacteristicBefore);
  euler->SetTypedComponent(0, 1, mesh.EulerCharacteristicAfter);
  data->AddArray(euler);
}

void AddQuality(const FaceQuality& quality, const QualityReport& judged, vtkPolyData* output)
{
  vtkCellData* const cells = output->GetCellData();
  cells->AddArray(MakeScalars<vtkFloatArray>("ScaledJacobian", quality.ScaledJacobian));
  cells->AddArray(MakeScalars<vtkFloatArray>("AspectRatio", quality.AspectRatio));
  cells->AddArray(MakeScalars<vtkFloatArray>("Warpage", quality.Warpage));
  vtkFieldData* const data = output->GetFieldData();
  AddNumber<vtkDoubleArray>("LeastScaledJacobian", judged.LeastScaledJacobian, data);
  AddNumber<vtkDoubleArray>("MeanScaledJacobian", judged.MeanScaledJacobian, data);
  AddNumber<vtkDoubleArray>("LargestAspectRatio", judged.LargestAspectRatio, data);
  AddNumber<vtkDoubleArray>("LargestWarpage", judged.LargestWarpage, data);
  if (judged.IsLimited)
  {
    cells->AddArray(MakeScalars<vtkSignedCharArray>("Pass", judged.Pass));
    AddNumber<vtkIntArray>("FailedFaces", judged.FailedFaces, data);
    AddNumber<vtkIntArray>("Pass", judged.FailedFaces == 0 ? 1 : 0, data);
  }
}

void AddIrregularVertices(
  const RemeshResult& mesh, int degree, int pointDataType, vtkPolyData* output)
{
  std::vector<Vector3> places;
  std::vector<int> valence;
  std::vector<int> index;
  std::vector<int> missing;
  std::vector<double> size;
  for (const IrregularVertex& vertex : IrregularVertices(mesh, degree))
  {
    places.push_back(mesh.Points[vertex.Point]);
    valence.push_back(vertex.Edges);
    index.push_back(mesh.FieldIndex[vertex.Point]);
    missing.push_back(degree - vertex.Edges);
    size.push_back(SizeOfBall * mesh.EdgeLength * std::abs(missing.back()));
  }
  SetVertices(places, pointDataType, output);
  output->GetPointData()->SetScalars(MakeScalars<vtkIntArray>("Valence", valence));
  output->GetPointData()->AddArray(MakeScalars<vtkIntArray>("FieldIndex", index));
  output->GetPointData()->AddArray(MakeScalars<vtkIntArray>("MissingEdges", missing));
  output->GetPointData()->AddArray(MakeScalars<vtkFloatArray>("Size", size));
}
}
