// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FieldToPolyData.h"

#include "Support/LargeArray.h"
#include "Support/Threads.h"
#include "Support/VectorMath.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace DirectionFields
{
namespace
{
/// The largest degree, hence the most directions that an earlier run can have left.
constexpr int MostDirections = 16;
/// Points that a thread takes at a time.
constexpr Index PieceSize = 1 << 13;
/// Points whose directions stay in the cache.
constexpr Index FewPoints = 256;

std::string DirectionName(int k)
{
  return "Direction" + std::to_string(k);
}

template <typename ArrayT>
vtkNew<ArrayT> MakeArray(const char* name, int components, size_t tuples)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  PreferLargePages(array->GetPointer(0), array->GetDataTypeSize() * components * tuples);
  return array;
}

/// What exceeds the range of the type becomes its largest value.
template <typename To, typename From>
To Narrowed(From value)
{
  if constexpr (std::is_floating_point<To>::value)
  {
    constexpr double largest = std::numeric_limits<To>::max();
    return static_cast<To>(std::clamp<double>(value, -largest, largest));
  }
  else
  {
    return static_cast<To>(value);
  }
}

/// Writes tuple i of an array of three components.
template <typename Value>
void WriteVector(const Vector3& vector, Value* values, Index i)
{
  for (int c = 0; c < 3; ++c)
  {
    values[3 * static_cast<vtkIdType>(i) + c] = static_cast<Value>(vector[c]);
  }
}

/// An array over the points; where there is none, one that an earlier run left in the input goes.
template <typename ArrayT>
void AddVectors(const char* name, const std::vector<Vector3>& vectors, vtkPointData* data)
{
  data->RemoveArray(name);
  if (!vectors.empty())
  {
    auto array = MakeArray<ArrayT>(name, 3, vectors.size());
    auto* const values = array->GetPointer(0);
    ParallelFor(static_cast<Index>(vectors.size()), PieceSize,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          WriteVector(vectors[i], values, i);
        }
      });
    data->AddArray(array);
  }
}

template <typename ArrayT, typename Value>
void AddScalars(const char* name, const std::vector<Value>& values, vtkPointData* data)
{
  data->RemoveArray(name);
  if (!values.empty())
  {
    auto array = MakeArray<ArrayT>(name, 1, values.size());
    auto* const narrowed = array->GetPointer(0);
    ParallelFor(static_cast<Index>(values.size()), PieceSize,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          narrowed[i] = Narrowed<typename ArrayT::ValueType>(values[i]);
        }
      });
    data->AddArray(array);
  }
}

/// The points of the input, then those that were split off, each with the data of its original.
void SplitPoints(const std::vector<Index>& originalPoint, vtkPolyData* output)
{
  const auto points = static_cast<vtkIdType>(originalPoint.size());
  vtkNew<vtkPoints> splitPoints;
  splitPoints->SetDataType(output->GetPoints()->GetDataType());
  splitPoints->SetNumberOfPoints(points);
  vtkNew<vtkPointData> splitData;
  // Nothing is to be left out, whatever the input's flags say.
  splitData->CopyAllOn();
  splitData->CopyAllocate(output->GetPointData(), points);
  auto originals = MakeArray<vtkIdTypeArray>("OriginalPointIds", 1, originalPoint.size());
  for (vtkIdType i = 0; i < points; ++i)
  {
    const vtkIdType original = originalPoint[i];
    splitPoints->SetPoint(i, output->GetPoint(original));
    splitData->CopyData(output->GetPointData(), original, i);
    originals->SetValue(i, original);
  }
  output->SetPoints(splitPoints);
  output->GetPointData()->ShallowCopy(splitData);
  output->GetPointData()->AddArray(originals);
}

/// Gives the polygons and strips the points of their triangles. A cell whose triangles were torn
/// apart keeps the points of the first.
/// Returns the points of which that leaves no use.
std::vector<vtkIdType> SplitCells(
  const TriangulatedPolyData& input, const Result& field, vtkPolyData* output)
{
  const vtkIdType firstPoly = output->GetNumberOfVerts() + output->GetNumberOfLines();
  const vtkIdType firstStrip = firstPoly + output->GetNumberOfPolys();
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkCellArray> strips;
  polys->DeepCopy(output->GetPolys());
  strips->DeepCopy(output->GetStrips());
  vtkNew<vtkIdList> corners;
  std::vector<char> settled;
  const size_t triangles = field.SplitTriangles.size();
  for (size_t t = 0; t < triangles;)
  {
    const vtkIdType cell = input.Cell(t);
    const bool isStrip = cell >= firstStrip;
    vtkCellArray* cells = isStrip ? strips : polys;
    const vtkIdType local = cell - (isStrip ? firstStrip : firstPoly);
    cells->GetCellAtId(local, corners);
    settled.assign(static_cast<size_t>(corners->GetNumberOfIds()), 0);
    // The triangles of a cell stand in a row.
    const size_t first = t;
    for (; t < triangles && input.Cell(t) == cell; ++t)
    {
      // Those that took no part have no points of their own.
      for (int c = 0; c < 3 && field.Component[t] != None; ++c)
      {
        // A strip may come back to a point on another sheet, but its triangles know their places.
        const size_t begin = isStrip ? t - first : 0;
        const size_t end = isStrip ? begin + 3 : settled.size();
        for (size_t k = begin; k < end; ++k)
        {
          const auto place = static_cast<vtkIdType>(k);
          if (!settled[k] && corners->GetId(place) == input.Mesh.Triangles[t][c])
          {
            settled[k] = 1;
            corners->SetId(place, field.SplitTriangles[t][c]);
          }
        }
      }
    }
    cells->ReplaceCellAtId(local, corners);
  }
  output->SetPolys(polys);
  output->SetStrips(strips);
  // Versions of VTK that copied the input's copied what does not know the new points.
  output->DeleteLinks();

  std::vector<char> used(field.OriginalPoint.size(), 0);
  for (vtkCellArray* cells : { polys.Get(), strips.Get() })
  {
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      cells->GetCellAtId(cell, corners);
      for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
      {
        used[static_cast<size_t>(corners->GetId(k))] = 1;
      }
    }
  }
  std::vector<vtkIdType> unused;
  for (size_t i = 0; i < used.size(); ++i)
  {
    if (!used[i])
    {
      unused.push_back(static_cast<vtkIdType>(i));
    }
  }
  return unused;
}

/// Whether an array shows directions, or how certain they are.
bool IsOfTheField(const char* name, int degree)
{
  const std::string wanted = name ? name : "";
  for (int k = 0; k < degree; ++k)
  {
    if (wanted == DirectionName(k))
    {
      return true;
    }
  }
  return wanted == "RepresentationMagnitude" || wanted == "ConstraintDirection" ||
    wanted == "ConstraintKind" || wanted == "PrincipalDirection0" ||
    wanted == "PrincipalDirection1";
}

template <typename ArrayT>
bool AddPointArrays(const Result& field, vtkPointData* data, const ProgressFunction& progress)
{
  using Value = typename ArrayT::ValueType;
  const size_t points = field.Representation.size();
  auto magnitude = MakeArray<ArrayT>("RepresentationMagnitude", 1, points);
  data->AddArray(magnitude);
  AddVectors<ArrayT>("ConstraintDirection", field.ConstraintDirection, data);
  const CurvatureReport none;
  const CurvatureReport& curvature = field.Curvature ? *field.Curvature : none;
  AddVectors<ArrayT>("PrincipalDirection0", curvature.PrincipalDirection0, data);
  AddVectors<ArrayT>("PrincipalDirection1", curvature.PrincipalDirection1, data);
  AddScalars<ArrayT>("MeanCurvature", curvature.Mean, data);
  AddScalars<ArrayT>("GaussianCurvature", curvature.Gaussian, data);

  Value* const moduli = magnitude->GetPointer(0);
  std::vector<Value*> tuples;
  for (int k = 0; k < field.Degree; ++k)
  {
    auto array = MakeArray<ArrayT>(DirectionName(k).c_str(), 3, points);
    tuples.push_back(array->GetPointer(0));
    data->AddArray(array);
  }
  if (progress && !progress(0.5))
  {
    return false;
  }
  ParallelFor(static_cast<Index>(points), PieceSize,
    [&](Index begin, Index end)
    {
      std::vector<Vector3> directions(FewPoints * tuples.size());
      for (Index first = begin; first < end; first += FewPoints)
      {
        const Index last = std::min(end, first + FewPoints);
        field.Directions(first, last, directions.data());
        const Vector3* direction = directions.data();
        for (Index i = first; i < last; ++i)
        {
          moduli[i] = static_cast<Value>(Modulus(field.Representation[i]));
          for (Value* const values : tuples)
          {
            WriteVector(*direction++, values, i);
          }
        }
      }
    });
  // What an earlier run of higher degree left in the input is no part of this field.
  for (int k = field.Degree; k < MostDirections; ++k)
  {
    data->RemoveArray(DirectionName(k).c_str());
  }
  data->SetActiveVectors(DirectionName(0).c_str());
  return true;
}

void AddCellArrays(const TriangulatedPolyData& input, const Result& field, vtkPolyData* output)
{
  auto index = MakeArray<vtkIntArray>(
    "SingularityIndex", 1, static_cast<size_t>(output->GetNumberOfCells()));
  int* const indices = index->GetPointer(0);
  const std::vector<int>& given = field.SingularityIndex;
  if (input.CellOfTriangle.empty() && input.FirstCell == 0 &&
    given.size() == static_cast<size_t>(output->GetNumberOfCells()))
  {
    ParallelFor(static_cast<Index>(given.size()), PieceSize,
      [&](Index begin, Index end)
      { std::copy(given.begin() + begin, given.begin() + end, indices + begin); });
  }
  else
  {
    index->FillValue(0);
    for (size_t t = 0; t < given.size(); ++t)
    {
      indices[input.Cell(t)] += given[t];
    }
  }
  output->GetCellData()->AddArray(index);
}

template <typename ArrayT, typename Member>
void AddComponentArray(
  const char* name, const Result& field, Member ComponentReport::*member, vtkFieldData* data)
{
  auto array = MakeArray<ArrayT>(name, 1, field.Components.size());
  for (size_t c = 0; c < field.Components.size(); ++c)
  {
    array->SetValue(static_cast<vtkIdType>(c),
      static_cast<typename ArrayT::ValueType>(field.Components[c].*member));
  }
  data->AddArray(array);
}

/// The normal of a triangle on the side of its vertices' normals, which a triangle wound against
/// its neighbours or one without area does not give by itself.
Vector3 OutwardNormal(const Surface& mesh, size_t t, const Result& field)
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

bool AddFieldArrays(const TriangulatedPolyData& input, const Result& field, vtkPolyData* output,
  const ProgressFunction& progress)
{
  output->GetPointData()->RemoveArray("OriginalPointIds");
  std::vector<vtkIdType> unused;
  if (!field.SplitTriangles.empty())
  {
    SplitPoints(field.OriginalPoint, output);
    unused = SplitCells(input, field, output);
  }
  AddScalars<vtkIntArray>("ConstraintKind", field.Constraint, output->GetPointData());
  const bool areDouble =
    output->GetPoints() && output->GetPoints()->GetDataType() == VTK_DOUBLE;
  vtkPointData* data = output->GetPointData();
  if (!(areDouble ? AddPointArrays<vtkDoubleArray>(field, data, progress)
                  : AddPointArrays<vtkFloatArray>(field, data, progress)))
  {
    return false;
  }
  // Where a cell was torn apart, some of its points are no longer used: they show no direction.
  for (const vtkIdType point : unused)
  {
    for (int k = 0; k < output->GetPointData()->GetNumberOfArrays(); ++k)
    {
      vtkDataArray* array = output->GetPointData()->GetArray(k);
      if (array && IsOfTheField(array->GetName(), field.Degree))
      {
        for (int c = 0; c < array->GetNumberOfComponents(); ++c)
        {
          array->SetComponent(point, c, 0.0);
        }
      }
    }
  }
  AddCellArrays(input, field, output);

  vtkFieldData* report = output->GetFieldData();
  AddComponentArray<vtkDoubleArray>("Eigenvalue", field, &ComponentReport::Eigenvalue, report);
  AddComponentArray<vtkDoubleArray>("Residual", field, &ComponentReport::Residual, report);
  AddComponentArray<vtkIntArray>("Iterations", field, &ComponentReport::Iterations, report);
  AddComponentArray<vtkIntArray>("SolverUsed", field, &ComponentReport::SolverUsed, report);
  AddComponentArray<vtkIntArray>(
    "EulerCharacteristic", field, &ComponentReport::EulerCharacteristic, report);
  AddComponentArray<vtkIntArray>("IndexSum", field, &ComponentReport::IndexSum, report);
  AddComponentArray<vtkDoubleArray>("Lambda", field, &ComponentReport::Lambda, report);
  AddComponentArray<vtkDoubleArray>(
    "SmoothnessEnergy", field, &ComponentReport::SmoothnessEnergy, report);
  AddComponentArray<vtkDoubleArray>(
    "SystemResidual", field, &ComponentReport::SystemResidual, report);
  return true;
}

void AddReport(
  const Repairs& repaired, const std::vector<std::string>& warnings, vtkFieldData* data)
{
  const std::pair<const char*, Index> counts[] = {
    { "CollapsedTriangles", repaired.CollapsedTriangles },
    { "DuplicateTriangles", repaired.DuplicateTriangles },
    { "ReversedTriangles", repaired.ReversedTriangles },
    { "DegenerateTriangles", repaired.DegenerateTriangles },
    { "NonManifoldEdges", repaired.NonManifoldEdges },
    { "NonManifoldPoints", repaired.NonManifoldPoints },
    { "NonOrientableComponents", repaired.NonOrientableComponents },
  };
  auto repairs = MakeArray<vtkIntArray>("Repairs", static_cast<int>(std::size(counts)), 1);
  for (size_t k = 0; k < std::size(counts); ++k)
  {
    repairs->SetComponentName(static_cast<vtkIdType>(k), counts[k].first);
    repairs->SetTypedComponent(0, static_cast<int>(k), counts[k].second);
  }
  data->AddArray(repairs);

  data->RemoveArray("Warnings");
  if (!warnings.empty())
  {
    vtkNew<vtkStringArray> texts;
    texts->SetName("Warnings");
    for (const std::string& warning : warnings)
    {
      texts->InsertNextValue(warning);
    }
    data->AddArray(texts);
  }
}

void MakeSingularities(const TriangulatedPolyData& input, const Result& field, int pointDataType,
  vtkPolyData* singularities)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(pointDataType == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT);
  vtkNew<vtkCellArray> verts;
  auto index = MakeArray<vtkIntArray>("SingularityIndex", 1, 0);
  auto fraction = MakeArray<vtkDoubleArray>("Index", 1, 0);
  auto cells = MakeArray<vtkIdTypeArray>("CellId", 1, 0);
  auto normals = MakeArray<vtkFloatArray>("Normals", 3, 0);

  const Surface& mesh = input.Mesh;
  for (size_t t = 0; t < field.SingularityIndex.size(); ++t)
  {
    if (field.SingularityIndex[t] == 0 || (!mesh.Ghost.empty() && mesh.Ghost[t] != 0))
    {
      continue;
    }
    const Triangle& triangle = mesh.Triangles[t];
    // Divided first: the sum of the largest coordinates would overflow.
    const Vector3 centroid = mesh.Points[triangle[0]] / 3.0 + mesh.Points[triangle[1]] / 3.0 +
      mesh.Points[triangle[2]] / 3.0;
    const vtkIdType id = points->InsertNextPoint(centroid.data());
    verts->InsertNextCell(1, &id);
    index->InsertNextValue(field.SingularityIndex[t]);
    fraction->InsertNextValue(static_cast<double>(field.SingularityIndex[t]) / field.Degree);
    cells->InsertNextValue(input.Cell(t));
    normals->InsertNextTuple(OutwardNormal(mesh, t, field).data());
  }

  singularities->SetPoints(points);
  singularities->SetVerts(verts);
  vtkPointData* data = singularities->GetPointData();
  data->AddArray(index);
  data->AddArray(fraction);
  data->AddArray(cells);
  data->SetNormals(normals);
}
}
