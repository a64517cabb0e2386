// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Tensors/TensorArrays.h"

#include "Conversion/Input/FieldArrays.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace DirectionFields
{
namespace
{
constexpr int Symmetric = 6;
constexpr int Full = 9;

vtkDataArray* RequireTensors(vtkPolyData* polyData, bool areOfCells, const std::string& name)
{
  vtkDataSetAttributes* const data = areOfCells
    ? static_cast<vtkDataSetAttributes*>(polyData->GetCellData())
    : polyData->GetPointData();
  vtkDataArray* const array = data->GetArray(name.c_str());
  const int components = array ? array->GetNumberOfComponents() : 0;
  if (components == Symmetric || components == Full)
  {
    return array;
  }
  const std::string kind = areOfCells ? "cell" : "point";
  const std::string choose =
    "Choose a point or cell array of 6 or 9 components as Tensor Array (SetTensorArray): ";
  if (name.empty())
  {
    throw std::invalid_argument(choose + "there is none.");
  }
  if (!array)
  {
    throw std::invalid_argument(choose + "there is no " + kind + " array \"" + name + "\".");
  }
  throw std::invalid_argument(choose + "the " + kind + " array \"" + name + "\" has " +
    std::to_string(components) + (components == 1 ? " component" : " components") +
    (components == 3 ? ", for which there is Alignment Point Vectors." : "."));
}

template <typename ArrayT>
void AddArrays(const TensorGuidance& guidance, vtkPointData* data)
{
  using Value = typename ArrayT::ValueType;
  data->AddArray(MakeScalars<ArrayT>(ArrayNames::MajorValue, guidance.MajorValue));
  data->AddArray(MakeScalars<ArrayT>(ArrayNames::MinorValue, guidance.MinorValue));
  data->AddArray(MakeScalars<ArrayT>(ArrayNames::TensorAnisotropy, guidance.Anisotropy));
  const std::size_t points = guidance.Tangential.size();
  auto tensors = MakeArray<ArrayT>(ArrayNames::SurfaceTensor, Symmetric, points);
  const char* const names[] = { "XX", "YY", "ZZ", "XY", "YZ", "XZ" };
  for (int c = 0; c < Symmetric; ++c)
  {
    tensors->SetComponentName(c, names[c]);
  }
  Value* const values = tensors->GetPointer(0);
  ForEachPieceOfTuples(points,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        for (int c = 0; c < Symmetric; ++c)
        {
          values[Symmetric * i + c] = Narrowed<Value>(guidance.Tangential[i][c]);
        }
      }
    });
  data->AddArray(tensors);
}
}

SurfaceTensors PolyDataToTensors(vtkPolyData* polyData, const TriangulatedPolyData& surface,
  bool areOfCells, const std::string& name)
{
  vtkDataArray* const array = RequireTensors(polyData, areOfCells, name);
  const auto components = static_cast<std::size_t>(array->GetNumberOfComponents());
  SurfaceTensors tensors;
  tensors.Components = static_cast<int>(components);
  tensors.AtTriangles = areOfCells;
  const std::size_t places =
    areOfCells ? surface.Mesh.Triangles.size() : surface.Mesh.Points.size();
  tensors.Values.resize(places * components);
  for (std::size_t i = 0; i < places; ++i)
  {
    double* const values = &tensors.Values[components * i];
    const vtkIdType tuple = areOfCells ? surface.Cell(i) : static_cast<vtkIdType>(i);
    array->GetTuple(tuple, values);
    // The computation knows the triangles of cells only.
    if (areOfCells &&
      !std::all_of(values, values + components, [](double value) { return std::isfinite(value); }))
    {
      throw std::invalid_argument("Fill in or leave out the tensors that are not finite: that of "
                                  "cell " +
        std::to_string(tuple) + " is not.");
    }
  }
  return tensors;
}

void AddTensorArrays(const TensorGuidance& guidance, int type, vtkPolyData* output)
{
  if (type == VTK_DOUBLE)
  {
    AddArrays<vtkDoubleArray>(guidance, output->GetPointData());
  }
  else
  {
    AddArrays<vtkFloatArray>(guidance, output->GetPointData());
  }
}

void RemoveTensorArrays(vtkPointData* data)
{
  for (const char* const name : { ArrayNames::MajorValue, ArrayNames::MinorValue,
         ArrayNames::TensorAnisotropy, ArrayNames::SurfaceTensor })
  {
    data->RemoveArray(name);
  }
}

TensorsAlong::TensorsAlong(vtkPolyData* field)
  : Array(field->GetPointData()->GetArray(ArrayNames::SurfaceTensor))
{
  if (this->Array && this->Array->GetNumberOfComponents() != Symmetric)
  {
    this->Array = nullptr;
  }
}

double TensorsAlong::At(vtkIdType point, const Vector3& d) const
{
  std::array<double, Symmetric> t;
  this->Array->GetTuple(point, t.data());
  return t[0] * d.x() * d.x() + t[1] * d.y() * d.y() + t[2] * d.z() * d.z() +
    2.0 * (t[3] * d.x() * d.y() + t[4] * d.y() * d.z() + t[5] * d.x() * d.z());
}
}
