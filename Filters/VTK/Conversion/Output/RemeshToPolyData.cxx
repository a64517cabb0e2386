// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Output/RemeshToPolyData.h"

#include "Conversion/Input/FieldArrays.h"
#include "Conversion/Output/FieldToPolyData.h"
#include "Conversion/Output/InterpolatedData.h"

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

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
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

/// The number of edges at each point, and whether it is on the boundary.
struct Valences
{
  explicit Valences(const RemeshResult& mesh)
    : Edges(mesh.Points.size(), 0)
    , IsBoundary(mesh.Points.size(), 0)
  {
    // An edge of one face only has its ends on the boundary.
    std::vector<std::array<Index, 2>> edges;
    for (const std::array<Index, 4>& face : mesh.Faces)
    {
      for (int c = 0; c < SizeOf(face); ++c)
      {
        const Index a = face[c];
        const Index b = face[(c + 1) % SizeOf(face)];
        edges.push_back({ std::min(a, b), std::max(a, b) });
      }
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size();)
    {
      std::size_t end = i;
      while (end < edges.size() && edges[end] == edges[i])
      {
        ++end;
      }
      for (const Index v : edges[i])
      {
        ++this->Edges[v];
        this->IsBoundary[v] = this->IsBoundary[v] != 0 || end - i == 1 ? 1 : 0;
      }
      i = end;
    }
  }

  std::vector<int> Edges;
  std::vector<char> IsBoundary;
};

/// The least sine of an angle of a face, with the sign of its side: 1 for a square, and, as by
/// Verdict, for an even triangle, too.
double ScaledJacobian(const RemeshResult& mesh, const std::array<Index, 4>& face)
{
  const int size = SizeOf(face);
  const double even = size == 4 ? 1.0 : 2.0 / std::sqrt(3.0);
  std::array<Vector3, 4> normals;
  std::array<double, 4> lengths;
  Vector3 sum = Vector3::Zero();
  for (int c = 0; c < size; ++c)
  {
    const Vector3& at = mesh.Points[face[c]];
    const Vector3 next = mesh.Points[face[(c + 1) % size]] - at;
    const Vector3 last = mesh.Points[face[(c + size - 1) % size]] - at;
    normals[c] = next.cross(last);
    lengths[c] = next.norm() * last.norm();
    sum += normals[c];
  }
  const Vector3 normal = sum.stableNormalized();
  double least = 1.0;
  for (int c = 0; c < size; ++c)
  {
    least = std::min(least, lengths[c] > 0.0 ? even * normals[c].dot(normal) / lengths[c] : 0.0);
  }
  return least;
}

template <typename ArrayT>
void AddNumber(const char* name, typename ArrayT::ValueType value, vtkFieldData* data)
{
  auto array = MakeArray<ArrayT>(name, 1, 1);
  array->SetValue(0, value);
  data->AddArray(array);
}
}

double AddMesh(vtkPolyData* input, const TriangulatedPolyData& surface, const RemeshResult& mesh,
  vtkPolyData* output)
{
  const int type = input->GetPoints() ? input->GetPoints()->GetDataType() : VTK_FLOAT;
  output->SetPoints(MakePoints(mesh.Points, type));
  vtkNew<vtkCellArray> cells;
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
  CopyCellData(input, surface, mesh.FaceSource, output->GetCellData());

  std::vector<int> kind(mesh.Kind.size());
  std::transform(mesh.Kind.begin(), mesh.Kind.end(), kind.begin(),
    [](VertexKind k) { return static_cast<int>(k); });
  output->GetPointData()->AddArray(MakeScalars<vtkSignedCharArray>("VertexKind", kind));
  output->GetPointData()->AddArray(MakeScalars<vtkIntArray>("FieldIndex", mesh.FieldIndex));
  output->GetCellData()->AddArray(MakeScalars<vtkSignedCharArray>("Regular", mesh.Regular));
  std::vector<double> quality;
  quality.reserve(mesh.Faces.size());
  for (const std::array<Index, 4>& face : mesh.Faces)
  {
    quality.push_back(ScaledJacobian(mesh, face));
  }
  output->GetCellData()->AddArray(MakeScalars<vtkFloatArray>("ScaledJacobian", quality));

  vtkFieldData* data = output->GetFieldData();
  AddNumber<vtkIntArray>("Faces", static_cast<int>(mesh.Faces.size()), data);
  AddNumber<vtkIntArray>("Quads", mesh.Quads, data);
  AddNumber<vtkIntArray>("Triangles", mesh.Triangles, data);
  AddNumber<vtkIntArray>("IrregularVertices", mesh.IrregularVertices, data);
  AddNumber<vtkIntArray>("KeptVertices", mesh.KeptVertices, data);
  AddNumber<vtkIntArray>("FlippedTriangles", mesh.FlippedTriangles, data);
  AddNumber<vtkDoubleArray>("EdgeLength", mesh.EdgeLength, data);
  AddNumber<vtkDoubleArray>("MaximumDistance", mesh.MaximumDistance, data);
  auto euler = MakeArray<vtkIntArray>("EulerCharacteristic", 2, 1);
  euler->SetComponentName(0, "Input");
  euler->SetComponentName(1, "Output");
  euler->SetTypedComponent(0, 0, mesh.EulerCharacteristicBefore);
  euler->SetTypedComponent(0, 1, mesh.EulerCharacteristicAfter);
  data->AddArray(euler);
  return quality.empty() ? 1.0 : *std::min_element(quality.begin(), quality.end());
}

void AddIrregularVertices(
  const RemeshResult& mesh, int degree, int pointDataType, vtkPolyData* output)
{
  const Valences valences(mesh);
  std::vector<Vector3> places;
  std::vector<int> valence;
  std::vector<int> index;
  std::vector<int> missing;
  std::vector<double> size;
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    if (valences.IsBoundary[v] == 0 && valences.Edges[v] != degree)
    {
      places.push_back(mesh.Points[v]);
      valence.push_back(valences.Edges[v]);
      index.push_back(mesh.FieldIndex[v]);
      missing.push_back(degree - valences.Edges[v]);
      size.push_back(SizeOfBall * mesh.EdgeLength * std::abs(missing.back()));
    }
  }
  SetVertices(places, pointDataType, output);
  output->GetPointData()->SetScalars(MakeScalars<vtkIntArray>("Valence", valence));
  output->GetPointData()->AddArray(MakeScalars<vtkIntArray>("FieldIndex", index));
  output->GetPointData()->AddArray(MakeScalars<vtkIntArray>("MissingEdges", missing));
  output->GetPointData()->AddArray(MakeScalars<vtkFloatArray>("Size", size));
}
}
